// Sums over long vectors that are accurate and the same bits on every machine: blocks of 256 products in eight running
// sums (which compilers turn into vector instructions without reordering), the blocks added with Neumaier's
// compensation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace orbicube::base {

class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    correction_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + correction_; }

 private:
  double sum_ = 0, correction_ = 0;
};

// Sum of term(i) for i in [0, count).
template <class Term>
double blocked_sum(std::size_t count, const Term& term) {
  constexpr std::size_t lanes = 8, block = 256;
  CompensatedSum total;
  std::size_t i = 0;
  while (i < count) {
    const std::size_t end = std::min(count, i + block);
    std::array<double, lanes> lane{};
    for (; i + lanes <= end; i += lanes) {
      for (std::size_t k = 0; k < lanes; ++k)
        lane[k] += term(i + k);
    }
    for (std::size_t k = 0; i < end; ++i, ++k)
      lane[k] += term(i);
    total.add(((lane[0] + lane[4]) + (lane[1] + lane[5])) + ((lane[2] + lane[6]) + (lane[3] + lane[7])));
  }
  return total.value();
}

// 0 * inf and 0 * nan are nan, so one sum suffices.
inline bool all_finite(std::span<const double> v) {
  double sum = 0;
  for (const double value : v)
    sum += 0.0 * value;
  return sum == 0;
}

inline double dot(std::span<const double> a, std::span<const double> b) {
  return blocked_sum(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

}  // namespace orbicube::base
