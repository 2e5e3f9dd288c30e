#include "studies/rounding.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "base/hash.h"
#include "base/random.h"
#include "studies/kept_subject.h"

namespace orbicube::cli {
namespace {

// glibc's functions for processors with and without FMA differ at one argument of 1400 (sin, exp, pow) to 15,000
// (log10). Smaller: machines that differ may have one digest; larger: each run takes longer than 10 ms.
constexpr int argument_count = 1 << 14;

std::string digest() {
  base::Hash hash;
  base::Random random(1);
  for (int i = 0; i < argument_count; ++i) {
    // Not known to the compiler, which would round the values by itself.
    const double part = random.unit() + 0x1p-60, x = 2 * random.unit() - 1, y = 2 * random.unit() - 1;
    const std::array values = {std::sin(7 * x),  std::cos(7 * x),  std::tan(1.5 * x), std::asin(x),
                               std::acos(x),     std::atan2(y, x), std::exp(20 * x),  std::exp2(20 * x),
                               std::log(part),   std::log2(part),  std::log10(part),  std::pow(part, 4 * y),
                               std::cbrt(8 * x), std::hypot(x, y)};
    hash.add(std::as_bytes(std::span(values)));
  }
  return text_of_hash(hash.value());
}

}  // namespace

const std::string& rounding_digest() {
  static const std::string text = digest();
  return text;
}

}  // namespace orbicube::cli
