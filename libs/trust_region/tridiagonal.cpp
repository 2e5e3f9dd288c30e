#include "trust_region/tridiagonal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trust_region/dense.h"

namespace orbicube::trust_region {

Tridiagonal::Tridiagonal(std::size_t capacity, std::pmr::memory_resource* memory)
    : matrix_(capacity * capacity, 0.0, memory),
      diagonal_(capacity, 0.0, memory),
      below_(capacity, 0.0, memory),
      factor_(capacity, 0.0, memory),
      work_(capacity, 0.0, memory) {}

// Reflector k is in row k beyond the diagonal, its 2 / v'v in factor_.
void Tridiagonal::reduce(std::size_t size) {
  size_ = size;
  double* p = work_.data();
  const double largest = max_magnitude(matrix_.data(), size * size);
  // What is left of a matrix of low rank is rounding of rounding, whose squares would underflow.
  const double negligible = std::max(1e-40 * largest * largest, 1e-290);
  for (std::size_t k = 0; k + 2 < size; ++k) {
    double* v = matrix_.data() + k * size + k + 1;
    const std::size_t rest = size - k - 1;
    diagonal_[k] = matrix_[k * size + k];
    const double tail = dot(v + 1, v + 1, rest - 1), length = std::sqrt(tail + v[0] * v[0]);
    factor_[k] = 0;
    below_[k] = v[0];
    if (!(tail > negligible)) continue;
    below_[k] = v[0] > 0 ? -length : length;
    v[0] -= below_[k];
    factor_[k] = 2 / (tail + v[0] * v[0]);
    double* sub = matrix_.data() + (k + 1) * size + k + 1;
    combination(p, rest, v, sub, size, rest);
    const double half = 0.5 * factor_[k] * factor_[k] * dot(v, p, rest);
    for (std::size_t i = 0; i < rest; ++i)
      p[i] = factor_[k] * p[i] - half * v[i];
    subtract_two_products(sub, size, rest, v, p);
  }
  if (size >= 2) {
    diagonal_[size - 2] = matrix_[(size - 2) * size + size - 2];
    below_[size - 2] = matrix_[(size - 2) * size + size - 1];
  }
  if (size >= 1) diagonal_[size - 1] = matrix_[size * size - 1];
}

void Tridiagonal::to_reduced(double* x) const {
  for (std::size_t k = 0; k + 2 < size_; ++k) {
    const double* v = matrix_.data() + k * size_ + k + 1;
    const std::size_t rest = size_ - k - 1;
    if (factor_[k] != 0) add_scaled(x + k + 1, -factor_[k] * dot(v, x + k + 1, rest), v, rest);
  }
}

void Tridiagonal::from_reduced(double* x) const {
  for (std::size_t k = size_; k-- > 0;) {
    if (k + 2 >= size_ || factor_[k] == 0) continue;
    const double* v = matrix_.data() + k * size_ + k + 1;
    const std::size_t rest = size_ - k - 1;
    add_scaled(x + k + 1, -factor_[k] * dot(v, x + k + 1, rest), v, rest);
  }
}

bool Tridiagonal::eigen(std::size_t size, double* values, double* vectors) {
  reduce(size);
  for (std::size_t i = 0; vectors != nullptr && i < size; ++i) {
    std::fill_n(vectors + i * size, size, 0.0);
    vectors[i * size + i] = 1;
  }
  double* d = diagonal_.data();
  double* b = below_.data();
  const auto negligible = [&](std::size_t k) {
    return !(std::abs(b[k]) > std::numeric_limits<double>::epsilon() * (std::abs(d[k]) + std::abs(d[k + 1])));
  };
  std::size_t steps = 0, high = size == 0 ? 0 : size - 1;
  while (high > 0) {
    if (negligible(high - 1)) {
      --high;
      continue;
    }
    if (++steps > 40 * size) return false;
    std::size_t low = high - 1;
    while (low > 0 && !negligible(low - 1))
      --low;
    // One QR step of the block from low to high with Wilkinson's shift, the rotation of rows k and k + 1 being passed
    // down the diagonal.
    const double half = 0.5 * (d[high - 1] - d[high]), last = b[high - 1];
    const double shift = d[high] - last * last / (half + std::copysign(std::hypot(half, last), half));
    double x = d[low] - shift, z = b[low];
    for (std::size_t k = low; k < high; ++k) {
      const double length = std::hypot(x, z), c = length > 0 ? x / length : 1, s = length > 0 ? z / length : 0;
      if (k > low) b[k - 1] = length;
      const double first = d[k], second = d[k + 1], beside = b[k];
      d[k] = c * c * first + 2 * c * s * beside + s * s * second;
      d[k + 1] = s * s * first - 2 * c * s * beside + c * c * second;
      b[k] = c * s * (second - first) + (c * c - s * s) * beside;
      if (k + 1 < high) {
        x = b[k];
        z = s * b[k + 1];
        b[k + 1] *= c;
      }
      if (vectors == nullptr) continue;
      double* upper = vectors + k * size;
      double* lower = upper + size;
      for (std::size_t i = 0; i < size; ++i) {
        const double u = upper[i], v = lower[i];
        upper[i] = c * u + s * v;
        lower[i] = c * v - s * u;
      }
    }
  }
  std::copy_n(d, size, values);
  for (std::size_t i = 0; vectors != nullptr && i < size; ++i)
    from_reduced(vectors + i * size);
  return true;
}

}  // namespace orbicube::trust_region
