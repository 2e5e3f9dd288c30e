#include "volume_map/surface_distance.h"

#include <algorithm>
#include <cmath>

#include "mesh/nearest.h"

namespace orbicube::volume_map {
namespace {

double one_way(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
               const mesh::SurfaceSearch& other, double spacing, const base::Host& host) {
  constexpr int most_parts = 60;
  constexpr std::size_t piece = 64, pieces_at_once = 16;
  std::array<double, pieces_at_once> farthest{};
  double most = 0;
  const std::size_t pieces = (triangles.size() + piece - 1) / piece;
  for (std::size_t first = 0; first < pieces; first += pieces_at_once) {
    host.report("distance", first, pieces);
    host.parallel_for(std::min(pieces_at_once, pieces - first), [&](std::size_t p) {
      const std::size_t end = std::min(triangles.size(), (first + p + 1) * piece);
      double& far = farthest[p] = most;
      Index near = no_index;
      for (std::size_t i = (first + p) * piece; i < end; ++i) {
        const mesh::Triangle& t = triangles[i];
        const Vector3 a = positions[t[0]], b = positions[t[1]] - a, c = positions[t[2]] - a;
        const double longest = std::sqrt(std::max({b.squaredNorm(), c.squaredNorm(), (c - b).squaredNorm()}));
        const int parts = static_cast<int>(std::clamp(std::ceil(longest / spacing), 1.0, double{most_parts}));
        for (int k = 0; k <= parts; ++k) {
          for (int l = 0; k + l <= parts; ++l) {
            const Vector3 x = a + (k * b + l * c) / parts;
            // What is near to the triangle of the point before is not the farthest, whatever else is nearer.
            if (near != no_index && other.distance(near, x) <= far) continue;
            const mesh::SurfacePoint found = other.nearest(x, near);
            near = found.triangle;
            far = std::max(far, found.distance);
          }
        }
      }
    });
    most = *std::max_element(farthest.begin(), farthest.end());
  }
  return most;
}

}  // namespace

double surface_distance(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                        std::span<const Vector3> other_positions, std::span<const mesh::Triangle> other_triangles,
                        double spacing, const base::Host& host) {
  const mesh::SurfaceSearch search(positions, triangles, host);
  const mesh::SurfaceSearch other(other_positions, other_triangles, host);
  return std::max(one_way(positions, triangles, other, spacing, host),
                  one_way(other_positions, other_triangles, search, spacing, host));
}

}  // namespace orbicube::volume_map
