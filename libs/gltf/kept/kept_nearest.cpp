#include "gltf/kept/kept_nearest.h"

#include "mesh/search/nearest.h"

namespace orbicube::gltf {
namespace {

std::array<double, 3> as_array(const mesh::Vector3& weights) {
  return {weights[0], weights[1], weights[2]};
}

constexpr std::size_t triangles_between_reports = 1024;

}  // namespace

base::Array<KeptTriangle> nearest_kept_triangles(const mesh::Mesh& surface, std::span<const mesh::Vector3> positions,
                                                 std::span<const mesh::Triangle> triangles,
                                                 std::span<const mesh::Vector3> middles, const base::Host& host) {
  const mesh::SurfaceSearch search(surface.positions, surface.triangles, host);
  base::Array<mesh::SurfacePoint> at(host.memory);
  at.reserve(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (v % triangles_between_reports == 0) host.report("placing vertices", v, positions.size());
    at.push_back(search.nearest(positions[v], at.empty() ? mesh::no_index : at.back().triangle));
  }
  base::Array<KeptTriangle> result(host.memory);
  result.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % triangles_between_reports == 0) host.report("placing corners", t, triangles.size());
    KeptTriangle on{};
    on.middle = search.nearest(middles[t], at[triangles[t][0]].triangle).triangle;
    const auto& [a, b, c] = surface.triangles[on.middle];
    for (std::size_t k = 0; k < 3; ++k) {
      const mesh::SurfacePoint& corner = at[triangles[t][k]];
      const mesh::TrianglePoint nearest = mesh::nearest_on_triangle(positions[triangles[t][k]], surface.positions[a],
                                                                    surface.positions[b], surface.positions[c]);
      on.corners[k] = {corner.triangle, as_array(corner.weights), as_array(nearest.weights)};
    }
    result.push_back(on);
  }
  return result;
}

}  // namespace orbicube::gltf
