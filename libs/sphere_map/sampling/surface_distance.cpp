#include "sphere_map/sampling/surface_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/sums.h"
#include "mesh/search/measures.h"
#include "mesh/search/nearest.h"
#include "mesh/topology/surface_check.h"
#include "sphere_map/optimization/pieces.h"

namespace orbicube::sphere_map {
namespace {

using base::Array;
using mesh::Triangle;
using mesh::Vector3;

Distances one_way(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                  const mesh::SurfaceSearch& other, const base::Host& host) {
  Array<double> at_vertices(positions.size(), 0, host.memory);
  Array<double> at_centroids(triangles.size(), 0, host.memory);
  // Only vertices of triangles count.
  const Array<std::uint8_t> used = mesh::used_vertices(positions.size(), triangles, host.memory);
  for_each_in_pieces(positions.size(), "distances", host, [&](std::size_t v) {
    if (used[v] != 0) at_vertices[v] = other.nearest(positions[v]).distance;
  });
  for_each_in_pieces(triangles.size(), "distances", host, [&](std::size_t t) {
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
    for (const mesh::Index v : triangles[t])
      add(1.0 / 12, at_vertices[v]);
  }
  if (area.value() > 0) {
    result.mean = sum.value() / area.value();
    result.root_mean_square = std::sqrt(squares.value() / area.value());
  }
  return result;
}

}  // namespace

SurfaceDistance surface_distance(std::span<const Vector3> first_positions, std::span<const Triangle> first_triangles,
                                 std::span<const Vector3> second_positions, std::span<const Triangle> second_triangles,
                                 const base::Host& host) {
  mesh::require_valid_surface(first_positions, first_triangles, host);
  mesh::require_valid_surface(second_positions, second_triangles, host);
  if (first_triangles.empty() || second_triangles.empty())
    throw base::Error("invalid-argument", "a surface without triangles has no distance");
  const mesh::SurfaceSearch first(first_positions, first_triangles, host);
  const mesh::SurfaceSearch second(second_positions, second_triangles, host);
  return {one_way(first_positions, first_triangles, second, host),
          one_way(second_positions, second_triangles, first, host)};
}

}  // namespace orbicube::sphere_map
