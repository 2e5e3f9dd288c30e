#include "trust_region/variables.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/hash.h"

namespace orbicube::trust_region {
using base::require;

Variables::Variables(const Problem& problem, std::pmr::memory_resource* memory)
    : full_lower_(memory),
      full_upper_(memory),
      full_scale_(memory),
      free_(memory),
      lower_(memory),
      upper_(memory),
      scale_(memory) {
  const std::size_t n = problem.n;
  const auto fits = [n](std::span<const double> a) { return a.empty() || a.size() == n; };
  require(n >= 1 && n <= 100000 && problem.residuals <= 100000000, "n must be from 1 to 100000");
  require(fits(problem.lower) && fits(problem.upper) && fits(problem.scale), "bounds and scale must have n entries");
  require(problem.sign.empty() || problem.sign.size() == problem.residuals, "there must be one sign a residual");
  for (const double sign : problem.sign)
    require(sign == 1 || sign == -1, "a sign must be 1 or -1");
  full_lower_.assign(n, -std::numeric_limits<double>::infinity());
  full_upper_.assign(n, std::numeric_limits<double>::infinity());
  full_scale_.assign(n, 1.0);
  std::copy(problem.lower.begin(), problem.lower.end(), full_lower_.begin());
  std::copy(problem.upper.begin(), problem.upper.end(), full_upper_.begin());
  std::copy(problem.scale.begin(), problem.scale.end(), full_scale_.begin());
  free_.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    require(full_lower_[i] <= full_upper_[i], "a lower bound is above its upper bound, or not a number");
    require(full_lower_[i] < std::numeric_limits<double>::infinity() &&
                full_upper_[i] > -std::numeric_limits<double>::infinity(),
            "a lower bound is infinity or an upper bound -infinity");
    require(full_scale_[i] > 0 && std::isfinite(full_scale_[i]), "a scale must be positive and finite");
    if (full_lower_[i] < full_upper_[i]) free_.push_back(static_cast<std::uint32_t>(i));
  }
  lower_.resize(free_.size());
  upper_.resize(free_.size());
  scale_.resize(free_.size());
  for (std::size_t k = 0; k < free_.size(); ++k) {
    scale_[k] = full_scale_[free_[k]];
    lower_[k] = full_lower_[free_[k]] / scale_[k];
    upper_[k] = full_upper_[free_[k]] / scale_[k];
    bounded_ = bounded_ || std::isfinite(lower_[k]) || std::isfinite(upper_[k]);
  }
  base::Hash hash;
  const std::uint64_t sizes[] = {n, problem.residuals};
  hash.add(std::as_bytes(std::span(sizes)));
  for (const auto* array : {&full_lower_, &full_upper_, &full_scale_})
    hash.add(std::as_bytes(std::span(*array)));
  hash.add(std::as_bytes(problem.sign));
  fingerprint_ = hash.value();
}

void Variables::to_free(std::span<const double> x, double* u) const {
  for (std::size_t k = 0; k < free_.size(); ++k)
    u[k] = x[free_[k]] / scale_[k];
}

void Variables::from_free(const double* u, std::span<double> x) const {
  std::copy(full_lower_.begin(), full_lower_.end(), x.begin());  // the fixed ones
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const double low = full_lower_[free_[k]], high = full_upper_[free_[k]], value = u[k] * scale_[k];
    x[free_[k]] = u[k] <= lower_[k] || value < low ? low : u[k] >= upper_[k] || value > high ? high : value;
  }
}

void Variables::clip(double* u) const {
  for (std::size_t k = 0; k < free_.size(); ++k)
    u[k] = u[k] < lower_[k] ? lower_[k] : u[k] > upper_[k] ? upper_[k] : u[k];
}

bool Variables::within_bounds(std::span<const double> x) const {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] >= full_lower_[i] && x[i] <= full_upper_[i])) return false;
  }
  return true;
}

}  // namespace orbicube::trust_region
