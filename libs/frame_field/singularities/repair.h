// Changes a field where it is not that of a hexahedral mesh (faults.h): third turns and half turns are zipped apart,
// short loops and fragments collapse (zipping.h), and the frames around are smoothed to fit; or the frames around come
// in repeatedly from all sides.
//
// Each round takes what is wrong with some rings of tetrahedra about it, changes that in one of these ways, and keeps
// what is better, place by place: the number of edges and vertices that are not meshable must fall, or stay while a
// short loop or fragment goes. The energy may rise by that; both energies are returned. In the end all frames are
// smoothed together, but for places where that would bring faults back.
//
// The search about single axes is the one that the dissertation's last pages propose: it starts from the field of
// minimum structure, identity, and stays among fields whose frames turn about one axis along each curve, as far as it
// has reached them: a part is taken over from a smoother field only if that makes no edge or vertex unmeshable.
#pragma once

#include <cstdint>
#include <span>

#include "frame_field/graph/constraints.h"
#include "frame_field/graph/hierarchy.h"
#include "frame_field/singularities/faults.h"

namespace orbicube::frame_field {

struct RepairOutcome {
  Faults before, after;
  double energy_before = 0, energy_after = 0;
  std::uint32_t rounds = 0;
};

class Repair {
 public:
  // All arguments must outlive it. Tetrahedra are numbered as the graph's nodes are.
  Repair(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity, const DualGraph& graph,
         std::span<const CoarseGraph> hierarchy, Constraints& constraints, const base::Host& host);

  // `field` satisfies the constraints, and does so afterwards; never with more faults than before.
  // O(n) a round. Throws Error "cancelled".
  RepairOutcome repair(Field& field);
  // The same for the search about single axes, where `field` is the smoother one. Never with more unmeshable edges and
  // vertices than the repaired field from identity.
  RepairOutcome search_about_single_axes(Field& field);

 private:
  void zip_apart(std::span<const std::uint8_t> inside, const Structure& structure, Field& field) const;
  void refill(std::span<const std::uint8_t> inside, Field& field) const;
  bool keep_fewer(std::span<const std::uint8_t> inside, const Structure& before, const Structure& after,
                  const Field& candidate, Field& field) const;
  void take_smoother(const Field& candidate, Field& field) const;
  std::uint32_t rounds(Field& field);
  void smooth_all(double gain, Field& field);
  Array<Index> listed(std::span<const std::uint8_t> inside) const;
  Quaternion satisfying(Index tetrahedron, const Quaternion& frame) const;
  double energy_of(const Field& field) const;
  RepairOutcome outcome_of(const Field& before, const Field& after, std::uint32_t count) const;

  std::span<const Vector3> positions_;
  const mesh::TetrahedralConnectivity& connectivity_;
  const DualGraph& graph_;
  std::span<const CoarseGraph> hierarchy_;
  Constraints& constraints_;
  const base::Host& host_;
  const FaultFinder finder_;
};

}  // namespace orbicube::frame_field
