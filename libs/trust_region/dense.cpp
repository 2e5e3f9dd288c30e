#include "trust_region/dense.h"

#include "base/vector_variants.h"

namespace orbicube::trust_region {
namespace {

using base::Four, base::load, base::store;

// dot() of `rows` rows with x at the same time.
template <std::size_t rows>
ORBICUBE_INLINE void dots(const double* a, std::size_t stride, std::size_t columns, const double* x, double* y) {
  std::array<Four, rows> even{}, odd{};
  std::size_t j = 0;
  for (; j + 8 <= columns; j += 8) {
    const Four x0 = load(x + j), x1 = load(x + j + 4);
    for (std::size_t r = 0; r < rows; ++r) {
      even[r] += load(a + r * stride + j) * x0;
      odd[r] += load(a + r * stride + j + 4) * x1;
    }
  }
  if (j + 4 <= columns) {
    const Four x0 = load(x + j);
    for (std::size_t r = 0; r < rows; ++r)
      even[r] += load(a + r * stride + j) * x0;
    j += 4;
  }
  for (std::size_t r = 0; r < rows; ++r) {
    double rest = 0;
    for (std::size_t k = j; k < columns; ++k)
      rest += a[r * stride + k] * x[k];
    const Four sum = even[r] + odd[r];
    y[r] = (sum[0] + sum[1]) + (sum[2] + sum[3]) + rest;
  }
}

// `rows` rows of c += factor a b, columns by fours.
template <std::size_t rows>
ORBICUBE_INLINE void add_product_rows(double* c, double factor, const double* a, const double* b, std::size_t stride,
                                      std::size_t inner, std::size_t columns) {
  std::size_t j = 0;
  for (; j + 4 <= columns; j += 4) {
    std::array<Four, rows> sum;
    for (std::size_t r = 0; r < rows; ++r)
      sum[r] = load(c + r * stride + j);
    for (std::size_t k = 0; k < inner; ++k) {
      const Four from = load(b + k * stride + j);
      for (std::size_t r = 0; r < rows; ++r)
        sum[r] += (factor * a[r * stride + k]) * from;
    }
    for (std::size_t r = 0; r < rows; ++r)
      store(c + r * stride + j, sum[r]);
  }
  for (; j < columns; ++j) {
    for (std::size_t r = 0; r < rows; ++r) {
      double sum = c[r * stride + j];
      for (std::size_t k = 0; k < inner; ++k)
        sum += (factor * a[r * stride + k]) * b[k * stride + j];
      c[r * stride + j] = sum;
    }
  }
}

// sum + sum_k factor_k x_k for 4 `blocks` entries, rows of x `stride` apart.
template <std::size_t blocks>
ORBICUBE_INLINE std::array<Four, blocks> combine(const double* sum, std::size_t stride, const double* factor,
                                                 const double* x, std::size_t count) {
  std::array<Four, blocks> total;
  for (std::size_t t = 0; t < blocks; ++t)
    total[t] = load(sum + 4 * t);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t t = 0; t < blocks; ++t)
      total[t] += factor[k] * load(x + k * stride + 4 * t);
  }
  return total;
}

ORBICUBE_INLINE void combine_all(double* sum, std::size_t size, std::size_t stride, const double* factor,
                                 const double* x, std::size_t count) {
  if (size < 4) {
    for (std::size_t k = 0; k < count; ++k)
      add_scaled(sum, factor[k], x + k * stride, size);
    return;
  }
  // The last four are made from what they were before the others overlap them.
  const std::size_t last = size - 4;
  const bool rest = size % 4 != 0;
  std::array<Four, 1> end{};
  if (rest) end = combine<1>(sum + last, stride, factor, x + last, count);
  std::size_t j = 0;
  for (; j + 12 <= size; j += 12) {
    const std::array<Four, 3> total = combine<3>(sum + j, stride, factor, x + j, count);
    for (std::size_t t = 0; t < 3; ++t)
      store(sum + j + 4 * t, total[t]);
  }
  for (; j + 4 <= size; j += 4)
    store(sum + j, combine<1>(sum + j, stride, factor, x + j, count)[0]);
  if (rest) store(sum + last, end[0]);
}

// Rows i to i + 3 and 4 `blocks` columns from j on of sum_k factor_k x_k x_k', the terms one after the other.
template <std::size_t blocks>
ORBICUBE_INLINE void squares_tile(double* a, std::size_t size, const double* factor, const double* x, std::size_t count,
                                  std::size_t i, std::size_t j) {
  std::array<std::array<Four, blocks>, 4> sum{};
  for (std::size_t k = 0; k < count; ++k) {
    const double* point = x + k * size;
    std::array<Four, blocks> columns;
    for (std::size_t t = 0; t < blocks; ++t)
      columns[t] = factor[k] * load(point + j + 4 * t);
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t t = 0; t < blocks; ++t)
        sum[r][t] += point[i + r] * columns[t];
    }
  }
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t t = 0; t < blocks; ++t)
      store(a + (i + r) * size + j + 4 * t, sum[r][t]);
  }
}

// y += A x of the first `row` columns of rows `row` to `row` + 3 of a symmetric A and of what mirrors them; `sums` gets
// the rows' part, which is not yet in y.
ORBICUBE_INLINE void symmetric_rows(const double* a, std::size_t stride, std::size_t row, const double* x, double* y,
                                    double* sums) {
  std::array<Four, 4> sum{};
  const double* rows = a + row * stride;
  std::size_t j = 0;
  for (; j + 4 <= row; j += 4) {
    const Four from = load(x + j);
    std::array<Four, 4> part;
    for (std::size_t r = 0; r < 4; ++r) {
      const Four entries = load(rows + r * stride + j);
      sum[r] += entries * from;
      part[r] = x[row + r] * entries;
    }
    store(y + j, load(y + j) + ((part[0] + part[1]) + (part[2] + part[3])));
  }
  for (std::size_t r = 0; r < 4; ++r)
    sums[r] = (sum[r][0] + sum[r][1]) + (sum[r][2] + sum[r][3]);
}

}  // namespace

ORBICUBE_VECTOR_VARIANTS
void multiply(const double* a, std::size_t stride, std::size_t rows, std::size_t columns, const double* x, double* y) {
  std::size_t i = 0;
  for (; i + 2 <= rows; i += 2)
    dots<2>(a + i * stride, stride, columns, x, y + i);
  if (i < rows) dots<1>(a + i * stride, stride, columns, x, y + i);
}

ORBICUBE_VECTOR_VARIANTS
void combination(double* y, std::size_t size, const double* factor, const double* x, std::size_t stride,
                 std::size_t count) {
  std::memset(y, 0, size * sizeof *y);
  combine_all(y, size, stride, factor, x, count);
}

ORBICUBE_VECTOR_VARIANTS
double quadratic_form(const double* a, std::size_t size, const double* x) {
  double sum = 0;
  // Number of entries of A x at a time.
  constexpr std::size_t width = 48;
  std::array<double, width> y;
  for (std::size_t j = 0; j < size; j += width) {
    const std::size_t part = size - j < width ? size - j : width;
    std::memset(y.data(), 0, part * sizeof(double));
    combine_all(y.data(), part, size, x, a + j, size);
    sum += dot(x + j, y.data(), part);
  }
  return sum;
}

ORBICUBE_VECTOR_VARIANTS
void add_combination(double* y, std::size_t size, const double* factor, const double* x, std::size_t stride,
                     std::size_t count) {
  combine_all(y, size, stride, factor, x, count);
}

ORBICUBE_VECTOR_VARIANTS
void squared_distances(const double* points, std::size_t size, std::size_t count, const double* from, double* squares) {
  for (std::size_t k = 0; k < count; ++k) {
    const double* point = points + k * size;
    Four four{};
    std::size_t i = 0;
    for (; i + 4 <= size; i += 4) {
      const Four away = load(point + i) - load(from + i);
      four += away * away;
    }
    double sum = (four[0] + four[1]) + (four[2] + four[3]);
    for (; i < size; ++i) {
      const double away = point[i] - from[i];
      sum += away * away;
    }
    squares[k] = sum;
  }
}

ORBICUBE_VECTOR_VARIANTS
void subtract_two_products(double* __restrict matrix, std::size_t stride, std::size_t size, const double* __restrict a,
                           const double* __restrict b) {
  for (std::size_t i = 0; i < size; ++i)
    add_two_scaled(matrix + i * stride, -a[i], b, -b[i], a, size);
}

ORBICUBE_VECTOR_VARIANTS
void add_product(double* c, double factor, const double* a, const double* b, std::size_t stride, std::size_t rows,
                 std::size_t inner, std::size_t columns) {
  std::size_t i = 0;
  for (; i + 4 <= rows; i += 4)
    add_product_rows<4>(c + i * stride, factor, a + i * stride, b, stride, inner, columns);
  for (; i < rows; ++i)
    add_product_rows<1>(c + i * stride, factor, a + i * stride, b, stride, inner, columns);
}

ORBICUBE_VECTOR_VARIANTS
void add_square_lower(double* a, std::size_t stride, std::size_t size, double factor, const double* x) {
  std::size_t i = 0;
  for (; i + 4 <= size; i += 4) {
    double* rows = a + i * stride;
    for (std::size_t j = 0; j < i; j += 4) {
      const Four from = load(x + j);
      for (std::size_t r = 0; r < 4; ++r) {
        double* to = rows + r * stride + j;
        store(to, load(to) + (factor * x[i + r]) * from);
      }
    }
    for (std::size_t r = 0; r < 4; ++r)
      add_scaled(rows + r * stride + i, factor * x[i + r], x + i, r + 1);
  }
  for (; i < size; ++i)
    add_scaled(a + i * stride, factor * x[i], x, i + 1);
}

ORBICUBE_VECTOR_VARIANTS
void sum_of_squares_lower(double* a, std::size_t size, const double* factor, const double* x, std::size_t count) {
  if (size < 4) {
    std::memset(a, 0, size * size * sizeof *a);
    for (std::size_t k = 0; k < count; ++k)
      add_square_lower(a, size, size, factor[k], x + k * size);
    return;
  }
  // The last tiles begin where they fit, and make again what is there already.
  for (std::size_t row = 0; row < size; row += 4) {
    const std::size_t i = row + 4 <= size ? row : size - 4;
    std::size_t j = 0;
    for (; j + 8 < i + 4 && j + 12 <= size; j += 12)
      squares_tile<3>(a, size, factor, x, count, i, j);
    for (; j + 4 < i + 4 && j + 8 <= size; j += 8)
      squares_tile<2>(a, size, factor, x, count, i, j);
    for (; j < i + 4; j += 4)
      squares_tile<1>(a, size, factor, x, count, i, j + 4 <= size ? j : size - 4);
  }
}

ORBICUBE_VECTOR_VARIANTS
void multiply_symmetric(const double* a, std::size_t stride, std::size_t size, const double* x, double* y) {
  std::size_t i = 0;
  for (; i + 4 <= size; i += 4) {
    std::array<double, 4> sums;
    symmetric_rows(a, stride, i, x, y, sums.data());
    for (std::size_t r = 0; r < 4; ++r) {
      const double* row = a + (i + r) * stride + i;
      for (std::size_t t = 0; t < r; ++t) {
        sums[r] += row[t] * x[i + t];
        sums[t] += row[t] * x[i + r];
      }
      sums[r] += row[r] * x[i + r];
    }
    for (std::size_t r = 0; r < 4; ++r)
      y[i + r] = sums[r];
  }
  for (; i < size; ++i) {
    const double* row = a + i * stride;
    y[i] = dot(row, x, i) + row[i] * x[i];
    add_scaled(y, x[i], row, i);
  }
}

ORBICUBE_VECTOR_VARIANTS
void add_two_products_lower(double* matrix, std::size_t stride, std::size_t size, const double* first, const double* a,
                            const double* second, const double* b) {
  std::size_t i = 0;
  for (; i + 4 <= size; i += 4) {
    double* rows = matrix + i * stride;
    for (std::size_t j = 0; j < i; j += 4) {
      const Four from_a = load(a + j), from_b = load(b + j);
      for (std::size_t r = 0; r < 4; ++r) {
        double* to = rows + r * stride + j;
        store(to, load(to) + (first[i + r] * from_a + second[i + r] * from_b));
      }
    }
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t j = i; j <= i + r; ++j)
        rows[r * stride + j] += first[i + r] * a[j] + second[i + r] * b[j];
    }
  }
  for (; i < size; ++i)
    add_two_scaled(matrix + i * stride, first[i], a, second[i], b, i + 1);
}

}  // namespace orbicube::trust_region
