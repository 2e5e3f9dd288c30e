#include "polycube/outputs/atlas_texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace orbicube::polycube {
namespace {

using Texel = std::array<double, 2>;

std::array<Texel, 3> corners_of(const Atlas& atlas, const PatchGraph& graph, const SurfaceMap& map, Index t) {
  std::array<Texel, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = texel_of(atlas, graph, map.patches[t], map.polycube[map.triangles[t][k]]);
  return corners;
}

double cross(const Texel& a, const Texel& b, const Texel& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

// Areas of the triangles of a point with two corners, relative to that of the whole: negative outside.
Vector3 areas_at(const std::array<Texel, 3>& corners, const Texel& p) {
  const auto& [a, b, c] = corners;
  return Vector3(cross(b, c, p), cross(c, a, p), cross(a, b, p)) / cross(a, b, c);
}

Texel middle_of(Index texel, std::uint32_t size) {
  return {texel % size + 0.5, texel / size + 0.5};
}

// Texels whose middle is from `low` to `high`.
struct TexelRange {
  TexelRange(double low, double high, std::uint32_t size)
      : begin(static_cast<Index>(std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(size)))),
        end(static_cast<Index>(std::clamp(std::floor(high - 0.5) + 1, 0.0, static_cast<double>(size)))) {}
  Index begin, end;
};

void cover(const Atlas& atlas, const std::array<Texel, 3>& corners, Index t, AtlasTexels& texels) {
  const std::uint32_t size = atlas.options.size;
  const auto range = [&](std::size_t k) {
    const auto [low, high] = std::minmax({corners[0][k], corners[1][k], corners[2][k]});
    return TexelRange(low, high, size);
  };
  const TexelRange columns = range(0), rows = range(1);
  for (Index row = rows.begin; row < rows.end; ++row) {
    for (Index column = columns.begin; column < columns.end; ++column) {
      const Index texel = row * size + column;
      if (texels.triangles[texel] == no_index && areas_at(corners, middle_of(texel, size)).minCoeff() >= 0)
        texels.triangles[texel] = t;
    }
  }
}

// Layer by layer around what is covered; in each, texels ascend, so that the result is one for any order of triangles.
void spread(const Atlas& atlas, AtlasTexels& texels, const base::Host& host) {
  const Index size = atlas.options.size;
  Array<Index> front(host.memory), next(host.memory);
  for (Index texel = 0; texel < texels.shown.size(); ++texel)
    if (texels.shown[texel] == texel) front.push_back(texel);
  while (!front.empty()) {
    host.report("texels", 0, 0);
    next.clear();
    const auto visit = [&](Index from, Index to) {
      if (texels.shown[to] != no_index) return;
      texels.shown[to] = texels.shown[from];
      next.push_back(to);
    };
    for (const Index texel : front) {
      const Index column = texel % size;
      if (column > 0) visit(texel, texel - 1);
      if (column + 1 < size) visit(texel, texel + 1);
      if (texel >= size) visit(texel, texel - size);
      if (texel + size < texels.shown.size()) visit(texel, texel + size);
    }
    std::swap(front, next);
  }
}

}  // namespace

AtlasTexels covered_texels(const Atlas& atlas, const PatchGraph& graph, const SurfaceMap& map, const base::Host& host) {
  AtlasTexels texels(host.memory);
  const std::size_t count = std::size_t{atlas.options.size} * atlas.options.size;
  texels.triangles.assign(count, no_index);
  texels.shown.assign(count, no_index);
  for (Index t = 0; t < map.triangles.size(); ++t) {
    if (t % 4096 == 0) host.report("texels", t, map.triangles.size());
    cover(atlas, corners_of(atlas, graph, map, t), t, texels);
  }
  for (Index texel = 0; texel < count; ++texel)
    if (texels.triangles[texel] != no_index) texels.shown[texel] = texel;
  spread(atlas, texels, host);
  return texels;
}

Vector3 weights_at(const Atlas& atlas, const PatchGraph& graph, const SurfaceMap& map, const AtlasTexels& texels,
                   Index texel) {
  const Vector3 areas =
      areas_at(corners_of(atlas, graph, map, texels.triangles[texel]), middle_of(texel, atlas.options.size));
  const Vector3 weights = areas.cwiseMax(0.0);
  return weights / weights.sum();
}

}  // namespace orbicube::polycube
