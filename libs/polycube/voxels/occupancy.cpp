#include "polycube/voxels/occupancy.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace orbicube::polycube {
namespace {

constexpr const char* occupancy_phase = "voxels";

// Rays pass the middle of their cells but for this, so that they miss vertices and edges of models that were drawn on a
// grid.
constexpr std::array<double, 2> ray_in_cell = {0.5 + 1.234567e-5, 0.5 - 2.34567e-5};

struct Crossing {
  std::uint32_t ray;
  std::int32_t sign;
  double z;
};

// Twice the signed area of (p, q, point), the same but for the sign when p and q change places.
double side(const Vector3& p, const Vector3& q, double x, double y) {
  const bool turned = q.x() < p.x() || (q.x() == p.x() && q.y() < p.y());
  const Vector3 &a = turned ? q : p, &b = turned ? p : q;
  const double area = (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  return turned ? -area : area;
}

// Where the rays through the cells of a grid cross a surface, by ray and going up.
Array<Crossing> ray_crossings(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                              const Vector3& low, double size, const std::array<int, 3>& counts,
                              const base::Host& host) {
  Array<Crossing> crossings(host.memory);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % 4096 == 0) host.report(occupancy_phase, t, triangles.size());
    const std::array<Vector3, 3> p = {positions[triangles[t][0]], positions[triangles[t][1]],
                                      positions[triangles[t][2]]};
    const double area = (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[1].y() - p[0].y()) * (p[2].x() - p[0].x());
    if (area == 0) continue;
    std::array<int, 2> begin{}, end{};
    for (std::size_t a = 0; a < 2; ++a) {
      const auto i = static_cast<Eigen::Index>(a);
      const double least = std::min({p[0][i], p[1][i], p[2][i]}), most = std::max({p[0][i], p[1][i], p[2][i]});
      begin[a] = std::max(0, static_cast<int>(std::ceil((least - low[i]) / size - ray_in_cell[a])));
      end[a] = std::min(counts[a], static_cast<int>(std::floor((most - low[i]) / size - ray_in_cell[a])) + 1);
    }
    for (int i = begin[0]; i < end[0]; ++i) {
      for (int j = begin[1]; j < end[1]; ++j) {
        const double x = low.x() + (i + ray_in_cell[0]) * size, y = low.y() + (j + ray_in_cell[1]) * size;
        const std::array<double, 3> w = {side(p[1], p[2], x, y), side(p[2], p[0], x, y), side(p[0], p[1], x, y)};
        if ((w[0] < 0 || w[1] < 0 || w[2] < 0) && (w[0] > 0 || w[1] > 0 || w[2] > 0)) continue;
        const double z = (w[0] * p[0].z() + w[1] * p[1].z() + w[2] * p[2].z()) / (w[0] + w[1] + w[2]);
        crossings.push_back({static_cast<std::uint32_t>(i * counts[1] + j), area > 0 ? 1 : -1, z});
      }
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.ray != b.ray ? a.ray < b.ray : a.z != b.z ? a.z < b.z : a.sign < b.sign;
  });
  return crossings;
}

}  // namespace

Occupancy::Occupancy(std::span<const Vector3> positions, std::span<const Triangle> triangles, int resolution,
                     const base::Host& host)
    : resolution_(resolution), sums_(host.memory) {
  base::require(resolution > 0 && resolution <= 1024 && !triangles.empty(), "no grid for this surface");
  Vector3 high = positions[triangles[0][0]];
  low_ = high;
  for (const Triangle& t : triangles) {
    for (const auto v : t) {
      low_ = low_.cwiseMin(positions[v]);
      high = high.cwiseMax(positions[v]);
    }
  }
  size_ = (high - low_).maxCoeff() / resolution;
  if (!(size_ > 0) || !std::isfinite(size_)) throw base::Error("degenerate-geometry", "the surface has no extent");
  for (std::size_t a = 0; a < 3; ++a)
    counts_[a] = std::clamp(
        static_cast<int>(
            std::ceil((high[static_cast<Eigen::Index>(a)] - low_[static_cast<Eigen::Index>(a)]) / size_ - 1e-9)),
        1, resolution);

  const Array<Crossing> crossings = ray_crossings(positions, triangles, low_, size_, counts_, host);
  sums_.assign(place(counts_[0], counts_[1], counts_[2]) + 1, 0);
  std::size_t next = 0;
  for (int i = 0; i < counts_[0]; ++i) {
    host.report(occupancy_phase, 0, 0);
    for (int j = 0; j < counts_[1]; ++j) {
      const auto ray = static_cast<std::uint32_t>(i * counts_[1] + j);
      std::uint32_t in_ray = 0;
      int winding = 0;
      for (int k = 0; k < counts_[2]; ++k) {
        const double z = low_.z() + (k + 0.5) * size_;
        // Going up, a surface that looks down is an entrance.
        for (; next < crossings.size() && crossings[next].ray == ray && crossings[next].z < z; ++next)
          winding -= crossings[next].sign;
        in_ray += winding > 0;
        sums_[place(i + 1, j + 1, k + 1)] =
            sums_[place(i, j + 1, k + 1)] + sums_[place(i + 1, j, k + 1)] - sums_[place(i, j, k + 1)] + in_ray;
      }
      while (next < crossings.size() && crossings[next].ray == ray)
        ++next;
    }
  }
}

std::int64_t Occupancy::inside(std::array<int, 3> begin, std::array<int, 3> end) const {
  for (std::size_t a = 0; a < 3; ++a) {
    begin[a] = std::clamp(begin[a], 0, counts_[a]);
    end[a] = std::clamp(end[a], begin[a], counts_[a]);
  }
  const auto at = [&](int x, int y, int z) { return static_cast<std::int64_t>(sums_[place(x, y, z)]); };
  return at(end[0], end[1], end[2]) - at(begin[0], end[1], end[2]) - at(end[0], begin[1], end[2]) -
         at(end[0], end[1], begin[2]) + at(begin[0], begin[1], end[2]) + at(begin[0], end[1], begin[2]) +
         at(end[0], begin[1], begin[2]) - at(begin[0], begin[1], begin[2]);
}

}  // namespace orbicube::polycube
