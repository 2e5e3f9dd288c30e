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
  const std::size_t n = variables_.free_size();
  // A set that grows soon has near points enough.
  const double far = (growing() ? far_of_many : far_of_few) * state_.radius;
  std::size_t leaving = interpolation_.size();
  double away = 0;
  if (const std::size_t farthest = farthest_point(&away); away > far) leaving = farthest;
  if (leaving == interpolation_.size()) return leave_geometry();
  if (!interpolation_.sound(leaving)) {
    // Made afresh; if that has been done, this says that the points are not poised.
    if (interpolation_.fresh()) return begin_around(interpolation_.size());
    state_.spoiled = 1;
    return Request::iteration;
  }
  const double radius = std::max(std::min(0.1 * far, 0.5 * state_.radius), state_.resolution);
  interpolation_.lagrange_function(leaving, gradient_.data(), hessian_.data(), coefficients_.data());
  relative_bounds(nullptr);
  double most = maximize_lagrange(radius);
  if (variables_.bounded()) most = maximize_lagrange_along_lines(radius, most);
  state_.leaving = leaving;
  state_.geometry_tries = 0;
  put_candidate(1);
  if (!(norm(step_.data(), n) > 1e-3 * radius) || !(most > 1e-10)) return leave_geometry();
  return ask_geometry();
}

// No point is replaced: what comes after geometry steps is next.
Request Solver::leave_geometry() {
  state_.next = state_.reduce_after != 0 ? Next::reduce : Next::step;
  return Request::iteration;
}

// The candidate is `part` of step_ from the best point, within the bounds; step_ becomes the way there.
void Solver::put_candidate(double part) {
  const std::size_t n = variables_.free_size();
  const double* center = interpolation_.point(interpolation_.best());
  for (std::size_t i = 0; i < n; ++i)
    candidate_[i] = center[i] + part * step_[i];
  variables_.clip(candidate_.data());
  for (std::size_t i = 0; i < n; ++i)
    step_[i] = candidate_[i] - center[i];
}

Request Solver::ask_geometry() {
  state_.design_next = 0;
  state_.design_end = 1;
  put_request(0, candidate_.data());
  return ask(Phase::geometry);
}

// The Lagrange function with gradient_ and hessian_ at step s from the best point, where it is zero.
double Solver::lagrange_at(const double* s) const {
  const std::size_t n = variables_.free_size();
  return dot(gradient_.data(), s, n) + 0.5 * quadratic_form(hessian_.data(), n, s);
}

// Puts into step_ the minimizer or maximizer of the Lagrange function in the ball and the bounds, whichever has the
// larger magnitude, or of two that are comparable the one of the lower model. Returns the larger magnitude.
double Solver::maximize_lagrange(double radius) {
  const double* low = variables_.bounded() ? low_.data() : nullptr;
  const double* high = variables_.bounded() ? high_.data() : nullptr;
  quadratic_step_.minimise_and_maximise(gradient_.data(), hessian_.data(), radius, low, high, step_.data(),
                                        move_.data());
  if (edges_.any()) edges_.find(interpolation_, reach_of_edges * state_.radius);
  if (edges_.count() > 0) {
    edges_.confine(step_.data());
    edges_.confine(move_.data());
  }
  const std::size_t best = interpolation_.best();
  const double lowest = lagrange_at(step_.data()), highest = lagrange_at(move_.data());
  const double most = std::max(-lowest, highest);
  const bool comparable = std::min(-lowest, highest) > 0.7 * most;
  const bool second =
      comparable ? models_.change(move_.data(), best) < models_.change(step_.data(), best) : highest > -lowest;
  if (second) std::copy_n(move_.data(), variables_.free_size(), step_.data());
  return most;
}

// The active set may have stopped early. Powell 2009, section 3: a step towards another point may do better than
// `most`, or one along an axis. Returns the largest magnitude; its step is in step_.
double Solver::maximize_lagrange_along_lines(double radius, double most) {
  const std::size_t n = variables_.free_size(), best = interpolation_.best();
  const auto consider = [&] {
    const double value = std::abs(lagrange_at(move_.data()));
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
    for (const double length : {std::max(low_[k], -radius), std::min(high_[k], radius)}) {
      std::fill(move_.begin(), move_.end(), 0.0);
      move_[k] = length;
      consider();
    }
  }
  return most;
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
    put_candidate(-0.5);
    if (norm(step_.data(), n) > 0) return ask_geometry();
  }
  state_.radius = std::max(0.5 * state_.radius, state_.resolution);
  if (state_.reduce_after != 0) state_.next = Next::reduce;
  return Request::iteration;
}

}  // namespace orbicube::trust_region
