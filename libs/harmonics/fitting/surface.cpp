#include "harmonics/fitting/surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/sums.h"
#include "harmonics/fitting/point_tree.h"

namespace orbicube::harmonics {
namespace {

// Mean over `points` of the distance to the nearest one in the tree.
double one_way(std::span<const Vector3> points, const PointTree& tree, const base::Host& host) {
  Array<double> distance(points.size(), host.memory);
  constexpr std::size_t chunk = 1024, wave = 16;
  for (std::size_t begin = 0; begin < points.size(); begin += chunk * wave) {
    host.report("distances", begin, points.size());
    const std::size_t here = std::min(chunk * wave, points.size() - begin);
    host.parallel_for((here + chunk - 1) / chunk, [&](std::size_t k) {
      const std::size_t end = std::min(begin + (k + 1) * chunk, points.size());
      for (std::size_t i = begin + k * chunk; i < end; ++i)
        distance[i] = std::sqrt(tree.nearest_square(points[i]));
    });
  }
  return base::blocked_sum(points.size(), [&](std::size_t i) { return distance[i]; }) /
         static_cast<double>(points.size());
}

void require_points(std::span<const Vector3> points) {
  if (points.empty()) throw base::Error("invalid-argument", "a set of no points");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) throw base::Error("invalid-argument", "point " + std::to_string(i) + " is not finite");
  }
}

}  // namespace

Array<double> vertex_areas(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const base::Host& host) {
  Array<double> areas(positions.size(), 0.0, host.memory);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle& triangle = triangles[t];
    for (const std::uint32_t v : triangle) {
      if (v >= positions.size())
        throw base::Error("index-range", "triangle " + std::to_string(t) + " has vertex " + std::to_string(v) + " of " +
                                             std::to_string(positions.size()));
    }
    const Vector3 a = positions[triangle[1]] - positions[triangle[0]],
                  b = positions[triangle[2]] - positions[triangle[0]];
    const double third = a.cross(b).norm() / 6;
    for (const std::uint32_t v : triangle)
      areas[v] += third;
  }
  return areas;
}

double mean_distance(std::span<const Vector3> a, std::span<const Vector3> b, const base::Host& host) {
  require_points(a);
  require_points(b);
  double forward = 0, backward = 0;
  {
    const PointTree tree(b, host);
    forward = one_way(a, tree, host);
  }
  {
    const PointTree tree(a, host);
    backward = one_way(b, tree, host);
  }
  return std::max(forward, backward);
}

}  // namespace orbicube::harmonics
