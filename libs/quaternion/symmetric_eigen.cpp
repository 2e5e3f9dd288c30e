#include "quaternion/symmetric_eigen.h"

#include <algorithm>
#include <limits>

namespace orbicube::quaternion {

Dominant dominant_eigenvector(const SymmetricMatrix& matrix) {
  SymmetricMatrix a = matrix;
  SymmetricMatrix v{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  // eigenvectors in columns
  double size = 0;
  for (const double entry : a)
    size = std::max(size, std::abs(entry));
  constexpr int sweep_limit = 30;  // quadratic convergence: six to eight are what it takes
  for (int sweep = 0; sweep < sweep_limit; ++sweep) {
    double rest = 0;
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = p + 1; q < 4; ++q)
        rest = std::max(rest, std::abs(a[4 * p + q]));
    }
    if (rest <= 1e-20 * size) break;
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = p + 1; q < 4; ++q) {
        const double off = a[4 * p + q];
        if (off == 0) continue;
        const double cotangent = (a[5 * q] - a[5 * p]) / (2 * off);  // of twice the angle
        const double tangent = std::copysign(1 / (std::abs(cotangent) + std::hypot(1.0, cotangent)), cotangent);
        const double cosine = 1 / std::hypot(1.0, tangent), sine = tangent * cosine;
        for (std::size_t k = 0; k < 4; ++k) {
          const double left = a[4 * k + p], right = a[4 * k + q];
          a[4 * k + p] = cosine * left - sine * right;
          a[4 * k + q] = sine * left + cosine * right;
        }
        for (std::size_t k = 0; k < 4; ++k) {
          const double upper = a[4 * p + k], lower = a[4 * q + k];
          a[4 * p + k] = cosine * upper - sine * lower;
          a[4 * q + k] = sine * upper + cosine * lower;
          const double left = v[4 * k + p], right = v[4 * k + q];
          v[4 * k + p] = cosine * left - sine * right;
          v[4 * k + q] = sine * left + cosine * right;
        }
        a[4 * p + q] = a[4 * q + p] = 0;
      }
    }
  }
  std::size_t first = 0;
  for (std::size_t k = 1; k < 4; ++k) {
    if (a[5 * k] > a[5 * first]) first = k;
  }
  double second = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 4; ++k) {
    if (k != first) second = std::max(second, a[5 * k]);
  }
  const double gap = a[5 * first] - second;
  const Quaternion vector = normalized({v[first], v[4 + first], v[8 + first], v[12 + first]});
  constexpr double rounding = 1e-14;
  return {vector, a[5 * first], gap, gap > rounding * size};
}

}  // namespace orbicube::quaternion
