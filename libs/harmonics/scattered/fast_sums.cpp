#include "harmonics/scattered/fast_sums.h"

#include "harmonics/scattered/scattered_transform.h"

namespace orbicube::harmonics {

bool synthesise_fast(const Coefficients& coefficients, std::span<const Vector3> unit, std::span<double> values,
                     const char* phase, const base::Host& host) {
  if (!ScatteredTransform::pays(unit.size(), coefficients.degree)) return false;
  ScatteredTransform transform(unit, coefficients.degree, phase, host);
  for (std::size_t channel = 0; channel < coefficients.channels; ++channel)
    transform.synthesise(coefficients, channel, values);
  return true;
}

bool analyse_fast(std::span<const Vector3> unit, std::span<const double> weights, std::span<const double> values,
                  Coefficients& coefficients, const char* phase, const base::Host& host) {
  if (!ScatteredTransform::pays(unit.size(), coefficients.degree)) return false;
  ScatteredTransform transform(unit, coefficients.degree, phase, host);
  for (std::size_t channel = 0; channel < coefficients.channels; ++channel)
    transform.analyse(weights, values, channel, coefficients);
  return true;
}

}  // namespace orbicube::harmonics
