// The samples of a fit, checked.
#pragma once

#include <numbers>
#include <span>

#include "harmonics/fitting/fit.h"

namespace orbicube::harmonics {

struct FitSamples {
  std::span<const Vector3> directions;
  std::span<const double> weights, values;  // no weights: ones
  std::size_t channels;
  double total_weight;

  std::size_t count() const { return directions.size(); }
  double weight(std::size_t i) const { return weights.empty() ? 1 : weights[i]; }
};

// What the regularization adds to the diagonal of the normal equations, for each degree.
inline double regularization_penalty(const FitSamples& samples, const FitOptions& options, std::uint32_t l) {
  const double degree = l, laplacian = degree * (degree + 1);
  return options.regularization * samples.total_weight / (4 * std::numbers::pi) * laplacian * laplacian;
}

// The moments of the weights up to twice the degree of a fit: sum of w_i Y_lm(i).
Coefficients weight_moments(const FitSamples& samples, std::uint32_t degree, const base::Host& host);

}  // namespace orbicube::harmonics
