#include "correspondence/sphere_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/sums.h"
#include "mesh/search/measures.h"
#include "sphere_map/correspondence/overlay.h"

namespace orbicube::correspondence {
namespace {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;
using sphere_map::Alignment;

// Of vertices of triangles.
std::size_t used_count(const SphereShape& shape, const base::Host& host) {
  const mesh::Mesh& m = shape.mesh;
  const base::Array<std::uint8_t> used = mesh::used_vertices(m.positions.size(), m.triangles, host.memory);
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

// Without the vertices of the shapes that are in no triangle.
void remove_unused(CommonMesh& common, const base::Host& host) {
  const base::Array<std::uint8_t> used = mesh::used_vertices(common.directions.size(), common.triangles, host.memory);
  base::Array<Index> number(used.size(), mesh::no_index, host.memory);
  Index count = 0;
  for (Index v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    number[v] = count;
    common.directions[count] = common.directions[v];
    for (base::Array<Index>& own : common.own_vertex)
      own[count] = own[v];
    ++count;
  }
  if (count == used.size()) return;
  common.directions.resize(count);
  for (base::Array<Index>& own : common.own_vertex)
    own.resize(count);
  for (Triangle& t : common.triangles) {
    for (Index& v : t)
      v = number[v];
  }
}

void no_own_vertices(CommonMesh& common, std::size_t shapes, const base::Host& host) {
  for (std::size_t i = 0; i < shapes; ++i)
    common.own_vertex.emplace_back(common.directions.size(), mesh::no_index, host.memory);
}

}  // namespace

CommonMesh overlay_of(const SphereShapes& shapes, double tolerance, const base::Host& host) {
  std::vector<sphere_map::PlacedMap> others;
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    others.push_back({shapes[i]->directions, shapes[i]->mesh.triangles});
  }
  const Alignment in_line;
  // The first shape is flat between its own edges; what the others have there is looked after.
  std::vector<sphere_map::EdgeError::Shape> missed;
  std::size_t vertices = used_count(*shapes[0], host);
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    missed.push_back({shapes[i]->locator.get(), shapes[i]->mesh.positions, &in_line});
    vertices += used_count(*shapes[i], host);
  }
  constexpr std::size_t max_growth = 3;
  const sphere_map::Refinement refinement{
      sphere_map::EdgeError(missed, tolerance),
      max_growth * vertices + shapes[0]->directions.size() - used_count(*shapes[0], host)};
  sphere_map::Overlay made = sphere_map::overlay({shapes[0]->directions, shapes[0]->mesh.triangles}, others, host,
                                                 tolerance > 0 ? &refinement : nullptr);
  CommonMesh common(host.memory);
  common.directions = std::move(made.directions);
  common.triangles = std::move(made.triangles);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    base::Array<Index>& own = common.own_vertex.emplace_back(common.directions.size(), mesh::no_index, host.memory);
    for (Index v = 0; v < shapes[i]->directions.size(); ++v) {
      const Index place = i == 0 ? v : made.vertex_of[i - 1][v];
      if (place != mesh::no_index) own[place] = v;
    }
  }
  common.edges_of_others = made.edges_of_others;
  common.edges_kept = made.edges_present;
  remove_unused(common, host);
  return common;
}

CommonMesh mesh_of_first(const SphereShapes& shapes, const base::Host& host) {
  CommonMesh common(host.memory);
  common.directions = shapes[0]->directions;
  common.triangles = shapes[0]->mesh.triangles;
  no_own_vertices(common, shapes.size(), host);
  for (Index v = 0; v < common.directions.size(); ++v)
    common.own_vertex[0][v] = v;
  remove_unused(common, host);
  return common;
}

CommonMesh mesh_of_grid(const SphereShapes& shapes, sphere_map::GridKind kind, std::size_t resolution,
                        const base::Host& host) {
  sphere_map::Grid grid = sphere_map::make_grid(kind, resolution, host);
  CommonMesh common(host.memory);
  common.directions = std::move(grid.directions);
  common.triangles = std::move(grid.triangles);
  no_own_vertices(common, shapes.size(), host);
  return common;
}

sphere_map::CarriedShape carry_to_shape(const SphereShape& shape, const CommonMesh& common, std::size_t i,
                                        const base::Host& host) {
  return sphere_map::carry_over(*shape.locator, shape.mesh.positions, Alignment(), common.directions, common.triangles,
                                common.own_vertex[i], host);
}

double area_distortion(std::span<const Triangle> triangles, std::span<const Vector3> from,
                       std::span<const Vector3> to) {
  const auto area = [&](std::span<const Vector3> x, const Triangle& t) {
    return 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
  };
  base::CompensatedSum from_area, to_area, squares;
  for (const Triangle& t : triangles) {
    from_area.add(area(from, t));
    to_area.add(area(to, t));
  }
  for (const Triangle& t : triangles) {
    const double a = area(from, t) / from_area.value();
    const double b = area(to, t) / to_area.value();
    if (a > 0 && b > 0) squares.add(a * std::log(b / a) * std::log(b / a));
  }
  return std::sqrt(squares.value());
}

}  // namespace orbicube::correspondence
