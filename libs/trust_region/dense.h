// The few dense kernels that the method needs, on row-major arrays: every sum in a fixed order (eight running sums,
// which compilers turn into vector instructions), so that results are the same bits wherever the arrays lie in memory.
// The larger ones are in dense.cpp, compiled for wide vectors as well.
#pragma once

#include <algorithm>
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

// Sum and largest of |a_i|; the sum alone says that one is not a number.
inline double sum_of_magnitudes(const double* a, std::size_t count) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> sum{};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k)
      sum[k] += std::abs(a[i + k]);
  }
  for (; i < count; ++i)
    sum[0] += std::abs(a[i]);
  return ((sum[0] + sum[4]) + (sum[1] + sum[5])) + ((sum[2] + sum[6]) + (sum[3] + sum[7]));
}

inline double max_magnitude(const double* a, std::size_t count) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> most{};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k)
      most[k] = std::max(most[k], std::abs(a[i + k]));
  }
  for (; i < count; ++i)
    most[0] = std::max(most[0], std::abs(a[i]));
  return *std::max_element(most.begin(), most.end());
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
void multiply(const double* a, std::size_t stride, std::size_t rows, std::size_t columns, const double* x, double* y);

// x'A x of a symmetric A.
double quadratic_form(const double* a, std::size_t size, const double* x);

// y = sum_k factor_k x_k, `count` rows x_k of `size` that start `stride` apart, added in their order. With a symmetric
// matrix of such rows this is its product with `factor`.
void combination(double* y, std::size_t size, const double* factor, const double* x, std::size_t stride,
                 std::size_t count);

// y += that.
void add_combination(double* y, std::size_t size, const double* factor, const double* x, std::size_t stride,
                     std::size_t count);

// |x_k - from|^2 of `count` rows x_k of `size` one after the other.
void squared_distances(const double* points, std::size_t size, std::size_t count, const double* from, double* squares);

// y = A x, A symmetric (size x size, rows `stride` apart); only its lower triangle is read.
void multiply_symmetric(const double* a, std::size_t stride, std::size_t size, const double* x, double* y);

// The lower triangle of A (size x size, rows `stride` apart) += first a' + second b', each of `size` entries.
void add_two_products_lower(double* matrix, std::size_t stride, std::size_t size, const double* first, const double* a,
                            const double* second, const double* b);

// A (size x size, rows `stride` apart) -= a b' + b a'.
void subtract_two_products(double* matrix, std::size_t stride, std::size_t size, const double* a, const double* b);

// The lower triangle of A (size x size, rows `stride` apart) += factor x x'.
void add_square_lower(double* a, std::size_t stride, std::size_t size, double factor, const double* x);

// C (rows x columns) += factor A B, A with `inner` columns, all with rows `stride` apart. The terms of an entry are
// added one after the other.
void add_product(double* c, double factor, const double* a, const double* b, std::size_t stride, std::size_t rows,
                 std::size_t inner, std::size_t columns);

// The lower triangle of A (size x size) = sum_k factor_k x_k x_k', rows x_k of `count` one after the other; what is
// above it is lost.
void sum_of_squares_lower(double* a, std::size_t size, const double* factor, const double* x, std::size_t count);

inline void mirror_lower(double* a, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      a[j * size + i] = a[i * size + j];
  }
}

}  // namespace orbicube::trust_region
