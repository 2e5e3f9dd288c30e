#include "correspondence/morph.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "base/error.h"
#include "correspondence/polycube_mesh.h"
#include "correspondence/sphere_alignment.h"
#include "correspondence/sphere_mesh.h"
#include "mesh/topology/orient.h"
#include "mesh/topology/topology.h"
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

mesh::Mesh genus_zero_surface(const SurfaceSpan& surface, const base::Host& host) {
  mesh::Mesh result = copy_of(surface, host);
  mesh::Topology facts = mesh::topology(result.positions, result.triangles, host);
  const bool turn = facts.orientable && (facts.inconsistent_edges > 0 || facts.volume < 0);
  facts.inconsistent_edges = facts.orientable ? 0 : facts.inconsistent_edges;
  mesh::require_closed_genus_zero(facts);
  if (turn) mesh::orient(result.positions, result.triangles, host);
  return result;
}

mesh::Mesh any_genus_surface(const SurfaceSpan& surface, const base::Host& host) {
  mesh::Mesh result = copy_of(surface, host);
  const mesh::Topology facts = mesh::topology(result.positions, result.triangles, host);
  mesh::require_closed_manifold(facts);
  if (facts.components > 1) throw base::Error("not-connected", std::to_string(facts.components) + " components");
  if (!facts.orientable) throw base::Error("non-orientable", "no orientation of the triangles is consistent");
  mesh::orient(result.positions, result.triangles, host);
  return result;
}

void align(std::deque<SphereShape>& shapes, SphereAlignment how, const base::Host& host) {
  if (how == SphereAlignment::none) return;
  const harmonics::Coefficients first = coefficients_of(shapes[0], host);
  for (std::size_t i = 1; i < shapes.size(); ++i)
    align_by_correlation(first, shapes[i], how == SphereAlignment::shape, host);
}

Morph morph_by_spheres(std::span<const SurfaceSpan> surfaces, const MorphOptions& options, const base::Host& host) {
  std::deque<SphereShape> shapes;
  SphereShapes pointers;
  for (const SurfaceSpan& surface : surfaces) {
    SphereShape& shape = shapes.emplace_back(host.memory);
    shape.mesh = genus_zero_surface(surface, host);
    shape.directions = sphere_map::compute(shape.mesh.positions, shape.mesh.triangles, {.seed = options.seed}, host);
    shape.locator = std::make_unique<sphere_map::Locator>(shape.mesh.triangles, shape.directions, host);
    pointers.push_back(&shape);
  }
  align(shapes, options.align, host);
  CommonMesh common = options.grid == CommonGrid::first ? mesh_of_first(pointers, host)
                                                        : overlay_of(pointers, options.tolerance / 100, host);
  Morph result(host.memory);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    result.states.push_back(carry_to_shape(shapes[i], common, i, host).positions);
  result.triangles = std::move(common.triangles);
  return result;
}

Morph morph_by_polycube(std::span<const SurfaceSpan> surfaces, const MorphOptions& options, const base::Host& host) {
  std::vector<mesh::Mesh> meshes;
  std::size_t max_triangles = 0;
  for (const SurfaceSpan& surface : surfaces) {
    meshes.push_back(any_genus_surface(surface, host));
    max_triangles = std::max(max_triangles, meshes.back().triangles.size());
  }
  std::vector<polycube::SurfaceSpan> spans;
  for (const mesh::Mesh& m : meshes)
    spans.push_back({m.positions, m.triangles});
  const polycube::CommonPolycube made = polycube::construct_common(
      spans, {.construction = {.corners = options.corners, .seed = options.seed}, .domain = {}, .landmarks = {}}, host);
  const std::size_t fitting = options.cells > 0 ? options.cells : cells_for(max_triangles);
  PolycubeMesh common = triangles_on(made, options.grid == CommonGrid::first ? 0 : fitting, host);
  Morph result(host.memory);
  for (const polycube::SurfaceMap& map : made.maps)
    result.states.push_back(positions_on(map, common, host));
  result.triangles = std::move(common.triangles);
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
  Morph result = by_polycube ? morph_by_polycube(shapes, options, host) : morph_by_spheres(shapes, options, host);
  place(options.pose, result.triangles, result.states);
  return result;
}

base::Array<Vector3> blend(const Morph& morph, std::span<const double> weights, const base::Host& host) {
  base::require(weights.size() == morph.states.size(), "there must be one weight a shape");
  for (const double weight : weights)
    base::require(std::isfinite(weight), "a weight is not finite");
  base::Array<Vector3> result(morph.states.front().size(), Vector3::Zero(), host.memory);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    for (std::size_t v = 0; weights[i] != 0 && v < result.size(); ++v)
      result[v] += weights[i] * morph.states[i][v];
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
