#include "volume_map/solid/freeing_splits.h"

#include "mesh/topology/tetrahedral_connectivity.h"
#include "volume_map/solid/split_round.h"

namespace orbicube::volume_map {
namespace {

constexpr int max_rounds = 60;

}  // namespace

std::size_t split_edges_at(Array<Vector3>& positions, Array<Tetrahedron>& tetrahedra,
                           std::span<const std::uint8_t> marked, const base::Host& host) {
  const std::size_t before = positions.size();
  for (int k = 0; k < max_rounds; ++k) {
    const Array<Tetrahedron> now(tetrahedra, host.memory);
    const mesh::TetrahedralConnectivity connectivity(positions.size(), now, host);
    const mesh::EdgeRings rings(connectivity, host);
    SplitRound round(positions, tetrahedra, nullptr, host);
    round.halve_all(rings, [&](std::size_t ring) {
      const auto& [a, b] = rings.vertices(ring);
      return !rings.on_boundary(ring) && a < before && b < before && (marked[a] != 0 || marked[b] != 0);
    });
    if (round.splits() == 0) break;
  }
  return positions.size() - before;
}

std::size_t split_for_freedom(Array<Vector3>& positions, Array<Tetrahedron>& tetrahedra, const base::Host& host) {
  const std::size_t before = positions.size();
  enum class What { edges, faces, cells };
  for (const What what : {What::edges, What::faces, What::cells}) {
    for (int k = 0; k < max_rounds; ++k) {
      // The connectivity keeps a view of what the round changes, so it gets a copy.
      const Array<Tetrahedron> now(tetrahedra, host.memory);
      const mesh::TetrahedralConnectivity connectivity(positions.size(), now, host);
      const Array<std::uint8_t> outer = connectivity.boundary_vertices(host.memory);
      SplitRound round(positions, tetrahedra, nullptr, host);
      if (what == What::faces) {
        round.split_held_faces(connectivity, now, outer);
      } else if (what == What::cells) {
        round.split_held_cells(now, outer);
      } else {
        const mesh::EdgeRings rings(connectivity, host);
        round.halve_all(rings, [&](std::size_t ring) {
          const auto& [a, b] = rings.vertices(ring);
          return !rings.on_boundary(ring) && outer[a] != 0 && outer[b] != 0;
        });
      }
      if (round.splits() == 0) break;
    }
  }
  return positions.size() - before;
}

}  // namespace orbicube::volume_map
