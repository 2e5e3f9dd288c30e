#include "harmonics/rotations/wigner.h"

#include <cmath>
#include <numbers>

namespace orbicube::harmonics {
namespace {

// d^l_mn for l = m, ..., degree, where m >= |n|, times `factor`, added to `to`.
void add_wigner(double beta, std::int32_t m, std::int32_t n, std::uint32_t degree, double factor, double* to) {
  const double c = std::cos(beta / 2), s = std::sin(beta / 2), cosine = std::cos(beta);
  // The start, as a product whose parts are never far from its value.
  double value = 1;
  for (std::int32_t k = 1; k <= m - n; ++k)
    value *= -s * std::sqrt((m + n + double(k)) / k);
  value *= std::pow(c, m + n);
  double before = 0;
  const double mm = double(m) * m, nn = double(n) * n;
  for (std::uint32_t degree_now = static_cast<std::uint32_t>(m);; ++degree_now) {
    *to++ += factor * value;
    if (degree_now == degree) return;
    const double l = degree_now, up = l + 1;
    const double root = std::sqrt((up * up - mm) * (up * up - nn));
    const double next = l == 0 ? cosine
                               : up *
                                     ((2 * l + 1) * (cosine - m * double(n) / (l * up)) * value -
                                      std::sqrt((l * l - mm) * (l * l - nn)) / l * before) /
                                     root;
    before = value;
    value = next;
  }
}

}  // namespace

void rotation_about_y(double beta, std::uint32_t m, std::uint32_t n, std::uint32_t degree, double* even, double* odd) {
  const auto i = static_cast<std::int32_t>(m), j = static_cast<std::int32_t>(n);
  for (std::uint32_t l = m; l <= degree; ++l)
    even[l - m] = odd[l - m] = 0;
  const double sign_m = m % 2 == 0 ? 1 : -1, sign_both = (m + n) % 2 == 0 ? 1 : -1;
  if (n == 0) {
    add_wigner(beta, i, 0, degree, m == 0 ? 1 : sign_m * std::numbers::sqrt2, even);
    return;
  }
  add_wigner(beta, i, -j, degree, sign_m, odd);
  add_wigner(beta, i, j, degree, sign_both, even);
  for (std::uint32_t l = m; l <= degree; ++l) {
    const double same = even[l - m], opposite = odd[l - m];
    even[l - m] = same + opposite;
    odd[l - m] = same - opposite;
  }
}

}  // namespace orbicube::harmonics
