#include "volume_map/freeing_splits.h"

#include "mesh/tetrahedral_connectivity.h"
#include "volume_map/split_round.h"

namespace orbicube::volume_map {
namespace {

constexpr int most_rounds = 60;

}  // namespace

std::size_t split_edges_at(Array<Vector3>& positions, Array<Tetrahedron>& tetrahedra,
                           std::span<const std::uint8_t> marked, const base::Host& host) {
  const std::size_t before = positions.size();
  for (int k = 0; k < most_rounds; ++k) {
    const Array<Tetrahedron> now(tetrahedra, host.memory);
    const mesh::TetrahedralConnectivity connectivity(positions.size(), now, host);
    const mesh::EdgeRings rings(connectivity, host);
    SplitRound round(positions, tetrahedra, nullptr, host);
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
      const auto& [a, b] = rings.vertices(ring);
      if (rings.on_boundary(ring) || a >= before || b >= before || (marked[a] == 0 && marked[b] == 0)) continue;
      round.halve(rings, ring);
    }
    if (round.splits() == 0) break;
  }
  return positions.size() - before;
}

std::size_t split_for_freedom(Array<Vector3>& positions, Array<Tetrahedron>& tetrahedra, const base::Host& host) {
  const std::size_t before = positions.size();
  Array<Index> around(host.memory);
  enum class What { edges, faces, cells };
  for (const What what : {What::edges, What::faces, What::cells}) {
    for (int k = 0; k < most_rounds; ++k) {
      // The connectivity keeps a view of what the round changes, so it gets a copy.
      const Array<Tetrahedron> now(tetrahedra, host.memory);
      const mesh::TetrahedralConnectivity connectivity(positions.size(), now, host);
      const Array<std::uint8_t> outer = connectivity.boundary_vertices(host.memory);
      SplitRound round(positions, tetrahedra, nullptr, host);
      if (what == What::edges) {
        const mesh::EdgeRings rings(connectivity, host);
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
          const auto& [a, b] = rings.vertices(ring);
          if (!rings.on_boundary(ring) && outer[a] != 0 && outer[b] != 0) round.halve(rings, ring);
        }
      } else {
        for (Index t = 0; t < now.size(); ++t) {
          if (!round.free(t)) continue;
          std::size_t outer_corners = 0;
          for (const Index v : now[t])
            outer_corners += outer[v];
          if (outer_corners < 3) continue;
          if (what == What::cells) {
            if (outer_corners < 4) continue;
            const auto& [a, b, c, d] = now[t];
            around.assign(1, t);
            round.split(around, now[t], 0.25 * (positions[a] + positions[b] + positions[c] + positions[d]));
            continue;
          }
          for (Index corner = 0; corner < 4; ++corner) {
            const Index other = connectivity.neighbour(t, corner);
            if (other == no_index || !round.free(t) || !round.free(other)) continue;
            const mesh::Triangle face = connectivity.vertices(4 * t + corner);
            if (outer[face[0]] == 0 || outer[face[1]] == 0 || outer[face[2]] == 0) continue;
            around.assign({t, other});
            round.split(around, face, (positions[face[0]] + positions[face[1]] + positions[face[2]]) / 3);
          }
        }
      }
      if (round.splits() == 0) break;
    }
  }
  return positions.size() - before;
}

}  // namespace orbicube::volume_map
