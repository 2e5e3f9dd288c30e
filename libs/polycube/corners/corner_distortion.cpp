#include "polycube/corners/corner_distortion.h"
#include "untangle/flip_bound.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/backtracking.h"

namespace orbicube::polycube {
namespace {

constexpr const char* phase = "corners";
constexpr double infinity = std::numeric_limits<double>::infinity();

linear::SparseSystem make_system(const PlanarTriangles& triangles, std::size_t free, const base::Host& host) {
  linear::SparseSystem::Triplets triplets(host.memory);
  triplets.reserve(21 * triangles.size() + free);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& v = triangles.variables[t];
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

void PlanarTriangles::clear() {
  variables.clear();
  signs.clear();
  hats.clear();
  weights.clear();
}

void PlanarTriangles::add(const std::array<Vector3, 3>& space, const std::array<Index, 6>& coordinates,
                          const std::array<double, 6>& sign, double whole_area, double min_area) {
  // Slivers are widened a little, so that their hat functions stay finite.
  constexpr double min_height = 1e-7;
  const Vector3 first = space[1] - space[0], second = space[2] - space[0];
  const double longest =
      std::sqrt(std::max({first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm(), 1e-300}));
  const double base = std::max(first.norm(), min_height * longest);
  const double along = first.norm() > 0 ? second.dot(first) / first.norm() : 0;
  const double height = std::max(first.cross(second).norm() / base, min_height * longest);
  const Vector2d at_1(1 / base, -along / (base * height)), at_2(0, 1 / height);
  variables.push_back(coordinates);
  signs.push_back(sign);
  hats.push_back({Vector2d(-at_1 - at_2), at_1, at_2});
  weights.push_back(std::max(0.5 * base * height, min_area) / whole_area);
}

Eigen::Matrix2d PlanarTriangles::jacobian(std::span<const double> value, std::size_t triangle) const {
  Eigen::Matrix2d j = Eigen::Matrix2d::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector2d& hat = hats[triangle][k];
    j.row(0) += signs[triangle][2 * k] * value[variables[triangle][2 * k]] * hat.transpose();
    j.row(1) += signs[triangle][2 * k + 1] * value[variables[triangle][2 * k + 1]] * hat.transpose();
  }
  return j;
}

double PlanarTriangles::energy(std::span<const double> value, double area_weight) const {
  double sum = 0;
  for (std::size_t t = 0; t < size(); ++t) {
    const Eigen::Matrix2d j = jacobian(value, t);
    const double d = j.determinant();
    if (!(d > 0)) return infinity;
    sum += weights[t] * 0.5 * (j.squaredNorm() + area_weight * (d * d + 1)) / d;
  }
  return sum;
}

DistortionMinimum::DistortionMinimum(const PlanarTriangles& triangles, std::size_t free, double area_weight,
                                     std::span<double> value, const base::Host& host)
    : triangles_(triangles),
      free_(free),
      lambda_(area_weight),
      value_(value),
      host_(host),
      direction_(value.size(), 0.0, host.memory),
      trial_(value.begin(), value.end(), host.memory),
      places_(triangles.size(), host.memory),
      diagonal_(free, host.memory),
      system_(make_system(triangles, free, host)),
      gradient_(static_cast<Eigen::Index>(free)) {
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

double DistortionMinimum::chi(double determinant, double* derivative) const {
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

double DistortionMinimum::min_determinant(std::size_t* flipped) const {
  double least = infinity;
  *flipped = 0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const double d = triangles_.jacobian(value_, t).determinant();
    least = std::min(least, d);
    *flipped += !(d > 0);
  }
  return least;
}

double DistortionMinimum::energy_at(std::span<const double> value) const {
  if (eps_ <= 0) return triangles_.energy(value, lambda_);
  double sum = 0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Eigen::Matrix2d j = triangles_.jacobian(value, t);
    const double d = j.determinant();
    double derivative = 0;
    sum += triangles_.weights[t] * 0.5 * (j.squaredNorm() + lambda_ * (d * d + 1)) / chi(d, &derivative);
  }
  return sum;
}

// Up to 0.9 of the way to where the first triangle loses its area: the smallest positive root of each determinant.
double DistortionMinimum::longest_positive_step(std::span<const double> direction) const {
  double longest = 1;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Eigen::Matrix2d j = triangles_.jacobian(value_, t), k = triangles_.jacobian(direction, t);
    longest = std::min(longest, 0.9 * untangle::first_degenerate_step(j, k));
  }
  return longest;
}

// Adds the gradient and the block of a triangle, by the entries of its Jacobian, to those of the coordinates.
void DistortionMinimum::add_triangle(std::size_t t, const Eigen::Vector4d& g, const Eigen::Matrix4d& block) {
  const double weight = triangles_.weights[t];
  const auto& v = triangles_.variables[t];
  const auto& signs = triangles_.signs[t];
  Eigen::Matrix<double, 4, 6> b = Eigen::Matrix<double, 4, 6>::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto column = static_cast<Eigen::Index>(2 * k);
    b.block<2, 1>(0, column) = signs[2 * k] * triangles_.hats[t][k];
    b.block<2, 1>(2, column + 1) = signs[2 * k + 1] * triangles_.hats[t][k];
  }
  const Eigen::Matrix<double, 6, 1> local_gradient = weight * (b.transpose() * g);
  const Eigen::Matrix<double, 6, 6> local = weight * (b.transpose() * (block * b));
  std::size_t k = 0;
  for (std::size_t r = 0; r < 6; ++r) {
    if (v[r] < free_) gradient_[v[r]] += local_gradient[static_cast<Eigen::Index>(r)];
    for (std::size_t s = 0; s <= r; ++s, ++k) {
      if (v[r] >= free_ || v[s] >= free_) continue;
      // Two corners that share a coordinate stand for two entries of the diagonal.
      const double entry = local(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(s));
      system_.values()[places_[t][k]] += r != s && v[r] == v[s] ? 2 * entry : entry;
    }
  }
}

// Sets the gradient and the system; returns the energy.
double DistortionMinimum::assemble() {
  gradient_.setZero();
  std::fill_n(system_.values(), system_.value_count(), 0.0);
  double energy = 0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (t % 8192 == 0) host_.report(phase, 0, 0);
    const Eigen::Matrix2d j = triangles_.jacobian(value_, t);
    const double d = j.determinant();
    double derivative = 0;
    const double x = chi(d, &derivative);
    const double slope = derivative / x, squares = j.squaredNorm(), weight = triangles_.weights[t];
    energy += weight * 0.5 * (squares + lambda_ * (d * d + 1)) / x;
    const Eigen::Vector4d a(j(0, 0), j(0, 1), j(1, 0), j(1, 1));
    const Eigen::Vector4d c(j(1, 1), -j(1, 0), -j(0, 1), j(0, 0));
    const Eigen::Vector4d g = a / x + (lambda_ * d / x - 0.5 * (squares + lambda_ * (d * d + 1)) * slope / x) * c;
    const double q = slope * slope * squares + lambda_ * ((1 - d * slope) * (1 - d * slope) + slope * slope);
    const Eigen::Matrix4d block =
        (Eigen::Matrix4d::Identity() - slope * (c * a.transpose() + a * c.transpose()) + q * c * c.transpose()) / x;
    add_triangle(t, g, block);
  }
  return energy;
}

// Returns the step of Gauss-Newton, or one against the gradient where it is none that lowers the energy.
Eigen::VectorXd DistortionMinimum::descent_direction() {
  double largest = 0;
  for (const std::uint32_t place : diagonal_) {
    double& entry = system_.values()[place];
    largest = std::max(largest, entry);
    entry += 1e-12 + 1e-9 * entry;
  }
  host_.report(phase, 0, 0);
  bool solved = system_.factorize();
  Eigen::VectorXd x;
  if (solved) {
    x = -system_.solve(gradient_);
    solved = x.allFinite() && gradient_.dot(x) < 0;
  }
  if (!solved) x = -gradient_ / std::max(largest, 1e-300);
  return x;
}

// Returns by which part of itself the energy fell; 0 when no step lowers it.
double DistortionMinimum::step() {
  const double before = assemble();
  const Eigen::VectorXd x = descent_direction();
  const double descent = gradient_.dot(x);
  std::copy(x.begin(), x.end(), direction_.begin());
  const double longest = eps_ <= 0 ? longest_positive_step(direction_) : 1;
  const auto energy_after = [&](double length) {
    host_.report(phase, 0, 0);
    for (std::size_t i = 0; i < free_; ++i)
      trial_[i] = value_[i] + length * direction_[i];
    return energy_at(trial_);
  };
  const auto taken = base::backtrack(before, descent, {.first_length = longest, .max_trials = 25}, energy_after);
  if (!taken) return 0;
  std::copy_n(trial_.begin(), free_, value_.begin());
  return (before - taken->value) / std::max(std::abs(before), 1e-300);
}

bool DistortionMinimum::untangle(int steps) {
  std::size_t flipped = 0;
  double least = min_determinant(&flipped);
  constexpr int steps_an_eps = 4;
  constexpr double little = 2e-3;
  eps_ = std::clamp(0.2 * std::abs(least) + 1e-3, 0.05, 1.0);
  for (int done = 0; done < steps && !(least > 0); eps_ = std::max(0.4 * eps_, 1e-9)) {
    for (int i = 0; i < steps_an_eps && done < steps; ++i, ++done)
      if (step() < little) break;
    ++done;
    least = min_determinant(&flipped);
  }
  eps_ = 0;
  return least > 0;
}

double DistortionMinimum::minimise(int steps, double min_gain) {
  eps_ = 0;
  for (int i = 0; i < steps; ++i)
    if (!(step() >= min_gain)) break;
  return triangles_.energy(value_, lambda_);
}

}  // namespace orbicube::polycube
