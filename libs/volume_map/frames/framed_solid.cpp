#include "volume_map/frames/framed_solid.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/error.h"
#include "frame_field/singularities/singularities.h"
#include "mesh/topology/tetrahedral_connectivity.h"
#include "volume_map/frames/transitions.h"
#include "volume_map/solid/split_round.h"

namespace orbicube::volume_map {
namespace {

using Connectivity = mesh::TetrahedralConnectivity;

constexpr int max_widenings = 60;

// Not 0 for the rings of edges around which the matchings do not compose to the identity.
Array<std::uint8_t> singular_rings(const mesh::EdgeRings& rings, std::span<const std::uint8_t> matchings,
                                   const base::Host& host) {
  Array<std::uint8_t> result(rings.size(), 0, host.memory);
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    if (rings.on_boundary(ring)) continue;
    std::uint8_t passed = 0;
    for (const Index face : rings.faces(ring))
      passed = quaternion::cube_group.product[passed][matchings[face]];
    result[ring] = passed != 0;
  }
  return result;
}

}  // namespace

Array<std::uint8_t> label_boundary(std::span<const Vector3> positions, const Connectivity& connectivity,
                                   const mesh::EdgeRings& rings, std::span<const Quaternion> frames,
                                   std::span<const std::uint8_t> matchings, Array<std::uint8_t>& border,
                                   const base::Host& host) {
  const std::size_t faces = connectivity.face_count();
  Array<std::uint8_t> label(faces, 0, host.memory);
  for (Index face = 0; face < faces; ++face) {
    if (!connectivity.on_boundary(face)) continue;
    const auto [a, b, c] = connectivity.vertices(face);
    const Vector3 n = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    const quaternion::Vector v = quaternion::rotate(quaternion::conjugate(frames[face / 4]), {n[0], n[1], n[2]});
    const Vector3 own(v.x, v.y, v.z);
    Eigen::Index axis = 0;
    own.cwiseAbs().maxCoeff(&axis);
    label[face] = static_cast<std::uint8_t>(2 * axis + (own[axis] > 0));
  }
  border.assign(rings.size(), 0);
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    if (!rings.on_boundary(ring)) continue;
    const auto [first, last] = boundary_faces(connectivity, rings, ring);
    std::uint8_t rotation = 0;  // of coordinates, from the first chart to the last
    for (const Index face : rings.faces(ring)) {
      if (!connectivity.on_boundary(face))
        rotation = quaternion::cube_group.product[quaternion::cube_group.inverse[matchings[face]]][rotation];
    }
    const std::size_t axis = label[last] / 2;
    const bool outward = (Transition::sign(rotation, axis) > 0) == (label[first] % 2 == 1);
    border[ring] = Transition::source(rotation, axis) != label[first] / 2 || outward != (label[last] % 2 == 1);
  }
  return label;
}

std::array<Index, 2> boundary_faces(const Connectivity& connectivity, const mesh::EdgeRings& rings, std::size_t ring) {
  const auto& passed = rings.faces(ring);
  const auto [start, end] = rings.vertices(ring);
  // The one behind the first tetrahedron: it has the edge, and the way does not leave through it.
  for (Index face = 4 * (passed.front() / 4); face < 4 * (passed.front() / 4) + 4; ++face) {
    if (face == passed.front() || !connectivity.on_boundary(face)) continue;
    const auto v = connectivity.vertices(face);
    if (std::find(v.begin(), v.end(), start) != v.end() && std::find(v.begin(), v.end(), end) != v.end())
      return {face, passed.back()};
  }
  throw base::Error("internal", "a ring of the boundary begins inside");
}

void split_for_frames(FramedSolid& solid, const base::Host& host) {
  enum class What { borders, edges, faces, cells };
  for (const What what : {What::borders, What::edges, What::faces, What::cells}) {
    for (int k = 0; k < max_widenings; ++k) {
      // The connectivity keeps a view of what the round changes, so it gets a copy.
      const Array<Tetrahedron> now(solid.tetrahedra, host.memory);
      const Connectivity connectivity(solid.positions.size(), now, host);
      const mesh::EdgeRings rings(connectivity, host);
      const auto matchings = frame_field::matchings(connectivity, solid.frames, host);
      const auto singular = singular_rings(rings, matchings, host);
      Array<std::uint8_t> held = connectivity.boundary_vertices(host.memory);
      for (std::size_t ring = 0; ring < rings.size(); ++ring) {
        if (singular[ring] == 0) continue;
        for (const Index v : rings.vertices(ring))
          held[v] = 1;
      }
      Array<std::uint8_t> border(host.memory);
      if (what == What::borders) {
        label_boundary(solid.positions, connectivity, rings, solid.frames, matchings, border, host);
        std::fill(held.begin(), held.end(), std::uint8_t{0});
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
          if (border[ring] == 0 && singular[ring] == 0) continue;
          for (const Index v : rings.vertices(ring))
            held[v] = 1;
        }
      }
      SplitRound round(solid.positions, solid.tetrahedra, &solid.frames, host);
      const auto target = [&](std::size_t ring) {
        const auto& [a, b] = rings.vertices(ring);
        return rings.on_boundary(ring) == (what == What::borders) && singular[ring] == 0 && held[a] != 0 &&
               held[b] != 0 && (what != What::borders || border[ring] == 0);
      };
      if (what == What::faces)
        round.split_held_faces(connectivity, now, held);
      else if (what == What::cells)
        round.split_held_cells(now, held);
      else
        round.halve_all(rings, target);
      if (round.splits() == 0) break;
    }
  }
}

void split_around(FramedSolid& solid, std::span<const Index> tetrahedra, const base::Host& host) {
  const std::size_t before = solid.positions.size();
  Array<std::uint8_t> target(before, 0, host.memory);
  for (const Index t : tetrahedra) {
    for (const Index v : solid.tetrahedra[t])
      target[v] = 1;
  }
  for (int k = 0; k < max_widenings; ++k) {
    const Array<Tetrahedron> now(solid.tetrahedra, host.memory);
    const Connectivity connectivity(solid.positions.size(), now, host);
    const mesh::EdgeRings rings(connectivity, host);
    const auto singular = singular_rings(rings, frame_field::matchings(connectivity, solid.frames, host), host);
    SplitRound round(solid.positions, solid.tetrahedra, &solid.frames, host);
    round.halve_all(rings, [&](std::size_t ring) {
      const auto& [a, b] = rings.vertices(ring);
      return !rings.on_boundary(ring) && singular[ring] == 0 && a < before && b < before &&
             (target[a] != 0 || target[b] != 0);
    });
    if (round.splits() == 0) break;
  }
}

}  // namespace orbicube::volume_map
