#include "correspondence/polycube_mesh.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/predicates.h"

namespace orbicube::correspondence {
namespace {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

PolycubeMesh triangles_of_map(const polycube::SurfaceMap& first, const base::Host& host) {
  PolycubeMesh result(host.memory);
  result.triangles = first.triangles;
  // Without the vertices of the shape that are in no triangle.
  base::Array<Index> number(first.polycube.size(), mesh::no_index, host.memory);
  for (Triangle& t : result.triangles) {
    for (Index& v : t) {
      if (number[v] == mesh::no_index) number[v] = 0;
    }
  }
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == mesh::no_index) continue;
    number[v] = static_cast<Index>(result.polycube.size());
    result.polycube.push_back(first.polycube[v]);
  }
  for (Triangle& t : result.triangles) {
    for (Index& v : t)
      v = number[v];
  }
  result.labels = first.labels;
  return result;
}

PolycubeMesh triangles_of_grid(const polycube::PatchGraph& graph, std::size_t cells, const base::Host& host) {
  PolycubeMesh result(host.memory);
  const polycube::PolycubeGrid grid = polycube::make_grid(graph, {.quads = cells}, host);
  polycube::QuadMesh quads = polycube::mesh_grid(graph, grid, host);
  result.polycube = std::move(quads.polycube);
  for (std::size_t q = 0; q < quads.quads.size(); ++q) {
    const auto& c = quads.quads[q];
    result.triangles.push_back({c[0], c[1], c[2]});
    result.triangles.push_back({c[0], c[2], c[3]});
    for (int half = 0; half < 2; ++half)
      result.labels.push_back(polycube::AxisLabel{graph.labels[quads.patches[q]]});
  }
  result.quads = std::move(quads.quads);
  return result;
}

// Triangles that are not positive in their patch of the polycube, exactly.
std::size_t count_not_positive_on(const PolycubeMesh& m) {
  std::size_t result = 0;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    const int axis = polycube::axis_of(m.labels[t]);
    const auto flat = [&](Index v) {
      const Vector3& p = m.polycube[v];
      return Eigen::Vector2d(p[(axis + 1) % 3], polycube::sign_of(m.labels[t]) * p[(axis + 2) % 3]);
    };
    result += mesh::orientation_2d(flat(m.triangles[t][0]), flat(m.triangles[t][1]), flat(m.triangles[t][2])) <= 0;
  }
  return result;
}

// A point within each triangle, exactly in the plane of its patch.
base::Array<Vector3> middles_of(const PolycubeMesh& m, const base::Host& host) {
  base::Array<Vector3> result(host.memory);
  result.reserve(m.triangles.size());
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    const auto& [a, b, c] = m.triangles[t];
    Vector3 middle = (m.polycube[a] + m.polycube[b] + m.polycube[c]) / 3;
    const int axis = polycube::axis_of(m.labels[t]);
    middle[axis] = m.polycube[a][axis];
    result.push_back(middle);
  }
  return result;
}

}  // namespace

std::size_t cells_for(std::size_t max_triangles) {
  return std::clamp<std::size_t>(max_triangles, 20'000, 400'000);
}

PolycubeMesh triangles_on(const polycube::CommonPolycube& common, std::size_t cells, const base::Host& host) {
  PolycubeMesh result =
      cells == 0 ? triangles_of_map(common.maps.front(), host) : triangles_of_grid(common.graph, cells, host);
  if (const std::size_t flipped = count_not_positive_on(result); flipped > 0)
    throw base::Error("no-valid-result",
                      base::counted(flipped, "triangle is", "triangles are") + " flipped on the polycube");
  return result;
}

base::Array<Vector3> positions_on(const polycube::SurfaceMap& map, const PolycubeMesh& common, const base::Host& host) {
  const polycube::LocatedPoints located = polycube::locate(map, common.polycube, host);
  base::Array<Vector3> result(host.memory);
  for (std::size_t v = 0; v < common.polycube.size(); ++v) {
    if (located.triangles[v] == mesh::no_index)
      throw base::Error("internal", "a vertex is on no triangle of the polycube");
    result.push_back(polycube::interpolate(map, located.triangles[v], located.weights[v]));
  }
  return result;
}

base::Array<Vector3> polycube_beside(const PolycubeMesh& common, std::span<const Vector3> shape,
                                     const base::Host& host) {
  const auto area_and_centre = [&](std::span<const Vector3> positions) {
    double area = 0;
    Vector3 centre = Vector3::Zero();
    for (const Triangle& t : common.triangles) {
      const Vector3 &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
      const double part = (b - a).cross(c - a).norm() / 2;
      area += part;
      centre += part * (a + b + c) / 3;
    }
    return std::pair(area, Vector3(centre / area));
  };
  const auto [area, centre] = area_and_centre(shape);
  const auto [domain_area, domain_centre] = area_and_centre(common.polycube);
  const double scale = std::sqrt(area / domain_area);
  base::Array<Vector3> result(host.memory);
  for (const Vector3& p : common.polycube)
    result.push_back(centre + scale * (p - domain_centre));
  return result;
}

base::Array<Vector3> middles_on(const polycube::SurfaceMap& map, const PolycubeMesh& common,
                                std::span<const Vector3> positions, const base::Host& host) {
  base::Array<Vector3> middles = middles_of(common, host);
  const polycube::LocatedPoints located = polycube::locate(map, middles, host);
  for (std::size_t t = 0; t < middles.size(); ++t) {
    const auto& [a, b, c] = common.triangles[t];
    // Of a very thin triangle at the border of a patch, the middle may be rounded out of it.
    middles[t] = located.triangles[t] == mesh::no_index
                     ? Vector3((positions[a] + positions[b] + positions[c]) / 3)
                     : polycube::interpolate(map, located.triangles[t], located.weights[t]);
  }
  return middles;
}

}  // namespace orbicube::correspondence
