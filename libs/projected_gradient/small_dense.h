// LU with row interchanges of a small dense matrix: the middle matrices of the limited-memory model, at most some dozen
// rows.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace orbicube::projected_gradient {

// Replaces a (size x size, by rows) by its factors; false when a pivot is zero or not finite.
inline bool factor_dense(std::span<double> a, std::span<std::uint32_t> pivots, std::size_t size) {
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < size; ++i) {
      if (std::abs(a[i * size + k]) > std::abs(a[pivot * size + k])) pivot = i;
    }
    pivots[k] = static_cast<std::uint32_t>(pivot);
    const double head = a[pivot * size + k];
    if (head == 0 || !std::isfinite(head)) return false;
    if (pivot != k) {
      for (std::size_t j = 0; j < size; ++j)
        std::swap(a[k * size + j], a[pivot * size + j]);
    }
    for (std::size_t i = k + 1; i < size; ++i) {
      const double factor = a[i * size + k] / head;
      a[i * size + k] = factor;
      for (std::size_t j = k + 1; j < size; ++j)
        a[i * size + j] -= factor * a[k * size + j];
    }
  }
  return true;
}

inline void solve_dense(std::span<const double> factors, std::span<const std::uint32_t> pivots, std::size_t size,
                        std::span<double> x) {
  for (std::size_t k = 0; k < size; ++k)
    std::swap(x[k], x[pivots[k]]);
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t j = 0; j < k; ++j)
      x[k] -= factors[k * size + j] * x[j];
  }
  for (std::size_t k = size; k-- > 0;) {
    for (std::size_t j = k + 1; j < size; ++j)
      x[k] -= factors[k * size + j] * x[j];
    x[k] /= factors[k * size + k];
  }
}

}  // namespace orbicube::projected_gradient
