#include "solids/harmonics_of_shape.h"

#include <cmath>
#include <numbers>

#include "harmonics/functions/basis.h"
#include "mesh/search/distances.h"
#include "mesh/search/measures.h"
#include "mesh/search/unit_scale.h"
#include "mesh/search/vertex_measures.h"

namespace orbicube::cli {

std::span<const double> numbers(const base::Array<mesh::Vector3>& positions) {
  static_assert(sizeof(mesh::Vector3) == 3 * sizeof(double));
  return {positions.empty() ? nullptr : positions.front().data(), 3 * positions.size()};
}

mesh::Mesh surface_of(const harmonics::Coefficients& coefficients, const mesh::Mesh& map, const base::Host& host) {
  mesh::Mesh made(host.memory);
  made.triangles = map.triangles;
  made.positions.resize(map.positions.size());
  harmonics::synthesise(coefficients, map.positions, {made.positions.front().data(), 3 * made.positions.size()}, host);
  return made;
}

double reconstruction_error(const mesh::Mesh& shape, const mesh::Mesh& made, const base::Host& host) {
  const base::Array<std::uint8_t> used = mesh::used_vertices(shape.positions.size(), shape.triangles, host.memory);
  base::Array<mesh::Vector3> scaled(shape.positions, host.memory), of_shape(host.memory), of_made(host.memory);
  const int exponent = mesh::unit_scale_exponent(shape.positions, shape.triangles);
  mesh::scale_by_power(scaled, exponent);
  double area = 0;
  for (const double a : mesh::vertex_areas(scaled, shape.triangles, host))
    area += a;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    of_shape.push_back(scaled[v]);
    of_made.push_back(made.positions[v]);
  }
  mesh::scale_by_power(of_made, exponent);
  return std::sqrt(4 * std::numbers::pi / area) * mesh::mean_distance(of_shape, of_made, host);
}

}  // namespace orbicube::cli
