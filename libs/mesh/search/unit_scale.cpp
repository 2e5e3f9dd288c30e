#include "mesh/search/unit_scale.h"

#include <cmath>
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

}  // namespace orbicube::mesh
