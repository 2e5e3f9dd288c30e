#include "harmonics_of_shape.h"

#include <cmath>
#include <numbers>

#include "harmonics/basis.h"
#include "harmonics/surface.h"

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
  double area = 0;
  for (const double a : harmonics::vertex_areas(shape.positions, shape.triangles, host))
    area += a;
  return std::sqrt(4 * std::numbers::pi / area) * harmonics::mean_distance(shape.positions, made.positions, host);
}

}  // namespace orbicube::cli
