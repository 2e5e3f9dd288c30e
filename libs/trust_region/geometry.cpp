// Geometry of the points: the one farthest from the best, where it is too far to be of use, is replaced by one that
// makes its Lagrange function large (Powell 2006, section 6; 2009, section 3 for boxes).
#include <algorithm>
#include <cmath>

#include "trust_region/dense.h"
#include "trust_region/solver.h"

namespace orbicube::trust_region {
namespace {

// Radii beyond which a point must be replaced: with 2n + 1 points as Powell, and where there are more for a model to
// hold on to.
constexpr double far_of_few = 2, far_of_many = 5;

}  // namespace

// Requests a point in place of the farthest, when that is too far from the best one.
Request Solver::improve_geometry() {
  const std::size_t n = variables_.free_size(), best = interpolation_.best();
  // A set that grows soon has near points enough.
  const double far = (growing() ? far_of_many : far_of_few) * state_.radius;
  std::size_t leaving = interpolation_.size();
  double away = 0;
  if (const std::size_t farthest = farthest_point(&away); away > far) leaving = farthest;
  if (leaving == interpolation_.size()) {
    state_.next = state_.reduce_after != 0 ? Next::reduce : Next::step;
    return Request::iteration;
  }
  if (!interpolation_.sound(leaving)) {
    // Made afresh; if that has been done, this says that the points are not poised.
    if (interpolation_.fresh()) return begin_around(interpolation_.size());
    state_.spoiled = 1;
    return Request::iteration;
  }
  // The largest |l| of the leaving point's Lagrange function, which is zero at the best point.
  const double radius = std::max(std::min(0.1 * far, 0.5 * state_.radius), state_.resolution);
  double* gradient = gradient_.data();
  double* hessian = hessian_.data();
  interpolation_.lagrange_function(leaving, gradient, hessian, coefficients_.data());
  const auto lagrange = [&](const double* s) { return dot(gradient, s, n) + 0.5 * quadratic_form(hessian, n, s); };
  relative_bounds(nullptr);
  const double* low = variables_.bounded() ? low_.data() : nullptr;
  const double* high = variables_.bounded() ? high_.data() : nullptr;
  quadratic_step_.minimise_and_maximise(gradient, hessian, radius, low, high, step_.data(), move_.data());
  if (edges_.any()) edges_.find(interpolation_, reach_of_edges * state_.radius);
  if (edges_.count() > 0) {
    edges_.confine(step_.data());
    edges_.confine(move_.data());
  }
  const double lowest = lagrange(step_.data()), highest = lagrange(move_.data());
  double most = std::max(-lowest, highest);
  const bool comparable = std::min(-lowest, highest) > 0.7 * most;
  const bool second =
      comparable ? models_.change(move_.data(), best) < models_.change(step_.data(), best) : highest > -lowest;
  if (second) std::copy_n(move_.data(), n, step_.data());
  if (low != nullptr) {
    // The active set may have stopped early. Powell 2009, section 3: a step towards another point may do better, or one
    // along an axis.
    const auto consider = [&] {
      const double value = std::abs(lagrange(move_.data()));
      if (value <= 1.2 * most || (edges_.count() > 0 && edges_.excess(move_.data()) > 0)) return;
      most = value;
      std::copy_n(move_.data(), n, step_.data());
    };
    for (std::size_t j = 0; j < interpolation_.size(); ++j) {
      if (j == best) continue;
      const double part = std::min(1.0, radius / interpolation_.distance_to_best(j));
      for (std::size_t i = 0; i < n; ++i)
        move_[i] = part * (interpolation_.point(j)[i] - interpolation_.point(best)[i]);
      consider();
    }
    for (std::size_t k = 0; k < n; ++k) {
      for (const double length : {std::max(low[k], -radius), std::min(high[k], radius)}) {
        std::fill(move_.begin(), move_.end(), 0.0);
        move_[k] = length;
        consider();
      }
    }
  }
  state_.leaving = leaving;
  state_.geometry_tries = 0;
  const double* center = interpolation_.point(best);
  for (std::size_t i = 0; i < n; ++i)
    candidate_[i] = center[i] + step_[i];
  variables_.clip(candidate_.data());
  for (std::size_t i = 0; i < n; ++i)
    step_[i] = candidate_[i] - center[i];
  if (!(norm(step_.data(), n) > 1e-3 * radius) || !(most > 1e-10)) {
    state_.next = state_.reduce_after != 0 ? Next::reduce : Next::step;
    return Request::iteration;
  }
  state_.design_next = 0;
  state_.design_end = 1;
  put_request(0, candidate_.data());
  return ask(Phase::geometry);
}

Request Solver::take_geometry() {
  const std::size_t n = variables_.free_size();
  state_.phase = Phase::iterate;
  state_.next = Next::step;
  if (std::isfinite(state_.told_value)) {
    models_.judge(step_.data(), told_.data(), interpolation_.best());
    include(state_.leaving, state_.told_value);
    return Request::iteration;
  }
  forget_cliffs();
  // No value there: without the far point where that can be, else to the other side, else with a smaller radius.
  if (interpolation_.size() > n + 1) {
    forget_point(state_.leaving);
    return Request::iteration;
  }
  if (++state_.geometry_tries <= 4) {
    const double* center = interpolation_.point(interpolation_.best());
    for (std::size_t i = 0; i < n; ++i)
      candidate_[i] = center[i] - 0.5 * step_[i];
    variables_.clip(candidate_.data());
    for (std::size_t i = 0; i < n; ++i)
      step_[i] = candidate_[i] - center[i];
    if (norm(step_.data(), n) > 0) {
      state_.design_next = 0;
      state_.design_end = 1;
      put_request(0, candidate_.data());
      return ask(Phase::geometry);
    }
  }
  state_.radius = std::max(0.5 * state_.radius, state_.resolution);
  if (state_.reduce_after != 0) state_.next = Next::reduce;
  return Request::iteration;
}

}  // namespace orbicube::trust_region
