#include "polycube/outputs/atlas_texels.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orbicube::polycube {
namespace {

using Texel = std::array<double, 2>;
constexpr Index rows_between_reports = 16;  // of a triangle: at most a quarter of a million texels

double cross(const Texel& a, const Texel& b, const Texel& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

// Areas of the triangles of a point with two corners, relative to that of the whole: negative outside.
Vector3 areas_at(const TexelCorners& corners, const Texel& p) {
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

class Covering {
 public:
  Covering(std::uint32_t size, std::span<const TexelCorners> corners, const base::Host& host)
      : size_(size),
        count_(static_cast<Index>(std::size_t{size} * size)),
        corners_(corners),
        host_(host),
        texels_(host.memory) {}

  AtlasTexels run() {
    texels_.size = size_;
    clear(texels_.triangles);
    clear(texels_.shown);
    for (Index t = 0; t < corners_.size(); ++t)
      cover(t);
    spread();
    return std::move(texels_);
  }

 private:
  // In parts, since memory of a large atlas takes the system a while.
  void clear(Array<Index>& entries) const {
    entries.reserve(count_);
    while (entries.size() < count_) {
      host_.report("empty texels", entries.size(), count_);
      entries.resize(std::min<std::size_t>(count_, entries.size() + (std::size_t{1} << 20)), no_index);
    }
  }

  void cover(Index t) {
    if (t % 4096 == 0) host_.report("texels", t, corners_.size());
    const TexelCorners& corners = corners_[t];
    const auto range = [&](std::size_t k) {
      const auto [low, high] = std::minmax({corners[0][k], corners[1][k], corners[2][k]});
      return TexelRange(low, high, size_);
    };
    const TexelRange columns = range(0), rows = range(1);
    if (!(cross(corners[0], corners[1], corners[2]) < 0)) return;  // a triangle that roundoff made flat
    for (Index row = rows.begin; row < rows.end; ++row) {
      if ((row - rows.begin) % rows_between_reports == rows_between_reports - 1)
        host_.report("texels", t, corners_.size());
      for (Index column = columns.begin; column < columns.end; ++column) {
        const Index texel = row * size_ + column;
        if (texels_.triangles[texel] == no_index && areas_at(corners, middle_of(texel, size_)).minCoeff() >= 0)
          texels_.triangles[texel] = t;
      }
    }
  }

  // Layer by layer around what is covered; in each, texels ascend, so that the result is one for any order of
  // triangles.
  void spread() {
    Array<Index> front(host_.memory), next(host_.memory);
    for (Index texel = 0; texel < count_; ++texel) {
      if (texel % base::items_between_reports == 0) host_.report("covered texels", texel, count_);
      if (texels_.triangles[texel] == no_index) continue;
      texels_.shown[texel] = texel;
      bool beside = false;
      around(texel, [&](Index other) { beside = beside || texels_.triangles[other] == no_index; });
      if (beside) front.push_back(texel);
    }
    while (!front.empty()) {
      next.clear();
      for (std::size_t i = 0; i < front.size(); ++i) {
        if (i % base::items_between_reports == 0) host_.report("texels beside patches", 0, 0);
        around(front[i], [&](Index other) {
          if (texels_.shown[other] != no_index) return;
          texels_.shown[other] = texels_.shown[front[i]];
          next.push_back(other);
        });
      }
      std::swap(front, next);
    }
  }

  template <class Visit>
  void around(Index texel, const Visit& visit) const {
    const Index column = texel % size_;
    if (column > 0) visit(texel - 1);
    if (column + 1 < size_) visit(texel + 1);
    if (texel >= size_) visit(texel - size_);
    if (texel + size_ < count_) visit(texel + size_);
  }

  std::uint32_t size_;
  Index count_;
  std::span<const TexelCorners> corners_;
  const base::Host& host_;
  AtlasTexels texels_;
};

}  // namespace

Array<TexelCorners> texel_corners(const Atlas& atlas, const PatchGraph& graph, const SurfaceMap& map,
                                  const base::Host& host) {
  Array<TexelCorners> corners(map.triangles.size(), host.memory);
  for (std::size_t t = 0; t < corners.size(); ++t) {
    if (t % base::items_between_reports == 0) host.report("texture coordinates", t, corners.size());
    for (std::size_t k = 0; k < 3; ++k)
      corners[t][k] = texel_of(atlas, graph, map.patches[t], map.polycube[map.triangles[t][k]]);
  }
  return corners;
}

AtlasTexels covered_texels(std::uint32_t size, std::span<const TexelCorners> corners, const base::Host& host) {
  return Covering(size, corners, host).run();
}

Vector3 weights_at(std::span<const TexelCorners> corners, const AtlasTexels& texels, Index texel) {
  const Vector3 areas = areas_at(corners[texels.triangles[texel]], middle_of(texel, texels.size));
  const Vector3 weights = areas.cwiseMax(0.0);
  return weights / weights.sum();
}

}  // namespace orbicube::polycube
