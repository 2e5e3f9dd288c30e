#include "trust_region/variables.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/hash.h"
#include "base/infinity.h"
#include "trust_region/dense.h"

namespace orbicube::trust_region {
using base::require;

namespace {

// A box wider than this many times the start, or 1, stands for no bounds at all.
constexpr double widest_box = 1e12;
// Widths of boxes that differ by more, and boxes narrower than this, are scaled; others are alike, and radii are
// lengths of the unknowns as they are.
constexpr double alike_boxes = 10, narrow_box = 0.01;
// Without boxes only the start indicates magnitudes, and an entry near zero indicates little.
constexpr double alike_starts = 1e4;
// Entries of the start that are smaller in relation to the largest are zero but for rounding.
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
constexpr double min_scale = 1e-100, max_scale = 1e100;

bool usable(double magnitude) {
  return magnitude >= min_scale && magnitude <= max_scale;
}

}  // namespace

Variables::Variables(const Problem& problem, std::span<const double> start, bool radius_given,
                     std::pmr::memory_resource* memory)
    : full_lower_(memory),
      full_upper_(memory),
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
  require(problem.objective >= Objective::sum_of_squares && problem.objective <= Objective::max_value,
          "unknown objective");
  require(problem.objective == Objective::sum_of_squares || (problem.residuals > 0 && problem.sign.empty()),
          "an objective other than the sum of squares needs residuals, without signs");
  require(problem.sign.empty() || problem.sign.size() == problem.residuals, "there must be one sign a residual");
  for (const double sign : problem.sign)
    require(sign == 1 || sign == -1, "a sign must be 1 or -1");
  full_lower_.assign(n, -std::numeric_limits<double>::infinity());
  full_upper_.assign(n, std::numeric_limits<double>::infinity());
  std::copy(problem.lower.begin(), problem.lower.end(), full_lower_.begin());
  std::copy(problem.upper.begin(), problem.upper.end(), full_upper_.begin());
  free_.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    require(full_lower_[i] <= full_upper_[i], "a lower bound is above its upper bound, or not a number");
    require(full_lower_[i] < std::numeric_limits<double>::infinity() &&
                full_upper_[i] > -std::numeric_limits<double>::infinity(),
            "a lower bound is base::infinity or an upper bound -base::infinity");
    require(problem.scale.empty() || (problem.scale[i] >= 1e-150 && problem.scale[i] <= 1e150),
            "a scale must be from 1e-150 to 1e150");
    if (full_lower_[i] < full_upper_[i]) free_.push_back(static_cast<std::uint32_t>(i));
  }
  lower_.resize(free_.size());
  upper_.resize(free_.size());
  scale_.resize(free_.size());
  choose_scale(problem, start, radius_given);
  for (std::size_t k = 0; k < free_.size(); ++k) {
    lower_[k] = full_lower_[free_[k]] / scale_[k];
    upper_[k] = full_upper_[free_[k]] / scale_[k];
    require(std::isfinite(lower_[k]) == std::isfinite(full_lower_[free_[k]]) &&
                std::isfinite(upper_[k]) == std::isfinite(full_upper_[free_[k]]),
            "a bound over its scale is beyond the range of double");
    bounded_ = bounded_ || std::isfinite(lower_[k]) || std::isfinite(upper_[k]);
  }
  base::Hash hash;
  const std::uint64_t sizes[] = {n, problem.residuals};
  hash.add(std::as_bytes(std::span(sizes)));
  for (const auto* array : {&full_lower_, &full_upper_})
    hash.add(std::as_bytes(std::span(*array)));
  hash.add(std::as_bytes(problem.scale));
  hash.add(std::as_bytes(problem.sign));
  hash.add(std::as_bytes(std::span(&problem.objective, 1)));
  fingerprint_ = hash.value();
}

// The caller's scale. Without one: 1 where the unknowns are alike; else the widths of the boxes, and for unknowns
// without a box how far the start is from zero or from its bound. A first radius that the caller gives is a length of
// the unknown with the narrowest box.
void Variables::choose_scale(const Problem& problem, std::span<const double> start, bool radius_given) {
  std::fill(scale_.begin(), scale_.end(), 1.0);
  if (!problem.scale.empty()) {
    for (std::size_t k = 0; k < free_.size(); ++k)
      scale_[k] = problem.scale[free_[k]];
    return;
  }
  const auto width = [&](std::size_t k) {
    const double across = full_upper_[free_[k]] - full_lower_[free_[k]];
    const double from = start.empty() ? 0.0 : std::abs(start[free_[k]]);
    return usable(across) && across <= widest_box * std::max(1.0, from) ? across : 0.0;
  };
  double largest_start = 0;
  for (const double x : start)
    largest_start = std::max(largest_start, std::abs(x));
  // One bound has information unless it is 0 or infinite.
  const auto has_bound = [&](std::size_t k) {
    for (const double bound : {full_lower_[free_[k]], full_upper_[free_[k]]}) {
      if (bound != 0 && std::abs(bound) <= widest_box) return true;
    }
    return false;
  };
  const auto reach = [&](std::size_t k) {  // of the start, 0 when it says nothing
    if (start.empty()) return 0.0;
    double far = std::abs(start[free_[k]]);
    for (const double bound : {full_lower_[free_[k]], full_upper_[free_[k]]}) {
      const double away = std::abs(start[free_[k]] - bound);
      if (std::abs(bound) <= widest_box * std::max(1.0, std::abs(start[free_[k]]))) far = std::max(far, away);
    }
    return usable(far) && (has_bound(k) || far > rounding * std::min(1.0, largest_start)) ? far : 0.0;
  };
  double narrowest = base::infinity, narrowest_box = base::infinity, widest = 0, least = base::infinity, most = 0;
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const double box = width(k), magnitude = box > 0 ? box : reach(k);
    if (box == 0 && magnitude > 0 && has_bound(k)) narrowest = std::min(narrowest, magnitude);
    if (box > 0) {
      narrowest_box = std::min(narrowest_box, box);
      narrowest = std::min(narrowest, box);
      widest = std::max(widest, box);
    }
    least = std::min(least, magnitude > 0 ? magnitude : 1.0);
    most = std::max(most, magnitude > 0 ? magnitude : 1.0);
  }
  const bool unlike_boxes = widest > alike_boxes * narrowest_box;
  if (radius_given) {
    if (!unlike_boxes) return;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      if (const double box = width(k); box > 0) scale_[k] = box / narrowest_box;
    }
    return;
  }
  if (!unlike_boxes && !(narrowest < narrow_box) && !(most > alike_starts * least)) return;
  scaled_by_boxes_ = true;
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const double box = width(k), magnitude = box > 0 ? box : reach(k);
    if (magnitude > 0) scale_[k] = magnitude;
  }
}

void Variables::allow_turns() {
  const std::size_t n = free_.size();
  if (bounded_ || n > max_turned || !turn_.empty()) return;
  turn_.assign(n * n, 0.0);
  turn_work_.assign(n * n, 0.0);
  for (std::size_t k = 0; k < n; ++k)
    turn_[k * n + k] = 1;
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

double Variables::normalize(Tridiagonal& solver, double* work) {
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
