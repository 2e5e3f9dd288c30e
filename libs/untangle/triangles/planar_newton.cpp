#include "untangle/triangles/planar_newton.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/backtracking.h"
#include "untangle/flip_bound.h"
#include "untangle/foldover.h"

namespace orbicube::untangle {
namespace {

constexpr double min_eps = 1e-9;

linear::SparseSystem make_system(const PlanarTriangles& triangles, std::size_t free, const char* phase,
                                 const base::Host& host) {
  linear::SparseSystem::Triplets triplets(host.memory);
  triplets.reserve(21 * triangles.size() + free);
  for (const auto& v : triangles.variables) {
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j <= i && v[i] < free; ++j)
        if (v[j] < free)
          triplets.emplace_back(static_cast<int>(std::max(v[i], v[j])), static_cast<int>(std::min(v[i], v[j])), 0.0);
    }
  }
  host.report(phase, 0, 0);
  return linear::SparseSystem(free, triplets);
}

}  // namespace

PlanarNewton::PlanarNewton(const PlanarTriangles& triangles, std::size_t free, const PlanarNewtonOptions& options,
                           const base::Host& host)
    : triangles_(triangles),
      free_(free),
      options_(options),
      host_(host),
      system_(make_system(triangles, free, options.phase, host)),
      places_(triangles.size(), host.memory),
      diagonal_(free, host.memory),
      gradient_(static_cast<Eigen::Index>(free)),
      direction_(host.memory),
      trial_(host.memory),
      farther_(host.memory) {
  for (std::size_t t = 0; t < places_.size(); ++t) {
    const auto& v = triangles.variables[t];
    std::size_t k = 0;
    for (std::size_t r = 0; r < 6; ++r) {
      for (std::size_t c = 0; c <= r; ++c, ++k) {
        if (v[r] < free && v[c] < free)
          places_[t][k] = static_cast<std::uint32_t>(system_.place(std::max(v[r], v[c]), std::min(v[r], v[c])));
      }
    }
  }
  for (Index i = 0; i < free; ++i)
    diagonal_[i] = static_cast<std::uint32_t>(system_.place(i, i));
}

double PlanarNewton::min_determinant(std::span<const double> values) {
  double least = std::numeric_limits<double>::infinity();
  flipped_ = 0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const double d = triangles_.jacobian(values, t).determinant();
    least = std::min(least, d);
    flipped_ += !(d > 0);
  }
  return least;
}

// Up to 0.9 of the way to where the first triangle loses its area: the smallest positive root of each determinant.
double PlanarNewton::longest_positive_step(std::span<const double> values) const {
  double longest = 1;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Eigen::Matrix2d j = triangles_.jacobian(values, t), k = triangles_.jacobian(direction_, t);
    longest = std::min(longest, 0.9 * first_degenerate_step(j, k));
  }
  return longest;
}

// Adds the derivatives of a triangle, by the entries of its Jacobian, to those of the variables.
void PlanarNewton::add_triangle(std::size_t t, const TriangleDerivatives& of) {
  const double weight = triangles_.weights[t];
  const auto& v = triangles_.variables[t];
  const auto& signs = triangles_.signs[t];
  Eigen::Matrix<double, 4, 6> b = Eigen::Matrix<double, 4, 6>::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto column = static_cast<Eigen::Index>(2 * k);
    b.block<2, 1>(0, column) = signs[2 * k] * triangles_.hats[t][k];
    b.block<2, 1>(2, column + 1) = signs[2 * k + 1] * triangles_.hats[t][k];
  }
  const Eigen::Matrix<double, 6, 1> local_gradient = weight * (b.transpose() * of.gradient);
  Eigen::Matrix<double, 6, 6> local;
  if (options_.left_product_first)
    local = weight * (b.transpose() * of.block * b);
  else
    local = weight * (b.transpose() * (of.block * b));
  std::size_t k = 0;
  for (std::size_t r = 0; r < 6; ++r) {
    if (v[r] < free_) gradient_[v[r]] += local_gradient[static_cast<Eigen::Index>(r)];
    for (std::size_t s = 0; s <= r; ++s, ++k) {
      if (v[r] >= free_ || v[s] >= free_) continue;
      // Two corners that share a variable stand for two entries of the diagonal.
      const double entry = local(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(s));
      system_.values()[places_[t][k]] += r != s && v[r] == v[s] ? 2 * entry : entry;
    }
  }
}

// Sets the gradient and the system; returns the energy.
double PlanarNewton::assemble(std::span<const double> values) {
  gradient_.setZero();
  std::fill_n(system_.values(), system_.value_count(), 0.0);
  double energy = 0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (t % 8192 == 0) host_.report(options_.phase, 0, 0);
    const Eigen::Matrix2d j = triangles_.jacobian(values, t);
    const double d = j.determinant();
    energy += triangles_.weights[t] * 0.5 * (j.squaredNorm() + lambda_ * (d * d + 1)) / chi_of(d, eps_).value;
    add_triangle(t, differentiate(j, eps_, lambda_));
  }
  return energy;
}

// The Newton direction, or one against the gradient where it is none that lowers the energy.
void PlanarNewton::set_direction() {
  double largest = 0;
  for (const std::uint32_t place : diagonal_) {
    double& entry = system_.values()[place];
    largest = std::max(largest, entry);
    entry += options_.shift + 1e-9 * entry;
  }
  host_.report(options_.phase, 0, 0);
  bool solved = system_.factorize();
  if (solved) {
    step_ = -system_.solve(gradient_);
    solved = step_.allFinite() && gradient_.dot(step_) < 0;
  }
  if (!solved) step_ = -gradient_ / std::max(largest, 1e-300);
  std::copy(step_.begin(), step_.end(), direction_.begin());
}

// Returns by which fraction of itself the energy fell; 0 when no step lowers it.
double PlanarNewton::step(std::span<double> values) {
  ++steps_;
  const double before = assemble(values);
  direction_.assign(values.size(), 0.0);
  trial_.assign(values.begin(), values.end());
  farther_.assign(values.begin(), values.end());
  set_direction();
  const double slope = gradient_.dot(step_);
  const double longest = eps_ <= 0 ? longest_positive_step(values) : 1;
  const auto move = [&](double length, Array<double>& to) {
    for (std::size_t i = 0; i < free_; ++i)
      to[i] = values[i] + length * direction_[i];
    return triangles_.energy(to, lambda_, eps_);
  };
  const auto energy_after = [&](double length) {
    host_.report(options_.phase, 0, 0);
    return move(length, trial_);
  };
  const auto taken =
      base::backtrack(before, slope, {.first_length = longest, .max_trials = options_.max_trials}, energy_after);
  if (!taken) return 0;
  double length = taken->length, after = taken->value;
  for (int k = 0; k < options_.max_doublings && eps_ > 0 && taken->trials == 1; ++k) {
    length *= 2;
    const double there = move(length, farther_);
    if (!(there < after)) break;
    after = there;
    std::swap(trial_, farther_);
  }
  std::copy_n(trial_.begin(), free_, values.begin());
  return (before - after) / std::max(std::abs(before), 1e-300);
}

// The next eps of Garanzha et al., but at most 0.6 of this one; `gain` is by which fraction the energy fell.
double PlanarNewton::next_eps(double least, double gain) const {
  const double floor = (1 - std::max(gain, 0.1)) * chi_of(least, eps_).value;
  const double next = least < floor ? 2 * std::sqrt(floor * (floor - least)) : min_eps;
  return std::max(std::min(next, 0.6 * eps_), min_eps);
}

bool PlanarNewton::untangle(std::span<double> values, const PlanarSchedule& schedule) {
  constexpr double little = 2e-3;
  lambda_ = schedule.area_weight;
  double least = min_determinant(values);
  eps_ = schedule.first_eps > 0 ? schedule.first_eps : std::clamp(0.2 * std::abs(least) + 1e-3, 0.05, 1.0);
  int stalled = 0;
  std::size_t fewest = flipped_;
  for (int done = 0; done < schedule.max_steps && !(least > 0);) {
    const double before = schedule.fall > 0 ? 1 : triangles_.energy(values, lambda_, eps_);
    for (int i = 0; i < schedule.steps_an_eps && done < schedule.max_steps; ++i, ++done) {
      if (step(values) < little) break;
    }
    ++done;
    const double after = schedule.fall > 0 ? 1 : triangles_.energy(values, lambda_, eps_);
    least = min_determinant(values);
    stalled = flipped_ < fewest ? 0 : stalled + 1;
    fewest = std::min(fewest, flipped_);
    if (stalled > schedule.patience) break;
    eps_ = schedule.fall > 0 ? std::max(schedule.fall * eps_, min_eps) : next_eps(least, 1 - after / before);
  }
  last_eps_ = eps_;
  eps_ = 0;
  return least > 0;
}

void PlanarNewton::settle(std::span<double> values, int max_steps, double area_weight) {
  constexpr double nearly_flat = 0.05;
  constexpr double fall = 0.5;
  lambda_ = area_weight;
  double least = min_determinant(values);
  if (!(last_eps_ > 0) || least > nearly_flat) return;
  Array<double> best(values.begin(), values.end(), host_.memory);
  double energy = triangles_.energy(values, lambda_);
  for (eps_ = last_eps_; max_steps > 0; --max_steps, eps_ *= fall) {
    if (step(values) == 0) break;
    const double now = triangles_.energy(values, lambda_);
    least = min_determinant(values);
    if (now < energy) {
      energy = now;
      best.assign(values.begin(), values.end());
    }
    if (least > nearly_flat) break;
  }
  eps_ = 0;
  std::copy(best.begin(), best.end(), values.begin());
}

void PlanarNewton::polish(std::span<double> values, int steps, double min_gain, double area_weight) {
  eps_ = 0;
  lambda_ = area_weight;
  for (int i = 0; i < steps; ++i) {
    if (!(step(values) >= min_gain)) break;
  }
}

}  // namespace orbicube::untangle
