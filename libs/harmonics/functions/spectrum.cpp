#include "harmonics/functions/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbicube::harmonics {
namespace {

double degree_norm(const Coefficients& f, std::uint32_t l) {
  if (l > f.degree) return 0;
  double sum = 0;
  for (std::size_t k = std::size_t{l} * l * f.channels; k < basis_size(l) * f.channels; ++k)
    sum += f.values[k] * f.values[k];
  return std::sqrt(sum);
}

}  // namespace

void degree_norms(const Coefficients& coefficients, std::span<double> norms) {
  for (std::uint32_t l = 0; l <= coefficients.degree; ++l)
    norms[l] = degree_norm(coefficients, l);
}

double shape_distance(const Coefficients& f, const Coefficients& g, std::uint32_t first, std::uint32_t last) {
  double sum = 0;
  for (std::uint32_t l = first; l <= std::min(last, std::max(f.degree, g.degree)); ++l) {
    const double difference = degree_norm(f, l) - degree_norm(g, l);
    sum += difference * difference;
  }
  return sum;
}

double band_factor(const Band& band, std::uint32_t l) {
  const std::uint32_t outside = l < band.low ? band.low - l : l > band.high ? l - band.high : 0;
  if (outside == 0) return 1;
  if (outside > band.width) return 0;
  return 0.5 + 0.5 * std::cos(std::numbers::pi * outside / (band.width + 1.0));
}

void filter(Coefficients& coefficients, const Band& band, bool keep_mean) {
  for (std::uint32_t l = keep_mean ? 1 : 0; l <= coefficients.degree; ++l) {
    const double factor = band_factor(band, l);
    for (std::size_t k = std::size_t{l} * l * coefficients.channels; k < basis_size(l) * coefficients.channels; ++k)
      coefficients.values[k] *= factor;
  }
}

}  // namespace orbicube::harmonics
