// Random directions and coefficients for the tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "harmonics/functions/basis.h"
#include "harmonics/functions/coefficients.h"

namespace orbicube::harmonics {

class Samples {
 public:
  explicit Samples(std::uint64_t seed) : engine_(seed) {}

  double normal() {
    // Box and Muller's method: the standard's distribution is not the same on every machine.
    const double radius = std::sqrt(-2 * std::log(uniform())), angle = 2 * std::acos(-1.0) * uniform();
    return radius * std::cos(angle);
  }
  double uniform() { return (static_cast<double>(engine_() >> 11U) + 0.5) * 0x1p-53; }
  Vector3 direction() { return Vector3(normal(), normal(), normal()).normalized(); }
  std::vector<Vector3> directions(std::size_t count) {
    std::vector<Vector3> all(count);
    for (Vector3& d : all)
      d = direction();
    return all;
  }
  Coefficients coefficients(std::uint32_t degree, std::size_t channels) {
    Coefficients all(degree, channels, std::pmr::get_default_resource());
    for (double& c : all.values)
      c = normal();
    return all;
  }

 private:
  std::mt19937_64 engine_;
};

inline double max_difference(const Coefficients& a, const Coefficients& b) {
  double largest = a.values.size() == b.values.size() ? 0 : 1e300;
  for (std::size_t i = 0; i < a.values.size() && i < b.values.size(); ++i)
    largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
  return largest;
}

}  // namespace orbicube::harmonics
