// Smooths the frames of a small part of a field and leaves all others as they are: Gauss and Seidel's sweeps over the
// tetrahedra, each frame becoming the mean of its neighbors' (the dissertation's section 6.3), with over-relaxation.
// With matchings given, the frames come as near as they can to a field that has these; without, matchings are the
// nearest of each moment.
#pragma once

#include <span>

#include "frame_field/graph/constraints.h"
#include "frame_field/graph/dual_graph.h"

namespace orbicube::frame_field {

class RegionRelaxation {
 public:
  // All arguments must outlive it. Tetrahedra are numbered as the graph's nodes are.
  RegionRelaxation(const DualGraph& graph, const Constraints& constraints,
                   const mesh::TetrahedralConnectivity& connectivity, const base::Host& host)
      : graph_(graph), constraints_(constraints), connectivity_(connectivity), host_(host) {}

  // `field` satisfies the constraints, and does so afterwards; `matchings` by face (singularities.h)
  // or empty. The same bits for the same order of `tetrahedra`. O(sweeps x tetrahedra).
  void relax(std::span<const Index> tetrahedra, std::span<const std::uint8_t> matchings, std::uint32_t sweeps,
             Field& field) const;

 private:
  Quaternion relaxed(Index tetrahedron, std::span<const std::uint8_t> matchings, const Field& field) const;

  const DualGraph& graph_;
  const Constraints& constraints_;
  const mesh::TetrahedralConnectivity& connectivity_;
  const base::Host& host_;
};

}  // namespace orbicube::frame_field
