#include "trust_region/variables.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/hash.h"
#include "trust_region/dense.h"

namespace orbicube::trust_region {
using base::require;

Variables::Variables(const Problem& problem, std::pmr::memory_resource* memory)
    : full_lower_(memory),
      full_upper_(memory),
      full_scale_(memory),
      free_(memory),
      lower_(memory),
      upper_(memory),
      scale_(memory),
      turn_(memory),
      turn_work_(memory) {
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
    require(full_scale_[i] >= 1e-150 && full_scale_[i] <= 1e150, "a scale must be from 1e-150 to 1e150");
    if (full_lower_[i] < full_upper_[i]) free_.push_back(static_cast<std::uint32_t>(i));
  }
  lower_.resize(free_.size());
  upper_.resize(free_.size());
  scale_.resize(free_.size());
  for (std::size_t k = 0; k < free_.size(); ++k) {
    scale_[k] = full_scale_[free_[k]];
    lower_[k] = full_lower_[free_[k]] / scale_[k];
    upper_[k] = full_upper_[free_[k]] / scale_[k];
    require(std::isfinite(lower_[k]) == std::isfinite(full_lower_[free_[k]]) &&
                std::isfinite(upper_[k]) == std::isfinite(full_upper_[free_[k]]),
            "a bound over its scale is beyond the range of double");
    bounded_ = bounded_ || std::isfinite(lower_[k]) || std::isfinite(upper_[k]);
  }
  if (!bounded_) {
    turn_.assign(free_.size() * free_.size(), 0.0);
    turn_work_.assign(free_.size() * free_.size(), 0.0);
    for (std::size_t k = 0; k < free_.size(); ++k)
      turn_[k * free_.size() + k] = 1;
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

void Variables::from_free(const double* u, std::span<double> x) {
  std::copy(full_lower_.begin(), full_lower_.end(), x.begin());  // the fixed ones
  if (turned_ != 0) {
    multiply(turn_.data(), free_.size(), free_.size(), free_.size(), u, turn_work_.data());
    for (std::size_t k = 0; k < free_.size(); ++k)
      x[free_[k]] = turn_work_[k] * scale_[k];
    return;
  }
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const double low = full_lower_[free_[k]], high = full_upper_[free_[k]], value = u[k] * scale_[k];
    x[free_[k]] = u[k] <= lower_[k] || value < low ? low : u[k] >= upper_[k] || value > high ? high : value;
  }
}

void Variables::transform(const double* inverse) {
  const std::size_t n = free_.size();
  std::copy(turn_.begin(), turn_.end(), turn_work_.begin());
  std::fill(turn_.begin(), turn_.end(), 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k)
      add_scaled(turn_.data() + i * n, turn_work_[i * n + k], inverse + k * n, n);
  }
  turned_ = 1;
}

double Variables::normalise(Tridiagonal& solver, double* work) {
  // The root of the largest eigenvalue of T T'.
  const std::size_t n = free_.size();
  for (std::size_t i = 0; i < n; ++i)
    multiply(turn_.data(), n, n, n, turn_.data() + i * n, solver.matrix() + i * n);
  if (!solver.eigen(n, work, nullptr)) return 1;
  const double stretch = std::sqrt(*std::max_element(work, work + n));
  for (double& entry : turn_)
    entry /= stretch;
  return stretch;
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
