#include "solids/kept_surface.h"

#include <Eigen/Dense>
#include <algorithm>

namespace orbicube::cli {
namespace {

using mesh::Vector3;

// The place in a triangle of the sphere that is nearest to a direction, roughly: negative weights become 0.
std::array<double, 3> nearest_weights(const sphere_map::Locator& shape, mesh::Index triangle,
                                      const Vector3& direction) {
  const mesh::Triangle& corners = shape.triangles()[triangle];
  Eigen::Matrix3d columns;
  for (int k = 0; k < 3; ++k)
    columns.col(k) = shape.directions()[corners[static_cast<std::size_t>(k)]];
  Vector3 weights = columns.fullPivLu().solve(direction).cwiseMax(0.0);
  const double sum = weights.sum();
  if (!(sum > 0) || !weights.allFinite()) return {1, 0, 0};
  weights /= sum;
  return {weights[0], weights[1], weights[2]};
}

constexpr std::size_t triangles_between_reports = 1024;

}  // namespace

base::Array<gltf::KeptTriangle> kept_triangles(const sphere_map::Locator& shape, std::span<const Vector3> directions,
                                               std::span<const mesh::Triangle> triangles, const base::Host& host) {
  base::Array<sphere_map::Location> at(directions.size(), {0, Vector3::Zero()}, host.memory);
  shape.for_each_location(directions, host,
                          [&](std::size_t v, const sphere_map::Location& location) { at[v] = location; });
  base::Array<gltf::KeptTriangle> result(host.memory);
  result.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % triangles_between_reports == 0) host.report("placing corners", t, triangles.size());
    Vector3 middle = Vector3::Zero();
    for (const mesh::Index v : triangles[t])
      middle += directions[v].normalized();
    if (middle.isZero(0)) middle = directions[triangles[t][0]];
    gltf::KeptTriangle on{};
    on.middle = shape.locate(middle).triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const mesh::Index v = triangles[t][k];
      on.corners[k] = {at[v].triangle,
                       {at[v].weights[0], at[v].weights[1], at[v].weights[2]},
                       nearest_weights(shape, on.middle, directions[v])};
    }
    result.push_back(on);
  }
  return result;
}

}  // namespace orbicube::cli
