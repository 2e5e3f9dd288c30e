#include "correspondence/morph.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "base/error.h"
#include "correspondence/closed_surface.h"
#include "correspondence/polycube_mesh.h"
#include "correspondence/sphere_alignment.h"
#include "correspondence/sphere_mesh.h"
#include "mesh/search/nearest.h"
#include "sphere_map/sphere_map.h"

namespace orbicube::correspondence {
namespace {

using mesh::Vector3;

constexpr std::size_t max_shapes_of_polycube = 10;
constexpr std::size_t max_shapes_of_sphere = 100;

mesh::Mesh copy_of(const SurfaceSpan& surface, const base::Host& host) {
  mesh::Mesh result(host.memory);
  result.positions.assign(surface.positions.begin(), surface.positions.end());
  result.triangles.assign(surface.triangles.begin(), surface.triangles.end());
  return result;
}

// The points of the landmarks of each shape, on its surface.
std::vector<base::Array<TrianglePoint>> landmarks_on(std::span<const mesh::Mesh* const> shapes,
                                                     std::span<const std::span<const Vector3>> landmarks,
                                                     const base::Host& host) {
  std::vector<base::Array<TrianglePoint>> result;
  if (landmarks.empty()) return result;
  base::require(landmarks.size() == shapes.size(), "each shape must have landmarks, or none");
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    base::require(!landmarks[i].empty() && landmarks[i].size() == landmarks[0].size(),
                  "each shape must have as many landmarks");
    const mesh::SurfaceSearch search(shapes[i]->positions, shapes[i]->triangles, host);
    base::Array<TrianglePoint>& points = result.emplace_back(host.memory);
    for (const Vector3& p : landmarks[i]) {
      base::require(p.allFinite(), "a landmark is not finite");
      const mesh::SurfacePoint nearest = search.nearest(p);
      base::require(nearest.triangle != mesh::no_index, "a landmark is too far from its surface");
      points.push_back({nearest.triangle, nearest.weights});
    }
  }
  return result;
}

void align_landmarks(std::deque<SphereShape>& shapes, const std::vector<base::Array<TrianglePoint>>& points,
                     const base::Host& host) {
  std::vector<std::vector<Vector3>> directions(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (const TrianglePoint& point : points[i])
      directions[i].push_back(position_of(point, shapes[i].mesh.triangles, shapes[i].directions).normalized());
    require_apart(directions[i]);
  }
  for (std::size_t i = 1; i < shapes.size(); ++i)
    align_by_landmarks(shapes[i], directions[i], directions[0], host);
}

void align(std::deque<SphereShape>& shapes, SphereAlignment how, const base::Host& host) {
  if (how == SphereAlignment::none) return;
  const harmonics::Coefficients first = coefficients_of(shapes[0], host);
  for (std::size_t i = 1; i < shapes.size(); ++i)
    align_by_correlation(first, shapes[i], how == SphereAlignment::shape, host);
}

CommonMesh grid_of(const SphereShapes& shapes, const MorphOptions& options, const base::Host& host) {
  if (options.grid == CommonGrid::both) return overlay_of(shapes, options.tolerance / 100, host);
  if (options.grid == CommonGrid::first) return mesh_of_first(shapes, host);
  const auto kind = static_cast<sphere_map::GridKind>(static_cast<int>(options.grid) - 2);
  return mesh_of_grid(shapes, kind, options.resolution, host);
}

std::vector<std::span<const mesh::Triangle>> triangles_of(std::span<const SurfaceSpan> surfaces) {
  std::vector<std::span<const mesh::Triangle>> result;
  for (const SurfaceSpan& surface : surfaces)
    result.push_back(surface.triangles);
  return result;
}

Morph morph_by_spheres(std::span<const SurfaceSpan> surfaces, const MorphOptions& options, const base::Host& host) {
  std::deque<SphereShape> shapes;
  SphereShapes pointers;
  for (const SurfaceSpan& surface : surfaces) {
    SphereShape& shape = shapes.emplace_back(host.memory);
    shape.mesh = copy_of(surface, host);
    orient_genus_zero(shape.mesh, host);
    shape.directions = sphere_map::compute(shape.mesh.positions, shape.mesh.triangles, {.seed = options.seed}, host);
    shape.locator = std::make_unique<sphere_map::Locator>(shape.mesh.triangles, shape.directions, host);
    pointers.push_back(&shape);
  }
  std::vector<const mesh::Mesh*> meshes;
  for (const SphereShape& shape : shapes)
    meshes.push_back(&shape.mesh);
  if (options.landmarks.empty())
    align(shapes, options.align, host);
  else
    align_landmarks(shapes, landmarks_on(meshes, options.landmarks, host), host);
  CommonMesh common = grid_of(pointers, options, host);
  Morph result(host.memory);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    result.states.push_back(carry_to_shape(shapes[i], common, i, host).positions);
  result.triangles = std::move(common.triangles);
  result.domain = std::move(common.directions);
  result.maps = std::make_shared<const ShapeMaps>(std::move(shapes), triangles_of(surfaces), host);
  return result;
}

Morph morph_by_polycube(std::span<const SurfaceSpan> surfaces, const MorphOptions& options, const base::Host& host) {
  std::vector<mesh::Mesh> meshes;
  std::size_t max_triangles = 0;
  for (const SurfaceSpan& surface : surfaces) {
    std::int64_t genus = 0;
    orient_any_genus(meshes.emplace_back(copy_of(surface, host)), genus, host);
    max_triangles = std::max(max_triangles, meshes.back().triangles.size());
  }
  std::vector<polycube::SurfaceSpan> spans;
  std::vector<const mesh::Mesh*> pointers;
  for (const mesh::Mesh& m : meshes) {
    spans.push_back({m.positions, m.triangles});
    pointers.push_back(&m);
  }
  std::vector<base::Array<Vector3>> landmarks;
  for (const auto& points : landmarks_on(pointers, options.landmarks, host)) {
    const mesh::Mesh& m = meshes[landmarks.size()];
    base::Array<Vector3>& places = landmarks.emplace_back(host.memory);
    for (const TrianglePoint& point : points)
      places.push_back(position_of(point, m.triangles, m.positions));
  }
  polycube::CommonPolycube made = polycube::construct_common(
      spans, {.construction = {.corners = options.corners, .seed = options.seed}, .landmarks = landmarks}, host);
  const std::size_t fitting = options.cells > 0 ? options.cells : cells_for(max_triangles);
  PolycubeMesh common = triangles_on(made, options.grid == CommonGrid::first ? 0 : fitting, host);
  Morph result(host.memory);
  for (const polycube::SurfaceMap& map : made.maps)
    result.states.push_back(positions_on(map, common, host));
  result.triangles = std::move(common.triangles);
  result.quads = std::move(common.quads);
  result.domain = std::move(common.polycube);
  result.maps = std::make_shared<const ShapeMaps>(std::move(made.maps), triangles_of(surfaces), host);
  return result;
}

}  // namespace

Morph morph(std::span<const SurfaceSpan> shapes, const MorphOptions& options, const base::Host& host) {
  const bool by_polycube = options.via == Via::polycube;
  base::require(shapes.size() >= 2, "at least two shapes are needed");
  base::require(shapes.size() <= (by_polycube ? max_shapes_of_polycube : max_shapes_of_sphere),
                by_polycube ? "a polycube takes at most ten shapes" : "at most 100 shapes");
  base::require(std::isfinite(options.tolerance) && options.tolerance >= 0, "tolerance must be finite and nonnegative");
  base::require(options.cells <= 100'000'000, "cells must be at most 100000000");
  base::require(options.corners <= 1'000'000, "corners must be at most 1000000");
  base::require(!by_polycube || options.grid == CommonGrid::both || options.grid == CommonGrid::first,
                "grids of the sphere are for correspondences through spheres");
  Morph result = by_polycube ? morph_by_polycube(shapes, options, host) : morph_by_spheres(shapes, options, host);
  place(options.pose, result.triangles, result.states);
  return result;
}

base::Array<Vector3> blend(std::span<const base::Array<Vector3>> states, std::span<const double> weights,
                           const base::Host& host) {
  base::require(!states.empty() && weights.size() == states.size(), "there must be one weight a shape");
  for (const double weight : weights)
    base::require(std::isfinite(weight), "a weight is not finite");
  base::Array<Vector3> result(states.front().size(), Vector3::Zero(), host.memory);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    for (std::size_t v = 0; weights[i] != 0 && v < result.size(); ++v)
      result[v] += weights[i] * states[i][v];
  }
  return result;
}

base::Array<Vector3> intermediate(std::span<const Vector3> from, std::span<const Vector3> to, double fraction,
                                  std::pmr::memory_resource* memory) {
  base::Array<Vector3> result(memory);
  result.reserve(from.size());
  for (std::size_t v = 0; v < from.size(); ++v)
    result.push_back((1 - fraction) * from[v] + fraction * to[v]);
  return result;
}

}  // namespace orbicube::correspondence
