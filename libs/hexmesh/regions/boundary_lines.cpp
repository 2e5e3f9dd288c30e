#include "hexmesh/regions/boundary_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/topology/disjoint_sets.h"

namespace orbicube::hexmesh {
namespace {

constexpr double sharp_line = 35;  // degrees, of the dihedral angle and of bends of lines

Vector3 quad_normal(std::span<const Vector3> p, const Quad& q) {
  return (p[q[2]] - p[q[0]]).cross(p[q[3]] - p[q[1]]).stableNormalized();
}

const double cosine_of_sharp_line = std::cos(sharp_line * std::numbers::pi / 180);

}  // namespace

BoundaryLines::BoundaryLines(const HexMesh& mesh, const base::Host& host)
    : host_(host),
      mesh_(mesh),
      positions_(mesh.positions.begin(), mesh.positions.end(), host.memory),
      patch_of_face_(6 * mesh.hexahedra.size(), no_index, host.memory),
      patch_(host.memory),
      special_(mesh.positions.size(), 0, host.memory) {
  const BoundaryQuads quads(mesh.hexahedra, mesh.positions.size(), host);
  find_patches(quads);
  find_lines(quads);
}

bool BoundaryLines::is_sharp(const BoundaryQuads& quads, Index half_edge) const {
  const Quad &a = quads.quads()[half_edge / 4], &b = quads.quads()[quads.opposite(half_edge) / 4];
  return quad_normal(positions_, a).dot(quad_normal(positions_, b)) < cosine_of_sharp_line;
}

std::size_t BoundaryLines::face_of(const Hexahedron& h, const Quad& quad) {
  for (std::size_t f = 0; f < 6; ++f) {
    const auto& corners = hexahedron_faces[f];
    if (std::all_of(corners.begin(), corners.end(),
                    [&](std::uint8_t k) { return std::find(quad.begin(), quad.end(), h[k]) != quad.end(); }))
      return f;
  }
  return 0;
}

void BoundaryLines::find_patches(const BoundaryQuads& quads) {
  const std::size_t count = quads.quads().size();
  mesh::DisjointSets sets(count, host_.memory);
  for (Index h = 0; h < 4 * count; ++h) {
    if (h < quads.opposite(h) && !is_sharp(quads, h)) sets.unite(h / 4, quads.opposite(h) / 4);
  }
  for (Index q = 0; q < count; ++q) {
    patch_.push_back(sets.find(q));
    Quad key = quads.quads()[q];
    std::sort(key.begin(), key.end());
    patch_of_quad_[key] = patch_.back();
    const Index owner = quads.owner(q);
    patch_of_face_[6 * std::size_t{owner} + face_of(mesh_.hexahedra[owner], quads.quads()[q])] = patch_.back();
  }
}

void BoundaryLines::find_lines(const BoundaryQuads& quads) {
  Array<std::array<Index, 2>> neighbors(positions_.size(), {no_index, no_index}, host_.memory);
  for (Index h = 0; h < 4 * quads.quads().size(); ++h) {
    const Index o = quads.opposite(h);
    if (h > o || !is_sharp(quads, h)) continue;
    const Index from = quads.start(h), to = quads.end(h);
    const auto patches = std::minmax(patch_[h / 4], patch_[o / 4]);
    if (patches.first == patches.second) {
      special_[from] = special_[to] = 1;
      continue;
    }
    lines_.try_emplace(patches, host_.memory).first->second.push_back({from, to});
    for (const auto& [v, w] : {std::pair(from, to), std::pair(to, from)}) {
      auto& [first, second] = neighbors[v];
      (first == no_index ? first : second) = w;
    }
  }
  for (Index v = 0; v < neighbors.size(); ++v) {
    const auto [a, b] = neighbors[v];
    if (a == no_index || b == no_index) continue;
    const Vector3 in = positions_[v] - positions_[a], out = positions_[b] - positions_[v];
    if (in.dot(out) < cosine_of_sharp_line * in.norm() * out.norm()) special_[v] = 1;
  }
}

Index BoundaryLines::patch_of(const Quad& quad) const {
  Quad key = quad;
  std::sort(key.begin(), key.end());
  const auto found = patch_of_quad_.find(key);
  return found == patch_of_quad_.end() ? no_index : found->second;
}

Array<Index> BoundaryLines::patches_of(const BoundaryQuads& quads, const Sheets& sheets) const {
  const std::size_t count = quads.quads().size();
  Array<Index> patches(count, no_index, host_.memory);
  for (Index q = 0; q < count; ++q) {
    const Index owner = quads.owner(q);
    patches[q] = patch_of(quads.quads()[q]);  // of a sheet on a patch, too
    if (patches[q] == no_index && owner < sheets.first)
      patches[q] = patch_of_face_[6 * std::size_t{owner} + face_of(mesh_.hexahedra[owner], quads.quads()[q])];
  }
  // A quad of a sheet continues the one beyond the edge between its copies, the lower side of its hexahedron; one of a
  // ring that beyond the upper side, too.
  for (bool changed = true; changed;) {
    changed = false;
    for (Index q = 0; q < count; ++q) {
      if (patches[q] != no_index) continue;
      const Hexahedron& h = mesh_.hexahedra[quads.owner(q)];
      const auto is_copy = [&](Index v) { return std::find(h.begin(), h.begin() + 4, v) != h.begin() + 4; };
      for (Index e = 4 * q; e < 4 * q + 4; ++e) {
        const bool lower = is_copy(quads.start(e)) && is_copy(quads.end(e));
        const bool upper = !is_copy(quads.start(e)) && !is_copy(quads.end(e));
        if (lower || (upper && quads.owner(q) >= sheets.second)) patches[q] = patches[quads.opposite(e) / 4];
        if (patches[q] != no_index) break;
      }
      changed = changed || patches[q] != no_index;
    }
  }
  return patches;
}

BoundaryLines::Point BoundaryLines::nearest(std::pair<Index, Index> patches, const Vector3& p) const {
  Point best;
  const auto found = lines_.find(patches);
  if (found == lines_.end()) return best;
  for (const auto& [a, b] : found->second) {
    const Vector3 along = positions_[b] - positions_[a];
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((p - positions_[a]).dot(along) / length, 0.0, 1.0) : 0;
    const Vector3 at = positions_[a] + t * along;
    const double distance = (at - p).norm();
    if (distance < best.distance) best = {at, along.stableNormalized(), distance};
  }
  return best;
}

}  // namespace orbicube::hexmesh
