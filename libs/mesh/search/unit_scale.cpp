#include "mesh/search/unit_scale.h"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace orbicube::mesh {

int unit_scale_exponent(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3 low = Vector3::Constant(infinity), high = -low;
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      if (v >= positions.size()) continue;
      low = low.cwiseMin(positions[v]);
      high = high.cwiseMax(positions[v]);
    }
  }
  const double half = (0.5 * high - 0.5 * low).maxCoeff();  // the whole can overflow
  return half > 0 && std::isfinite(half) ? -std::ilogb(half) - 1 : 0;
}

void scale_by_power(std::span<Vector3> positions, int exponent) {
  if (exponent == 0) return;
  // One factor is a power in range for all but the largest exponents.
  const double first = std::ldexp(1.0, exponent / 2), second = std::ldexp(1.0, exponent - exponent / 2);
  for (Vector3& p : positions)
    p = p * first * second;
}

int bring_to_unit_size(Mesh& m, int ordinary) {
  int exponent = 0;
  if (!m.tetrahedra.empty()) {
    base::Array<Triangle> corners(m.positions.get_allocator().resource());
    for (const Tetrahedron& t : m.tetrahedra) {
      corners.push_back({t[0], t[1], t[2]});
      corners.push_back({t[1], t[2], t[3]});
    }
    exponent = unit_scale_exponent(m.positions, corners);
  } else {
    exponent = unit_scale_exponent(m.positions, m.triangles);
  }
  if (std::abs(exponent) <= ordinary) return 0;
  scale_by_power(m.positions, exponent);
  return exponent;
}

}  // namespace orbicube::mesh
