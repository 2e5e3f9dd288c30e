#include "untangle/tetrahedra/newton.h"

#include <algorithm>
#include <cmath>

#include "base/backtracking.h"

namespace orbicube::untangle {
Newton::Newton(FoldoverEnergy& energy, std::span<const double> start, const base::Host& host)
    : energy_(energy),
      host_(host),
      values_(start.begin(), start.end(), host.memory),
      trial_(values_, host.memory),
      gradient_(energy.variables().free(), 0, host.memory),
      direction_(gradient_, host.memory) {
  // Whether there are inverted elements does not depend on eps.
  now_ = energy_.value(values_, 1);
}

void Newton::restart(std::span<const double> values) {
  values_.assign(values.begin(), values.end());
  trial_ = values_;
  now_ = energy_.value(values_, 1);
}

double Newton::step(double eps, const NewtonLimits& limits, EnergyValue& now) {
  ++steps_;
  energy_.linearise(values_, eps, gradient_);
  energy_.solve(gradient_, limits.products, limits.tolerance, direction_);
  double slope = 0;
  for (std::size_t i = 0; i < gradient_.size(); ++i)
    slope += gradient_[i] * direction_[i];
  if (!(slope < 0)) return 0;
  EnergyValue there{};
  const auto energy_after = [&](double length) {
    for (std::size_t i = 0; i < direction_.size(); ++i)
      trial_[i] = values_[i] + length * direction_[i];
    there = energy_.value(trial_, eps);
    return there.energy;
  };
  const auto taken = base::backtrack(now.energy, slope, {.max_trials = 30}, energy_after);
  if (!taken) return 0;
  std::swap(values_, trial_);
  now = there;
  return taken->length;
}

bool Newton::untangle(int max_steps, double max_eps, int patience, const NewtonLimits& limits) {
  constexpr double min_eps = 1e-9;
  constexpr double hopeless_eps = 1e-5;
  // Of eps, as a part of the way. After a whole step energies have little more to say, and steps are what takes time.
  constexpr double min_fall = 0.3;
  constexpr double least_short_fall = 0.1;
  constexpr int most_stuck = 8;
  constexpr double collapsed = 0.01;
  constexpr double little = 1e-3;
  if (now_.inverted == 0) return true;
  double& eps = eps_;
  eps = std::min(max_eps, std::hypot(1e-3, 0.2 * now_.min_determinant));
  int stuck = 0;
  for (int k = 0; k < max_steps; ++k) {
    host_.report("untangle", 0, 0, static_cast<double>(now_.inverted));
    now_ = energy_.value(values_, eps);
    const double before = now_.energy;
    double length = step(eps, limits, now_);
    if (now_.inverted == 0) return true;
    for (int i = 1; i < patience && k + 1 < max_steps && length > 0; ++i, ++k) {
      const double last = now_.energy;
      length = step(eps, limits, now_);
      if (now_.inverted == 0) return true;
      if (last - now_.energy < little * last) break;
    }
    const double sigma = std::max(length == 1 ? min_fall : least_short_fall, 1 - now_.energy / before);
    const double least = now_.min_determinant;
    const double m = std::hypot(least, eps);
    eps *= least < 0 ? 1 - sigma * m / (std::abs(least) + m) : 1 - sigma;
    eps = std::max(eps, min_eps);
    stuck = length < 1e-6 ? stuck + 1 : 0;
    if (stuck > most_stuck || (eps < hopeless_eps && k > 60)) return false;
    if (std::abs(now_.mean_determinant) < collapsed && std::abs(least) < collapsed) return false;
  }
  return false;
}

void Newton::polish(int max_steps, double min_gain, const NewtonLimits& limits) {
  constexpr double nearly_flat = 0.05;
  constexpr double fall = 0.5;
  const auto report = [&](int k) {
    host_.report("polish", static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(max_steps), now_.energy);
  };
  int k = 0;
  now_ = energy_.value(values_, 0);
  if (eps_ > 0 && now_.min_determinant < nearly_flat) {
    Array<double> best(values_, host_.memory);
    double least = now_.energy;
    for (double eps = eps_; k < max_steps / 2; ++k, eps *= fall) {
      report(k);
      now_ = energy_.value(values_, eps);
      if (step(eps, limits, now_) == 0) break;
      if (now_.inverted > 0) continue;
      const double energy = energy_.value(values_, 0).energy;
      if (energy < least) {
        least = energy;
        best = values_;
      }
      if (now_.min_determinant > nearly_flat) break;
    }
    values_ = best;
    now_ = energy_.value(values_, 0);
  }
  for (; k < max_steps; ++k) {
    report(k);
    const double before = now_.energy;
    step(0, limits, now_);
    if (before - now_.energy < min_gain * before) return;
  }
}

}  // namespace orbicube::untangle
