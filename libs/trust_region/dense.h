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

// The same, the terms added one after the other as by two calls of add_scaled.
inline void add_one_after_other(double* __restrict to, double first, const double* __restrict a, double second,
                                const double* __restrict b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    to[i] = (to[i] + first * a[i]) + second * b[i];
}

// That for two rows at once.
inline void add_two_to_two(double* __restrict upper, double f0, double f1, double* __restrict lower, double g0,
                           double g1, const double* __restrict a, const double* __restrict b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    upper[i] = (upper[i] + f0 * a[i]) + f1 * b[i];
    lower[i] = (lower[i] + g0 * a[i]) + g1 * b[i];
  }
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

// C (rows x columns) += factor A B, A with `inner` columns, all with rows `stride` apart. The terms of an entry are
// added one after the other; two rows and four terms at a time, so that little is read and written more than once.
inline void add_product(double* __restrict c, double factor, const double* __restrict a, const double* __restrict b,
                        std::size_t stride, std::size_t rows, std::size_t inner, std::size_t columns) {
  std::size_t k = 0;
  for (; k + 4 <= inner; k += 4) {
    const double* b0 = b + k * stride;
    const double* b1 = b0 + stride;
    const double* b2 = b1 + stride;
    const double* b3 = b2 + stride;
    std::size_t i = 0;
    for (; i + 2 <= rows; i += 2) {
      const double* f = a + i * stride + k;
      const double* g = f + stride;
      const double f0 = factor * f[0], f1 = factor * f[1], f2 = factor * f[2], f3 = factor * f[3];
      const double g0 = factor * g[0], g1 = factor * g[1], g2 = factor * g[2], g3 = factor * g[3];
      double* __restrict first = c + i * stride;
      double* __restrict second = first + stride;
      for (std::size_t j = 0; j < columns; ++j) {
        first[j] = (((first[j] + f0 * b0[j]) + f1 * b1[j]) + f2 * b2[j]) + f3 * b3[j];
        second[j] = (((second[j] + g0 * b0[j]) + g1 * b1[j]) + g2 * b2[j]) + g3 * b3[j];
      }
    }
    for (; i < rows; ++i) {
      for (std::size_t term = k; term < k + 4; ++term)
        add_scaled(c + i * stride, factor * a[i * stride + term], b + term * stride, columns);
    }
  }
  for (; k < inner; ++k) {
    for (std::size_t i = 0; i < rows; ++i)
      add_scaled(c + i * stride, factor * a[i * stride + k], b + k * stride, columns);
  }
}

// The lower triangle of A (size x size) = sum_k factor_k x_k x_k', rows x_k of `count` one after the other; what is
// above it is lost. Two rows and four terms at a time, as above.
inline void sum_of_squares_lower(double* __restrict a, std::size_t size, const double* __restrict factor,
                                 const double* __restrict x, std::size_t count) {
  for (std::size_t i = 0; i < size * size; ++i)
    a[i] = 0;
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {
    const double* x0 = x + k * size;
    const double* x1 = x0 + size;
    const double* x2 = x1 + size;
    const double* x3 = x2 + size;
    std::size_t i = 0;
    for (; i + 2 <= size; i += 2) {
      const double f0 = factor[k] * x0[i], f1 = factor[k + 1] * x1[i], f2 = factor[k + 2] * x2[i],
                   f3 = factor[k + 3] * x3[i];
      const double g0 = factor[k] * x0[i + 1], g1 = factor[k + 1] * x1[i + 1], g2 = factor[k + 2] * x2[i + 1],
                   g3 = factor[k + 3] * x3[i + 1];
      double* __restrict first = a + i * size;
      double* __restrict second = first + size;
      for (std::size_t j = 0; j < i + 2; ++j) {
        first[j] += (f0 * x0[j] + f1 * x1[j]) + (f2 * x2[j] + f3 * x3[j]);
        second[j] += (g0 * x0[j] + g1 * x1[j]) + (g2 * x2[j] + g3 * x3[j]);
      }
    }
    for (; i < size; ++i) {
      const double f0 = factor[k] * x0[i], f1 = factor[k + 1] * x1[i], f2 = factor[k + 2] * x2[i],
                   f3 = factor[k + 3] * x3[i];
      double* row = a + i * size;
      for (std::size_t j = 0; j <= i; ++j)
        row[j] += (f0 * x0[j] + f1 * x1[j]) + (f2 * x2[j] + f3 * x3[j]);
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
