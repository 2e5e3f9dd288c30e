#include "volume_map/input/given_polycube.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "mesh/search/measures.h"
#include "mesh/search/unit_scale.h"
#include "polycube/layout/drawn_construction.h"
#include "polycube/surface/distortion.h"

namespace orbicube::volume_map {
namespace {

using mesh::Triangle;
using mesh::Vector3;

double area_of(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  double sum = 0;
  for (const Triangle& t : triangles)
    sum += (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm() / 2;
  return sum;
}

// The vertex of `own` for each vertex of triangles that are the same but for the numbers of vertices; empty for others.
base::Array<mesh::Index> same_vertices(std::span<const Triangle> triangles, std::size_t vertices,
                                       const polycube::SurfaceMap& own, const base::Host& host) {
  base::Array<mesh::Index> result(vertices, mesh::no_index, host.memory);
  base::Array<mesh::Index> back(own.polycube.size(), mesh::no_index, host.memory);
  bool same = triangles.size() == own.triangles.size();
  for (std::size_t t = 0; same && t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const mesh::Index v = triangles[t][k], of_own = own.triangles[t][k];
      if (result[v] == mesh::no_index && back[of_own] == mesh::no_index) {
        result[v] = of_own;
        back[of_own] = v;
      }
      same = same && result[v] == of_own && back[of_own] == v;
    }
  }
  if (!same || std::ranges::find(result, mesh::no_index) != result.end()) result.clear();
  return result;
}

}  // namespace

polycube::Construction construct_given(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                       const GivenPolycube& given, const WorkingSpace& space, bool& is_own,
                                       const base::Host& host) {
  const polycube::SurfaceMap& own = given.target->map;
  const int exponent = static_cast<int>(
      std::lround(std::log2(area_of(positions, triangles) / area_of(own.polycube, own.triangles)) / 2));
  const base::Array<mesh::Index> same = same_vertices(triangles, positions.size(), own, host);
  is_own = !same.empty();
  if (is_own) {
    polycube::Construction made(host.memory);
    made.map.positions.assign(positions.begin(), positions.end());
    for (const mesh::Index v : same)
      made.map.polycube.push_back(own.polycube[v]);
    mesh::scale_by_power(made.map.polycube, exponent);
    made.map.triangles.assign(triangles.begin(), triangles.end());
    polycube::set_unrefined(made.map);
    made.certificate = polycube::certify(made.map, host);
    if (!made.certificate.valid()) throw base::Error("no-valid-result", made.certificate.reason);
    made.distortion = polycube::measure_distortion(made.map, host);
    made.tried = made.valid = 1;
    return made;
  }
  polycube::PatchGraph graph(host.memory);
  graph = given.target->graph;
  mesh::scale_by_power(graph.corners, exponent);
  for (double& coordinate : graph.coordinates)
    coordinate = std::ldexp(coordinate, exponent);
  base::Array<Vector3> pose(given.pose.begin(), given.pose.end(), host.memory);
  space.take(pose);
  return polycube::construct_on(positions, triangles, graph, given.target->genus, {.pose = pose}, host);
}

}  // namespace orbicube::volume_map
