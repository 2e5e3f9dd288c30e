#include "polycube/map/untangling.h"
#include "untangle/flip_bound.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "base/backtracking.h"

namespace orbicube::polycube {
namespace {

constexpr const char* phase = "map";

linear::SparseSystem make_system(const TiedMap& map, const TiedTriangles& triangles, const base::Host& host) {
  linear::SparseSystem::Triplets triplets(host.memory);
  triplets.reserve(21 * triangles.variables.size() + map.value.size());
  for (const auto& v : triangles.variables) {
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j <= i; ++j)
        triplets.emplace_back(static_cast<int>(std::max(v[i], v[j])), static_cast<int>(std::min(v[i], v[j])), 0.0);
    }
  }
  host.report(phase, 0, 0);
  return linear::SparseSystem(map.value.size(), triplets);
}

}  // namespace

Untangling::Untangling(TiedMap& map, const base::Host& host)
    : map_(map),
      host_(host),
      triangles_(map, host),
      system_(make_system(map, triangles_, host)),
      places_(triangles_.variables.size(), host.memory),
      diagonal_(map.value.size(), host.memory),
      gradient_(static_cast<Eigen::Index>(map.value.size())),
      direction_(map.value.size(), host.memory),
      trial_(map.value.size(), host.memory),
      longer_(map.value.size(), host.memory) {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto& v = triangles_.variables[i];
    std::size_t k = 0;
    for (std::size_t r = 0; r < 6; ++r) {
      for (std::size_t c = 0; c <= r; ++c)
        places_[i][k++] = static_cast<std::uint32_t>(system_.place(std::max(v[r], v[c]), std::min(v[r], v[c])));
    }
  }
  for (Index i = 0; i < diagonal_.size(); ++i)
    diagonal_[i] = static_cast<std::uint32_t>(system_.place(i, i));
}

double Untangling::chi(double determinant, double* derivative) const {
  if (eps_ <= 0) {
    *derivative = 1;
    return determinant;
  }
  const double root = std::sqrt(eps_ * eps_ + determinant * determinant);
  // Without cancellation on the negative side.
  const double value = determinant >= 0 ? 0.5 * (determinant + root) : 0.5 * eps_ * eps_ / (root - determinant);
  *derivative = value / root;
  return value;
}

double Untangling::min_determinant() {
  double least = std::numeric_limits<double>::infinity();
  flipped_ = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double d = triangles_.jacobian(map_.value, i).determinant();
    least = std::min(least, d);
    flipped_ += !(d > 0);
  }
  return least;
}

double Untangling::energy(std::span<const double> value) const {
  double sum = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Eigen::Matrix2d j = triangles_.jacobian(value, i);
    const double d = j.determinant();
    if (eps_ <= 0 && !(d > 0)) return std::numeric_limits<double>::infinity();
    double derivative = 0;
    sum += triangles_.weight[i] * 0.5 * (j.squaredNorm() + lambda_ * (d * d + 1)) / chi(d, &derivative);
  }
  return sum;
}

double Untangling::assemble() {
  gradient_.setZero();
  std::fill_n(system_.values(), system_.value_count(), 0.0);
  double sum = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (i % 8192 == 0) host_.report(phase, 0, 0);
    const Eigen::Matrix2d j = triangles_.jacobian(map_.value, i);
    const double d = j.determinant();
    double derivative = 0;
    const double x = chi(d, &derivative);
    const double t = derivative / x;
    const double squares = j.squaredNorm();
    const double weight = triangles_.weight[i];
    sum += weight * 0.5 * (squares + lambda_ * (d * d + 1)) / x;
    const Eigen::Vector4d a(j(0, 0), j(0, 1), j(1, 0), j(1, 1));
    const Eigen::Vector4d c(j(1, 1), -j(1, 0), -j(0, 1), j(0, 0));
    const Eigen::Vector4d g = a / x + (lambda_ * d / x - 0.5 * (squares + lambda_ * (d * d + 1)) * t / x) * c;
    const double q = t * t * squares + lambda_ * ((1 - d * t) * (1 - d * t) + t * t);
    const Eigen::Matrix4d block =
        (Eigen::Matrix4d::Identity() - t * (c * a.transpose() + a * c.transpose()) + q * c * c.transpose()) / x;
    Eigen::Matrix<double, 4, 6> b = Eigen::Matrix<double, 4, 6>::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2d& hat = triangles_.gradients[i][k];
      const auto column = static_cast<Eigen::Index>(2 * k);
      b.block<2, 1>(0, column) = triangles_.sign[i] * hat;
      b.block<2, 1>(2, column + 1) = hat;
    }
    const Eigen::Matrix<double, 6, 1> local_gradient = weight * (b.transpose() * g);
    const Eigen::Matrix<double, 6, 6> local = weight * (b.transpose() * block * b);
    const auto& v = triangles_.variables[i];
    std::size_t k = 0;
    for (std::size_t r = 0; r < 6; ++r) {
      gradient_[v[r]] += local_gradient[static_cast<Eigen::Index>(r)];
      for (std::size_t s = 0; s <= r; ++s) {
        // Two corners that share a variable stand for two entries of the diagonal.
        const double entry = local(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(s));
        system_.values()[places_[i][k++]] += r != s && v[r] == v[s] ? 2 * entry : entry;
      }
    }
  }
  return sum;
}

// Up to 0.9 of the way to where the first triangle loses its area: the smallest positive root of each determinant.
double Untangling::longest_positive_step() const {
  double longest = 1;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Eigen::Matrix2d j = triangles_.jacobian(map_.value, i), k = triangles_.jacobian(direction_, i);
    longest = std::min(longest, 0.9 * untangle::first_degenerate_step(j, k));
  }
  return longest;
}

// Returns by which part of itself the energy fell; 0 when no step lowers it.
double Untangling::step() {
  ++steps_taken_;
  const double before = assemble();
  double largest = 0;
  for (const std::uint32_t place : diagonal_) {
    double& entry = system_.values()[place];
    largest = std::max(largest, entry);
    entry += 1e-10 + 1e-9 * entry;
  }
  host_.report(phase, 0, 0);
  bool solved = system_.factorize();
  Eigen::VectorXd x;
  if (solved) {
    x = -system_.solve(gradient_);
    solved = x.allFinite() && gradient_.dot(x) < 0;
  }
  if (!solved) x = -gradient_ / std::max(largest, 1e-300);
  const double slope = gradient_.dot(x);
  std::copy(x.begin(), x.end(), direction_.begin());
  const double longest = eps_ <= 0 ? longest_positive_step() : 1;

  const auto move = [&](double by, Array<double>& to) {
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] = map_.value[i] + by * direction_[i];
    return energy(to);
  };
  const auto energy_after = [&](double by) {
    host_.report(phase, 0, 0);
    return move(by, trial_);
  };
  const auto taken = base::backtrack(before, slope, {.first_length = longest, .max_trials = 30}, energy_after);
  if (!taken) return 0;
  double length = taken->length, after = taken->value;
  for (int k = 0; k < 3 && eps_ > 0 && taken->trials == 1; ++k) {
    length *= 2;
    const double farther = move(length, longer_);
    if (!(farther < after)) break;
    after = farther;
    std::swap(trial_, longer_);
  }
  std::swap(map_.value, trial_);
  return (before - after) / std::max(std::abs(before), 1e-300);
}

bool Untangling::untangle(const UntanglingLimits& limits) {
  lambda_ = limits.area_weight;
  double least = min_determinant();
  if (least > 0) return true;
  constexpr int steps_an_eps = 6;
  constexpr double little = 2e-3;
  constexpr double min_eps = 1e-9;
  constexpr int patience = 25;  // values of eps without fewer triangles flipped
  eps_ = limits.first_eps > 0 ? limits.first_eps : std::clamp(0.2 * std::abs(least) + 1e-3, 0.05, 1.0);
  int stalled = 0;
  std::size_t fewest = flipped_;
  for (int done = 0; done < limits.steps;) {
    const double before = energy(map_.value);
    for (int i = 0; i < steps_an_eps && done < limits.steps; ++i, ++done) {
      if (step() < little) break;
    }
    ++done;
    const double after = energy(map_.value);
    least = min_determinant();
    if (least > 0) break;
    stalled = flipped_ < fewest ? 0 : stalled + 1;
    fewest = std::min(fewest, flipped_);
    if (stalled > patience) break;
    // The next eps of Garanzha et al., but never more than 0.6 of this one.
    double derivative = 0;
    const double gain = std::max(1 - after / before, 0.1);
    const double floor = (1 - gain) * chi(least, &derivative);
    const double next = least < floor ? 2 * std::sqrt(floor * (floor - least)) : min_eps;
    eps_ = std::max(std::min(next, 0.6 * eps_), min_eps);
  }
  return least > 0;
}

void Untangling::polish(int steps, double area_weight) {
  constexpr double little = 1e-5;
  eps_ = 0;
  lambda_ = area_weight;
  for (int i = 0; i < steps; ++i) {
    if (step() < little) break;
  }
  min_determinant();
}

}  // namespace orbicube::polycube
