// Moves singular curves edge by edge to where they cost less: smoothing leaves them on the edges where they are, and
// diffusion moves them as wholes. For each singular edge and each face at it, the matching that makes the edge regular
// is put into the face, so that the curve goes along the face's other two edges or, where it does so already, leaves
// them; the frames around are relaxed, first with that matching, then freely, and what came out is kept if it has less
// energy. So are both faces between two edges of a curve that follow each other and a further vertex, over which the
// curve's vertex moves.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>

#include "base/grouping.h"
#include "frame_field/graph/constraints.h"
#include "frame_field/singularities/singularities.h"
#include "frame_field/smoothing/region_relaxation.h"

namespace orbicube::frame_field {

class CurveSearch {
 public:
  // All arguments must outlive it. Tetrahedra are numbered as the graph's nodes are. 50 bytes a tetrahedron besides the
  // rings.
  CurveSearch(const DualGraph& graph, const Constraints& constraints, const mesh::TetrahedralConnectivity& connectivity,
              const mesh::EdgeRings& rings, const base::Host& host);

  // `field` satisfies the constraints, and does so afterwards. Returns by how much the energy fell, as
  // far as the frames around tell. Passes end when one moves nothing.
  double run(std::uint32_t max_passes, Field& field);

 private:
  struct Change {
    Index face;
    std::uint8_t matching;
  };
  std::uint8_t rotation_of(std::size_t ring) const;
  std::uint8_t regular_matching(std::size_t ring, std::size_t place) const;
  bool move_edge(std::size_t ring, Field& field);
  bool move_vertex(std::size_t ring, std::size_t next, Field& field);
  bool try_changes(std::span<const Change> changes, Field& field);
  void collect_patch(std::span<const Change> changes);
  std::uint32_t last_change() const;
  void set(const Change& change);
  double patch_energy(const Field& field) const;

  const DualGraph& graph_;
  const Constraints& constraints_;
  const mesh::TetrahedralConnectivity& connectivity_;
  const mesh::EdgeRings& rings_;
  const base::Host& host_;
  const RegionRelaxation relaxation_;
  base::Groups<Index, Index> at_vertex_;  // tetrahedra
  Array<std::uint8_t> matchings_;
  Array<std::uint32_t> stamp_;  // of the last patch that a tetrahedron was in
  std::uint32_t patches_ = 0;
  Array<Index> patch_;
  Array<Quaternion> saved_;
  double gain_ = 0;
  // How many moves were accepted, after which of them a tetrahedron has its frame, and after how many a move failed.
  std::uint32_t accepted_ = 0;
  Array<std::uint32_t> changed_;
  std::pmr::map<std::array<std::uint64_t, 2>, std::uint32_t> failed_;
};

}  // namespace orbicube::frame_field
