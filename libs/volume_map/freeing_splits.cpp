#include "volume_map/freeing_splits.h"

#include "mesh/predicates.h"
#include "mesh/tetrahedral_connectivity.h"

namespace orbicube::volume_map {
namespace {

constexpr int most_rounds = 60;

// The tetrahedra of one round: which have been taken, and what takes their place.
class Round {
 public:
  Round(Array<Vector3>& positions, Array<Tetrahedron>& tetrahedra, const base::Host& host)
      : positions_(positions), tetrahedra_(tetrahedra), taken_(tetrahedra.size(), 0, host.memory) {}

  bool free(Index tetrahedron) const { return taken_[tetrahedron] == 0; }
  std::size_t splits() const { return splits_; }

  // Puts a vertex at `place`, in each of the tetrahedra `around` in the place of one of `corners` at a time. Answers
  // whether all that come from it are positive; otherwise nothing is done.
  template <std::size_t corner_count>
  bool split(std::span<const Index> around, const std::array<Index, corner_count>& corners, const Vector3& place) {
    const auto added = static_cast<Index>(positions_.size());
    positions_.push_back(place);
    const auto replaced = [&](Index t, Index corner) {
      Tetrahedron part = tetrahedra_[t];
      for (Index& v : part) {
        if (v == corner) v = added;
      }
      return part;
    };
    for (const Index t : around) {
      for (const Index corner : corners) {
        const Tetrahedron part = replaced(t, corner);
        if (mesh::orientation_3d(positions_[part[0]], positions_[part[1]], positions_[part[2]], positions_[part[3]]) >
            0)
          continue;
        positions_.pop_back();
        return false;
      }
    }
    for (const Index t : around) {
      taken_[t] = 1;
      for (std::size_t k = 1; k < corner_count; ++k)
        tetrahedra_.push_back(replaced(t, corners[k]));
      tetrahedra_[t] = replaced(t, corners[0]);
    }
    ++splits_;
    return true;
  }

 private:
  Array<Vector3>& positions_;
  Array<Tetrahedron>& tetrahedra_;
  Array<std::uint8_t> taken_;
  std::size_t splits_ = 0;
};

}  // namespace

std::size_t split_edges_at(Array<Vector3>& positions, Array<Tetrahedron>& tetrahedra,
                           std::span<const std::uint8_t> marked, const base::Host& host) {
  const std::size_t before = positions.size();
  Array<Index> around(host.memory);
  for (int k = 0; k < most_rounds; ++k) {
    const Array<Tetrahedron> now(tetrahedra, host.memory);
    const mesh::TetrahedralConnectivity connectivity(positions.size(), now, host);
    const mesh::EdgeRings rings(connectivity, host);
    Round round(positions, tetrahedra, host);
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
      const auto& [a, b] = rings.vertices(ring);
      if (rings.on_boundary(ring) || a >= before || b >= before || (marked[a] == 0 && marked[b] == 0)) continue;
      around.clear();
      bool clear = true;
      for (const Index face : rings.faces(ring)) {
        around.push_back(mesh::TetrahedralConnectivity::tetrahedron_of(face));
        clear = clear && round.free(around.back());
      }
      if (clear) round.split(around, std::array{a, b}, 0.5 * (positions[a] + positions[b]));
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
      Round round(positions, tetrahedra, host);
      if (what == What::edges) {
        const mesh::EdgeRings rings(connectivity, host);
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
          const auto& [a, b] = rings.vertices(ring);
          if (rings.on_boundary(ring) || outer[a] == 0 || outer[b] == 0) continue;
          around.clear();
          bool clear = true;
          for (const Index face : rings.faces(ring)) {
            around.push_back(mesh::TetrahedralConnectivity::tetrahedron_of(face));
            clear = clear && round.free(around.back());
          }
          if (clear) round.split(around, std::array{a, b}, 0.5 * (positions[a] + positions[b]));
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
