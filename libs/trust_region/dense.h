// The few dense kernels that the method needs, on row-major arrays: every sum in a fixed order (eight running sums,
// which compilers turn into vector instructions), so that results are the same bits wherever the arrays lie in memory.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace orbicube::trust_region {

inline double dot(const double* a, const double* b, std::size_t count) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> sum{};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k)
      sum[k] += a[i + k] * b[i + k];
  }
  if (i + 4 <= count) {
    for (std::size_t k = 0; k < 4; ++k)
      sum[k] += a[i + k] * b[i + k];
    i += 4;
  }
  double rest = 0;
  for (; i < count; ++i)
    rest += a[i] * b[i];
  return ((sum[0] + sum[4]) + (sum[1] + sum[5])) + ((sum[2] + sum[6]) + (sum[3] + sum[7])) + rest;
}

inline double norm(const double* a, std::size_t count) {
  return std::sqrt(dot(a, a, count));
}

inline void add_scaled(double* __restrict to, double factor, const double* __restrict from, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    to[i] += factor * from[i];
}

inline void add_two_scaled(double* __restrict to, double first, const double* __restrict a, double second,
                           const double* __restrict b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    to[i] += first * a[i] + second * b[i];
}

// y = A x, A with `rows` rows of `columns` entries that start `stride` apart.
inline void multiply(const double* a, std::size_t stride, std::size_t rows, std::size_t columns, const double* x,
                     double* y) {
  for (std::size_t i = 0; i < rows; ++i)
    y[i] = dot(a + i * stride, x, columns);
}

// x'A x of a symmetric A.
inline double quadratic_form(const double* a, std::size_t size, const double* x) {
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i)
    sum += x[i] * dot(a + i * size, x, size);
  return sum;
}

// The lower triangle of A (size x size) += factor x x'.
inline void add_square_lower(double* a, std::size_t size, double factor, const double* x) {
  for (std::size_t i = 0; i < size; ++i)
    add_scaled(a + i * size, factor * x[i], x, i + 1);
}

// The lower triangle of A (size x size) = sum_k factor_k x_k x_k', rows x_k of `count` one after the other. Four at a
// time, so that A is read and written less often.
inline void sum_of_squares_lower(double* __restrict a, std::size_t size, const double* __restrict factor,
                                 const double* __restrict x, std::size_t count) {
  for (std::size_t i = 0; i < size * size; ++i)
    a[i] = 0;
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    const double* first = x + k * size;
    const double* second = first + size;
    const double* third = second + size;
    const double* fourth = third + size;
    for (std::size_t i = 0; i < size; ++i) {
      const double f = factor[k] * first[i], g = factor[k + 1] * second[i], h = factor[k + 2] * third[i],
                   l = factor[k + 3] * fourth[i];
      double* row = a + i * size;
      for (std::size_t j = 0; j <= i; ++j)
        row[j] += (f * first[j] + g * second[j]) + (h * third[j] + l * fourth[j]);
    }
  }
  for (; k < count; ++k)
    add_square_lower(a, size, factor[k], x + k * size);
}

inline void mirror_lower(double* a, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      a[j * size + i] = a[i * size + j];
  }
}

}  // namespace orbicube::trust_region
