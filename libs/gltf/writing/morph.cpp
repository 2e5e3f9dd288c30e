#include "gltf/writing/morph.h"

#include <cmath>
#include <initializer_list>
#include <limits>

namespace orbicube::gltf {

float reconstructed(float base, float delta) {
  return base + delta;
}

double reconstructed_in_double(float base, float delta) {
  return static_cast<double>(base) + static_cast<double>(delta);
}

float delta_for(float base, float target) {
  // The difference of two floats as a double is exact or nearly so, and the sum grows with the delta: what sums up to
  // `target` is the float nearest to the difference or, where a tie is rounded to the wrong side, one beside it.
  const float nearest = static_cast<float>(static_cast<double>(target) - static_cast<double>(base));
  constexpr float infinity = std::numeric_limits<float>::infinity();
  float best = nearest;
  for (const float candidate : {std::nextafter(nearest, -infinity), std::nextafter(nearest, infinity)}) {
    const auto error_of = [&](float delta) {
      return std::abs(static_cast<double>(reconstructed(base, delta)) - static_cast<double>(target));
    };
    if (error_of(candidate) < error_of(best)) best = candidate;
  }
  return best;
}

}  // namespace orbicube::gltf
