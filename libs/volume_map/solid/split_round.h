// One round of splits of tetrahedra, each of which is split at most once: a vertex is put on an edge, a face or into a
// tetrahedron, and takes the place of one of their corners at a time.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "base/host.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/tetrahedral_connectivity.h"
#include "quaternion/quaternion.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

class SplitRound {
 public:
  // With frames, one a tetrahedron, parts have that of the whole. All arguments must outlive it.
  SplitRound(Array<Vector3>& positions, Array<Tetrahedron>& tetrahedra, Array<quaternion::Quaternion>* frames,
             const base::Host& host)
      : positions_(positions),
        tetrahedra_(tetrahedra),
        frames_(frames),
        taken_(tetrahedra.size(), 0, host.memory),
        around_(host.memory) {}

  bool free(Index tetrahedron) const { return taken_[tetrahedron] == 0; }
  std::size_t splits() const { return splits_; }

  // Puts a vertex at `place`, in each of the tetrahedra `around`, which must be free, in the place of one of `corners`
  // at a time. Nothing is done unless all that come from it are positive, by exact signs.
  template <std::size_t corner_count>
  void split(std::span<const Index> around, const std::array<Index, corner_count>& corners, const Vector3& place) {
    const auto added = static_cast<Index>(positions_.size());
    positions_.push_back(place);
    const auto replaced = [&](Index t, Index corner) {
      Tetrahedron part = tetrahedra_[t];
      std::replace(part.begin(), part.end(), corner, added);
      return part;
    };
    for (const Index t : around) {
      for (const Index corner : corners) {
        const auto [a, b, c, d] = replaced(t, corner);
        if (mesh::orientation_3d(positions_[a], positions_[b], positions_[c], positions_[d]) > 0) continue;
        positions_.pop_back();
        return;
      }
    }
    for (const Index t : around) {
      taken_[t] = 1;
      for (std::size_t k = 1; k < corner_count; ++k) {
        tetrahedra_.push_back(replaced(t, corners[k]));
        if (frames_ == nullptr) continue;
        const quaternion::Quaternion frame = (*frames_)[t];
        frames_->push_back(frame);
      }
      tetrahedra_[t] = replaced(t, corners[0]);
    }
    ++splits_;
  }

  // The edge of a ring at its middle, if all tetrahedra around it are free.
  void halve(const mesh::EdgeRings& rings, std::size_t ring) {
    around_.clear();
    for (const Index face : rings.faces(ring)) {
      around_.push_back(mesh::TetrahedralConnectivity::tetrahedron_of(face));
      if (!free(around_.back())) return;
    }
    const auto& [a, b] = rings.vertices(ring);
    split(around_, std::array{a, b}, 0.5 * (positions_[a] + positions_[b]));
  }

  // The edges of all rings for which `target` is true.
  template <class Target>
  void halve_all(const mesh::EdgeRings& rings, const Target& target) {
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
      if (target(ring)) halve(rings, ring);
    }
  }

  // Inner faces, or whole tetrahedra, with all corners held, at their middle. `now` is what `connectivity` is of.
  void split_held_faces(const mesh::TetrahedralConnectivity& connectivity, std::span<const Tetrahedron> now,
                        std::span<const std::uint8_t> held) {
    for (Index t = 0; t < now.size(); ++t) {
      for (Index corner = 0; corner < 4 && count_of(now[t], held) >= 3; ++corner) {
        const Index other = connectivity.neighbor(t, corner);
        if (other == no_index || !free(t) || !free(other)) continue;
        const mesh::Triangle face = connectivity.vertices(4 * t + corner);
        if (count_of(face, held) < 3) continue;
        around_.assign({t, other});
        split(around_, face, middle_of(face));
      }
    }
  }
  void split_held_cells(std::span<const Tetrahedron> now, std::span<const std::uint8_t> held) {
    for (Index t = 0; t < now.size(); ++t) {
      if (!free(t) || count_of(now[t], held) < 4) continue;
      around_.assign(1, t);
      split(around_, now[t], middle_of(now[t]));
    }
  }

 private:
  template <std::size_t count>
  static std::size_t count_of(const std::array<Index, count>& corners, std::span<const std::uint8_t> held) {
    return static_cast<std::size_t>(
        std::count_if(corners.begin(), corners.end(), [&](Index v) { return held[v] != 0; }));
  }
  template <std::size_t count>
  Vector3 middle_of(const std::array<Index, count>& corners) const {
    Vector3 mean = Vector3::Zero();
    for (const Index v : corners)
      mean += positions_[v] / static_cast<double>(count);
    return mean;
  }

  Array<Vector3>& positions_;
  Array<Tetrahedron>& tetrahedra_;
  Array<quaternion::Quaternion>* frames_;
  Array<std::uint8_t> taken_;
  Array<Index> around_;
  std::size_t splits_ = 0;
};

}  // namespace orbicube::volume_map
