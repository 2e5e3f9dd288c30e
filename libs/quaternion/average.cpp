#include "quaternion/average.h"

#include <algorithm>

#include "base/error.h"
#include "quaternion/symmetric_eigen.h"

namespace orbicube::quaternion {

Average average(const double* rotations, const double* weights, std::size_t count) {
  const auto require = [](bool condition, const char* message) {
    if (!condition) throw base::Error("invalid-argument", message);
  };
  require(count > 0, "there is nothing to average");
  double largest = weights == nullptr ? 1.0 : 0.0;
  for (std::size_t i = 0; weights != nullptr && i < count; ++i) {
    require(weights[i] >= 0 && std::isfinite(weights[i]), "weights must be finite and not negative");
    largest = std::max(largest, weights[i]);
  }
  require(largest > 0, "every weight is zero");
  double total = 0;
  SymmetricMatrix sum{};
  const double* first = nullptr;
  for (std::size_t i = 0; i < count; ++i) {
    const double* c = rotations + 4 * i;
    require(std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]) && std::isfinite(c[3]),
            "a quaternion is not finite");
    const double weight = weights == nullptr ? 1.0 : weights[i] / largest;
    if (weight == 0) continue;
    if (first == nullptr) first = c;
    total += weight;
    for (std::size_t row = 0; row < 4; ++row) {
      for (std::size_t column = row; column < 4; ++column)
        sum[4 * row + column] += weight * c[row] * c[column];
    }
  }
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < row; ++column)
      sum[4 * row + column] = sum[4 * column + row];
  }
  require(std::isfinite(sum[0] + sum[5] + sum[10] + sum[15]), "the quaternions are too large");
  const Dominant dominant = dominant_eigenvector(sum);
  if (!dominant.unique) throw base::Error("no-valid-result", "the rotations have no unique mean");
  const bool opposite = dot(dominant.vector, {first[0], first[1], first[2], first[3]}) < 0;
  return {opposite ? -dominant.vector : dominant.vector, dominant.value / total};
}

}  // namespace orbicube::quaternion
