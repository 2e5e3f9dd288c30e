#include "mesh/search/distances.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/sums.h"
#include "base/threads/pieces.h"
#include "mesh/search/measures.h"
#include "mesh/search/nearest.h"
#include "mesh/topology/surface_check.h"

namespace orbicube::mesh {
namespace {

// Squares of differences are in the range of double.
constexpr double max_coordinate = 1e150;

Distances one_way(std::span<const Vector3> positions, std::span<const Triangle> triangles, const SurfaceSearch& other,
                  const base::Host& host) {
  Array<double> at_vertices(positions.size(), 0, host.memory);
  Array<double> at_centroids(triangles.size(), 0, host.memory);
  // Only vertices of triangles count.
  const Array<std::uint8_t> used = used_vertices(positions.size(), triangles, host.memory);
  base::for_each_in_pieces(positions.size(), "distances", host, [&](std::size_t v) {
    if (used[v] != 0) at_vertices[v] = other.nearest(positions[v]).distance;
  });
  base::for_each_in_pieces(triangles.size(), "distances", host, [&](std::size_t t) {
    const auto& [a, b, c] = triangles[t];
    at_centroids[t] = other.nearest((positions[a] + positions[b] + positions[c]) / 3).distance;
  });
  base::CompensatedSum area, sum, squares;
  Distances result;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const double weight = 0.5 * (positions[b] - positions[a]).cross(positions[c] - positions[a]).norm();
    area.add(weight);
    const auto add = [&](double share, double distance) {
      sum.add(share * weight * distance);
      squares.add(share * weight * distance * distance);
      result.largest = std::max(result.largest, distance);
    };
    add(0.75, at_centroids[t]);
    for (const Index v : triangles[t])
      add(1.0 / 12, at_vertices[v]);
  }
  if (area.value() > 0) {
    result.mean = sum.value() / area.value();
    result.root_mean_square = std::sqrt(squares.value() / area.value());
  }
  return result;
}

// Mean over `points` of the distance to the nearest of the others.
double mean_one_way(std::span<const Vector3> points, std::span<const Vector3> others, const base::Host& host) {
  const VertexSearch search(others, host);
  Array<double> distance(points.size(), host.memory);
  base::for_each_in_pieces(points.size(), "distances", host, [&](std::size_t i) {
    distance[i] = std::sqrt((others[search.nearest(points[i])] - points[i]).squaredNorm());
  });
  return base::blocked_sum(points.size(), [&](std::size_t i) { return distance[i]; }) /
         static_cast<double>(points.size());
}

void require_points(std::span<const Vector3> points) {
  if (points.empty()) throw base::Error("invalid-argument", "a set of no points");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto refuse = [&](const char* why) {
      throw base::Error("invalid-argument", "point " + std::to_string(i) + why);
    };
    if (!points[i].allFinite()) refuse(" is not finite");
    if (points[i].cwiseAbs().maxCoeff() > max_coordinate) refuse(" has a coordinate beyond 1e150");
  }
}

}  // namespace

SurfaceDistance surface_distance(std::span<const Vector3> first_positions, std::span<const Triangle> first_triangles,
                                 std::span<const Vector3> second_positions, std::span<const Triangle> second_triangles,
                                 const base::Host& host) {
  require_valid_surface(first_positions, first_triangles, host);
  require_valid_surface(second_positions, second_triangles, host);
  if (first_triangles.empty() || second_triangles.empty())
    throw base::Error("invalid-argument", "a surface without triangles has no distance");
  const SurfaceSearch first(first_positions, first_triangles, host);
  const SurfaceSearch second(second_positions, second_triangles, host);
  return {one_way(first_positions, first_triangles, second, host),
          one_way(second_positions, second_triangles, first, host)};
}

double mean_distance(std::span<const Vector3> a, std::span<const Vector3> b, const base::Host& host) {
  require_points(a);
  require_points(b);
  const double forward = mean_one_way(a, b, host);
  return std::max(forward, mean_one_way(b, a, host));
}

}  // namespace orbicube::mesh
