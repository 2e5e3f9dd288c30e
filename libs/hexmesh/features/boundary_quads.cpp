#include "hexmesh/features/boundary_quads.h"

#include <algorithm>

#include "base/error.h"
#include "base/grouping.h"

namespace orbicube::hexmesh {
namespace {

// A face of one hexahedron.
struct Side {
  Index hexahedron;
  std::uint8_t face;
};

Quad quad_of(const Hexahedron& h, std::uint8_t face) {
  const auto& f = hexahedron_faces[face];
  return {h[f[0]], h[f[1]], h[f[2]], h[f[3]]};
}

Quad sorted(Quad quad) {
  std::sort(quad.begin(), quad.end());
  return quad;
}

}  // namespace

Array<HexFace> faces_of(std::span<const Hexahedron> hexahedra, std::size_t vertices, std::span<const Index> chosen,
                        const base::Host& host) {
  const auto count = static_cast<Index>(chosen.empty() ? hexahedra.size() : chosen.size());
  const auto for_each = [&](const auto& visit) {
    for (Index i = 0; i < count; ++i) {
      if (i % 8192 == 0) host.report("features", 0, 0);
      const Index h = chosen.empty() ? i : chosen[i];
      for (std::uint8_t f = 0; f < 6; ++f) {
        const Quad quad = quad_of(hexahedra[h], f);
        visit(*std::min_element(quad.begin(), quad.end()), Side{h, f});
      }
    }
  };
  const base::Groups<Side, Index> sides(vertices, for_each, host.memory);
  Array<HexFace> faces(host.memory);
  faces.reserve(sides.all().size() / 2);
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto around = sides[v];
    const std::size_t begin = faces.size();
    for (const Side& side : around) {
      const Quad quad = quad_of(hexahedra[side.hexahedron], side.face);
      const Quad key = sorted(quad);
      const auto same = std::find_if(faces.begin() + static_cast<std::ptrdiff_t>(begin), faces.end(),
                                     [&](const HexFace& face) { return sorted(face.quad) == key; });
      if (same == faces.end())
        faces.push_back({quad, side.hexahedron, no_index});
      else
        same->second = side.hexahedron;
    }
  }
  return faces;
}

BoundaryQuads::BoundaryQuads(std::span<const Hexahedron> hexahedra, std::size_t vertices, const base::Host& host)
    : quads_(host.memory),
      owners_(host.memory),
      vertices_(host.memory),
      opposite_(host.memory),
      outgoing_(vertices, no_index, host.memory) {
  for (const HexFace& face : faces_of(hexahedra, vertices, {}, host)) {
    if (face.second != no_index) continue;
    quads_.push_back(face.quad);
    owners_.push_back(face.first);
  }
  const auto halves = static_cast<Index>(4 * quads_.size());
  const auto for_each = [&](const auto& visit) {
    for (Index h = 0; h < halves; ++h)
      visit(start(h), Index{h});
  };
  const base::Groups<Index, Index> from(vertices, for_each, host.memory);
  opposite_.assign(halves, no_index);
  for (Index h = 0; h < halves; ++h) {
    for (const Index other : from[end(h)]) {
      if (end(other) != start(h)) continue;
      if (opposite_[h] != no_index) throw base::Error("no-valid-result", "the boundary of the cells is no manifold");
      opposite_[h] = other;
    }
    if (opposite_[h] == no_index) throw base::Error("no-valid-result", "the boundary of the cells is not closed");
  }
  for (Index v = 0; v < vertices; ++v) {
    if (from[v].empty()) continue;
    vertices_.push_back(v);
    outgoing_[v] = from[v][0];
    std::size_t count = 0;
    for (Index h = outgoing_[v]; count == 0 || h != outgoing_[v]; h = turned(h))
      ++count;
    if (count != from[v].size()) throw base::Error("no-valid-result", "the boundary of the cells is no manifold");
  }
}

Index BoundaryQuads::find(Index from, Index to) const {
  Index found = no_index;
  for_each_outgoing(from, [&](Index h) {
    if (end(h) == to) found = h;
  });
  return found;
}

}  // namespace orbicube::hexmesh
