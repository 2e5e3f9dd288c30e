#include "harmonics/scattered/kernel_sums.h"

#include "base/vector_variants.h"

namespace orbicube::harmonics {
namespace {

using base::Four, base::load, base::store;

constexpr std::size_t parts = kernel_width / 4;
static_assert(parts == 4);

ORBICUBE_INLINE Four reversed(Four a) {
  return __builtin_shufflevector(a, a, 3, 2, 1, 0);
}

// The kernel at the lines around a point.
ORBICUBE_INLINE void kernel_values(const SpreadingKernel::Powers& powers, double x, Four (&values)[parts]) {
  constexpr std::size_t n = SpreadingKernel::power_count;
  const double square = x * x;
  Four odd[2], even[2];
  for (std::size_t half = 0; half < 2; ++half) {
    odd[half] = load(powers[0].data() + 4 * half);
    even[half] = load(powers[1].data() + 4 * half);
    for (std::size_t p = 2; p < n; p += 2) {
      odd[half] = odd[half] * square + load(powers[p].data() + 4 * half);
      even[half] = even[half] * square + load(powers[p + 1].data() + 4 * half);
    }
    odd[half] *= x;
  }
  values[0] = even[0] + odd[0];
  values[1] = even[1] + odd[1];
  values[2] = reversed(even[1] - odd[1]);
  values[3] = reversed(even[0] - odd[0]);
}

}  // namespace

ORBICUBE_VECTOR_VARIANTS
void interpolate(const SpreadingKernel& kernel, std::span<const GridPoint> points, const GridRows<const double>& rows,
                 std::size_t channels, double* values) {
  const SpreadingKernel::Powers& powers = kernel.powers();
  for (const GridPoint& p : points) {
    Four row[parts], column[parts], sum[parts]{};
    kernel_values(powers, p.row, row);
    kernel_values(powers, p.column, column);
    double of_row[kernel_width];
    for (std::size_t k = 0; k < parts; ++k)
      store(of_row + 4 * k, row[k]);
    const double* from = rows.origin + (p.first_row - rows.first) * rows.stride + p.first_column;
    for (std::size_t r = 0; r < kernel_width; ++r, from += rows.stride) {
      for (std::size_t k = 0; k < parts; ++k)
        sum[k] += of_row[r] * load(from + 4 * k);
    }
    const Four all = (sum[0] * column[0] + sum[1] * column[1]) + (sum[2] * column[2] + sum[3] * column[3]);
    values[p.index * channels] = (all[0] + all[1]) + (all[2] + all[3]);
  }
}

ORBICUBE_VECTOR_VARIANTS
void spread(const SpreadingKernel& kernel, std::span<const GridPoint> points, const double* values,
            std::size_t channels, const double* weights, const GridRows<double>& rows) {
  const SpreadingKernel::Powers& powers = kernel.powers();
  for (const GridPoint& p : points) {
    Four row[parts], column[parts];
    kernel_values(powers, p.row, row);
    kernel_values(powers, p.column, column);
    const double value = values[p.index * channels] * (weights != nullptr ? weights[p.index] : 1);
    double of_row[kernel_width];
    for (std::size_t k = 0; k < parts; ++k)
      store(of_row + 4 * k, row[k] * value);
    double* to = rows.origin + (p.first_row - rows.first) * rows.stride + p.first_column;
    for (std::size_t r = 0; r < kernel_width; ++r, to += rows.stride) {
      for (std::size_t k = 0; k < parts; ++k)
        store(to + 4 * k, load(to + 4 * k) + of_row[r] * column[k]);
    }
  }
}

}  // namespace orbicube::harmonics
