#include "projected_gradient/face_step.h"

#include <algorithm>
#include <cmath>

#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {

FaceStep::FaceStep(std::size_t n, std::pmr::memory_resource* memory)
    : moved_(n, 0.0, memory),
      projected_(n, 0.0, memory),
      direction_(n, 0.0, memory),
      curved_(n, 0.0, memory),
      model_gradient_(n, 0.0, memory) {}

// Moves target along direction_, which ends at projected_ and whose product with B is in curved_, to the model's
// minimum on [0, 1].
bool FaceStep::move(const FeasibleSet& set, std::span<double> target) {
  const double slope = dot(model_gradient_, direction_), bend = dot(direction_, curved_);
  if (!(slope < 0)) return false;
  const double length = bend > 0 ? std::min(1.0, -slope / bend) : 1.0;
  for (std::size_t j = 0; j < target.size(); ++j) {
    target[j] = length == 1 ? projected_[j] : clip(target[j] + length * direction_[j], set.lower()[j], set.upper()[j]);
    model_gradient_[j] += length * curved_[j];
  }
  return true;
}

// Whether the model's minimizer without bounds is within them; then it is the target.
bool FaceStep::step_freely(const FeasibleSet& set, HessianModel& model, std::span<const double> x,
                           std::span<const double> gradient, std::span<double> target, const base::Host& host) {
  if (!set.box()) return false;
  for (std::size_t j = 0; j < x.size(); ++j) {
    // Not where the gradient points out of a bound.
    if ((gradient[j] > 0 && x[j] == set.lower()[j]) || (gradient[j] < 0 && x[j] == set.upper()[j])) return false;
  }
  if (!model.minimise(gradient, direction_, host)) return false;
  for (std::size_t j = 0; j < x.size(); ++j) {
    target[j] = x[j] + direction_[j];
    if (!(target[j] >= set.lower()[j] && target[j] <= set.upper()[j])) return false;
  }
  return dot(gradient, direction_) < 0;
}

Projected FaceStep::find(FeasibleSet& set, HessianModel& model, std::span<const double> x,
                         std::span<const double> gradient, double projected_gradient, std::span<double> target,
                         const base::Host& host) {
  constexpr int round_limit = 8, shrink_limit = 3;
  constexpr double enough = 0.5;
  const std::size_t n = x.size();
  if (step_freely(set, model, x, gradient, target, host)) return Projected::done;
  model.prepare();
  std::copy(x.begin(), x.end(), target.begin());
  std::copy(gradient.begin(), gradient.end(), model_gradient_.begin());
  double curvature = model.sigma();

  for (int round = 0; round < round_limit; ++round) {
    // A projected gradient step. The Rayleigh quotient along it shortens one that is too long for the model and gives
    // the length of the next round's, which for a quadratic is the step of Barzilai and Borwein.
    for (int shrink = 0;; ++shrink) {
      for (std::size_t j = 0; j < n; ++j)
        moved_[j] = target[j] - model_gradient_[j] / curvature;
      if (const Projected p = set.project(moved_, projected_, 1 / curvature, host); p != Projected::done) return p;
      for (std::size_t j = 0; j < n; ++j)
        direction_[j] = projected_[j] - target[j];
      const double measure = max_magnitude(direction_) * std::max(1.0, curvature);
      if (round > 0 && measure <= enough * projected_gradient) return Projected::done;
      model.multiply(direction_, curved_, host);
      const double square = dot(direction_, direction_);
      if (square == 0) return Projected::done;
      const double rayleigh = dot(direction_, curved_) / square;
      const double length = -dot(model_gradient_, direction_) / (rayleigh * square);
      if (!(rayleigh > 0)) break;
      if (length >= 0.9 || shrink == shrink_limit) {
        curvature = rayleigh;
        break;
      }
      curvature = std::max(rayleigh, 2 * curvature);
    }
    if (!move(set, target)) return Projected::done;
    if (set.custom()) continue;

    host.report("model", static_cast<std::uint64_t>(round), round_limit);
    set.choose_face(target);
    if (set.free_count() == 0 || !model.enter_face(set, host)) continue;
    model.minimise_in_face(set, model_gradient_, direction_, host);
    host.report("model", static_cast<std::uint64_t>(round), round_limit);
    bool inside = true;
    for (std::size_t j = 0; j < n; ++j) {
      moved_[j] = target[j] + direction_[j];
      inside = inside && moved_[j] >= set.lower()[j] && moved_[j] <= set.upper()[j];
    }
    if (inside) {
      std::copy(moved_.begin(), moved_.end(), projected_.begin());
    } else {
      if (const Projected p = set.project(moved_, projected_, 0, host); p != Projected::done) return p;
      for (std::size_t j = 0; j < n; ++j)
        direction_[j] = projected_[j] - target[j];
    }
    model.multiply(direction_, curved_, host);
    move(set, target);
  }
  return Projected::done;
}

}  // namespace orbicube::projected_gradient
