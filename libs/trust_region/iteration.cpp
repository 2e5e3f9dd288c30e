// The iteration: a step of the models in the trust region, then the radii, the points and their geometry. Two radii as
// in Powell 2006 (NEWUOA): steps are within `radius`, and the `resolution` below it falls only when the models are good
// and give nothing more. Method::dissertation has the one radius of the dissertation's section 4.4.2, the resolution
// then is its end.
#include <algorithm>
#include <cmath>

#include "trust_region/dense.h"
#include "trust_region/solver.h"

namespace orbicube::trust_region {
namespace {

// The part of the predicted change by which f must fall for a step to count as a success.
constexpr double enough = 0.05;
// The part below which a step says that the model's Hessian may be wrong (Powell 2006, section 8).
constexpr double poor = 0.01;
// Resolutions fall to this part of themselves, where Powell has a tenth; more slowly for a scalar f whose set of points
// grows, since it takes these evaluations to know the Hessian.
constexpr double decay = 0.15, decay_growing = 0.2;
// The part of the predicted change beyond which the radius doubles; less for a scalar f whose set of points grows,
// since farther points tell more of a Hessian that is not yet known.
constexpr double very_good = 0.7, very_good_growing = 0.3;
// Radii beyond which a point is given up, where the set may grow again.
constexpr double too_far = 30;
// Failures in a row after which a radius falls: before, another step with the edge that they indicate is tried.
constexpr std::uint64_t tries_at_edge = 4;  // times n + 1

}  // namespace

Request Solver::iterate() {
  while (state_.phase == Phase::iterate) {
    if (state_.best_value <= options_.target) return finish(Stop::target_reached);
    if (state_.failures_in_row > max_failures()) {
      restart_or_finish(Stop::evaluation_failed);
      continue;
    }
    if (!prepare_models()) return begin_around(interpolation_.size());
    switch (state_.next) {
      case Next::step:
        try_step();
        break;
      case Next::geometry:
        improve_geometry();
        break;
      case Next::reduce:
        reduce_resolution();
        break;
    }
  }
  return asked() ? Request::need_values : Request::done;
}

bool Solver::prepare_models() {
  const bool turned = state_.spoiled == 0 && wants_metric() && adapt_metric();
  if (turned || state_.spoiled != 0 || interpolation_.wants_rebuild()) {
    if (!mend()) return false;
    state_.spoiled = 0;
    models_.meet(interpolation_);
  }
  interpolation_.move_base(state_.radius);
  return true;
}

// The inverse made afresh; as long as the points are not poised, the farthest is given up.
bool Solver::mend() {
  state_.spoiled = 1;
  while (!interpolation_.rebuild()) {
    if (interpolation_.size() <= variables_.free_size() + 1) return false;
    forget_point(farthest_point(nullptr));
  }
  return true;
}

std::size_t Solver::farthest_point(double* distance) {
  interpolation_.squared_distances(interpolation_.point(interpolation_.best()), squares_.data());
  std::size_t farthest = 0;
  for (std::size_t j = 0; j < interpolation_.size(); ++j) {
    if (squares_[j] > squares_[farthest]) farthest = j;
  }
  if (distance != nullptr) *distance = std::sqrt(squares_[farthest]);
  return farthest;
}

void Solver::forget_point(std::size_t j) {
  if (state_.spoiled == 0) models_.leave(interpolation_, j);
  const std::size_t last = interpolation_.size() - 1;
  models_.move(last, j);
  values_[j] = values_[last];
  if (!interpolation_.remove(j)) state_.spoiled = 1;
}

Request Solver::try_step() {
  const std::size_t n = variables_.free_size();
  double* d = step_.data();
  const double predicted = -choose_step(d), length = norm(d, n);
  const double* best = interpolation_.point(interpolation_.best());
  const bool is_short = length < 0.5 * state_.resolution;
  const double least = std::max(1e-15 * std::abs(state_.best_value), 0.1 * noise());
  bool worth = predicted > (is_short || noise() > 0 ? least : 0);
  if (is_short) {
    // Good models make a short step worth an evaluation: it decides whether the resolution can fall with it.
    worth = worth && length > 0.1 * options_.radius_end && length > 1e-15 * norm(best, n);
  }
  if (worth) {
    bool moves = false;
    for (std::size_t i = 0; i < n; ++i)
      candidate_[i] = best[i] + d[i];
    variables_.clip(candidate_.data());
    for (std::size_t i = 0; i < n; ++i) {
      d[i] = candidate_[i] - best[i];
      moves = moves || d[i] != 0;
    }
    if (moves) {
      state_.short_step = is_short ? 1 : 0;
      state_.predicted = predicted;
      state_.design_next = 0;
      state_.design_end = 1;
      put_request(0, candidate_.data());
      return ask(Phase::trial);
    }
  }
  state_.reduce_after = 1;
  state_.radius *= 0.1;
  if (state_.radius <= 1.5 * state_.resolution) state_.radius = state_.resolution;
  state_.next = Next::geometry;
  return Request::iteration;
}

Request Solver::take_trial() {
  const std::size_t n = variables_.free_size(), best = interpolation_.best();
  const bool failed = !std::isfinite(state_.told_value), dissertation = options_.method == Method::dissertation;
  const double length = norm(step_.data(), n), before = values_[best], slack = noise();
  const double ratio = failed ? -1 : (before - state_.told_value + slack) / (state_.predicted + slack);
  const double resolution = state_.resolution;
  state_.phase = Phase::iterate;
  const bool edged = failed && follows_edges();
  if (edged) forget_cliffs();
  if (edged && state_.failures_in_row % patience() == 0) {
    state_.next = Next::reduce;
    return Request::iteration;
  }
  if (edged && state_.failures_in_row % (tries_at_edge * (n + 1)) != 0) {
    state_.next = Next::step;
    return Request::iteration;
  }
  if (ratio < enough) ++state_.poor_steps;
  if (!failed) models_.judge(step_.data(), told_.data(), best);
  if (state_.short_step != 0) {
    if (ratio >= enough && !dissertation) {
      state_.resolution = std::max(std::clamp(length, options_.radius_end, resolution), 0.1 * resolution);
      state_.radius = std::max(state_.resolution, std::min(state_.radius, 2 * length));
    }
  } else if (dissertation) {
    // The dissertation's step 4; where the ratio is low, the points come first (step 5).
    if (ratio >= 0.7) {
      state_.radius = std::max(state_.radius, 2 * length);
    } else if (ratio >= 0.1) {
      state_.radius = std::max(0.5 * state_.radius, length);
    }
  } else {
    if (ratio < enough) {
      state_.radius = std::min(0.5 * state_.radius, length);
    } else {
      const bool scalar = growing() && !models_.of_residuals() && !variables_.bounded();
      state_.radius =
          std::max(0.5 * state_.radius, ratio <= (scalar ? very_good_growing : very_good) ? length : 2 * length);
    }
    if (state_.radius <= 1.5 * resolution) state_.radius = resolution;
  }
  if (!failed) include(interpolation_.size(), state_.told_value);
  if (!failed && state_.spoiled == 0) models_.doubt_memory(interpolation_, ratio <= poor);
  if (std::abs(before - state_.told_value) <= 2 * slack && at_noise_level())
    return restart_or_finish(Stop::noise_limit);
  if (ratio >= enough) {
    state_.next = Next::step;
    return Request::iteration;
  }
  state_.next = Next::geometry;
  state_.reduce_after = state_.short_step != 0 || (ratio <= 0 && std::max(length, state_.radius) <= resolution) ? 1 : 0;
  if (dissertation) {
    // Shrinks once the points are near enough.
    state_.reduce_after = 1;
    state_.predicted = length;
  }
  return Request::iteration;
}

// The evaluated point best + step_ takes the place of point j, or, where j is the number of points, that of whichever
// can go best, or is added.
void Solver::include(std::size_t j, double value) {
  const std::size_t n = variables_.free_size();
  const bool better = value < values_[interpolation_.best()];
  bool good = interpolation_.prepare(step_.data());
  if (!good) {
    good = interpolation_.rebuild();
    if (good) {
      models_.meet(interpolation_);
      interpolation_.prepare(step_.data());
    }
  }
  bool added = false;
  if (j == interpolation_.size()) {
    const double square = dot(step_.data(), step_.data(), n);
    added =
        interpolation_.size() < interpolation_.capacity() && good && interpolation_.beta() > 1e-10 * square * square;
    if (!added) {
      j = who_leaves(better);
      if (j == interpolation_.size()) return;
    }
  }
  const std::size_t best = interpolation_.best();
  if (good && !added) models_.leave(interpolation_, j);
  models_.expect(step_.data(), told_.data(), best);
  good = good && (added ? interpolation_.append() : interpolation_.replace(j));
  if (!good) {
    // The inverse is lost: the point is placed, and everything is made afresh at the next iteration.
    for (std::size_t i = 0; i < n; ++i)
      candidate_[i] = interpolation_.point(best)[i] + step_[i];
    interpolation_.place(j, candidate_.data());
    state_.spoiled = 1;
  }
  models_.store(j, told_.data());
  values_[j] = value;
  if (state_.spoiled != 0) {
    if (better || j == best) interpolation_.set_best(j);
  } else {
    if (j == best) models_.shift(step_.data());
    models_.learn(interpolation_, j);
    if (better && j != best) {
      interpolation_.set_best(j);
      models_.shift(step_.data());
    }
  }
  drop_far_points();
}

// The point whose leaving keeps the set best poised; far ones go more readily (Powell 2006, eq. 6.6). The number of
// points when none should go.
std::size_t Solver::who_leaves(bool better) {
  const std::size_t n = variables_.free_size(), best = interpolation_.best();
  const double near = std::max(0.1 * state_.radius, state_.resolution);
  for (std::size_t i = 0; i < n; ++i)
    candidate_[i] = interpolation_.point(best)[i] + (better ? step_[i] : 0.0);
  interpolation_.squared_distances(candidate_.data(), squares_.data());
  double highest = 0;
  std::size_t leaving = interpolation_.size();
  for (std::size_t j = 0; j < interpolation_.size(); ++j) {
    if (j == best && !better) continue;
    const double relative = std::max(1.0, squares_[j] / (near * near));
    const double score = std::abs(interpolation_.denominator(j)) * relative * relative * relative;
    if (score > highest) {
      highest = score;
      leaving = j;
    }
  }
  return leaving;
}

// Where the set may grow to that of full quadratics, points that are too far to say anything are given up.
void Solver::drop_far_points() {
  const std::size_t n = variables_.free_size();
  if (!growing()) return;
  while (interpolation_.size() > n + 1) {
    double most = 0;
    const std::size_t farthest = farthest_point(&most);
    if (!(most > too_far * std::max(state_.radius, state_.resolution))) return;
    forget_point(farthest);
  }
}

// The points around the best one tell nothing more when their values differ by noise: by twice its level between two
// points, and the best may have been lucky.
bool Solver::at_noise_level() const {
  if (!(noise() > 0)) return false;
  std::size_t near = 0;
  for (std::size_t j = 0; j < interpolation_.size(); ++j) {
    if (interpolation_.distance_to_best(j) > 2 * std::max(state_.radius, state_.resolution)) continue;
    ++near;
    if (values_[j] - state_.best_value > 3 * noise()) return false;
  }
  return near > variables_.free_size();
}

// Whether the models, too, have their lowest point here. They do not where f has a corner, or ends: there a step of the
// resolution would still help by a part of what f has fallen that is in proportion to its length, where that of a
// smooth f is in proportion to the square.
bool Solver::models_are_flat() {
  constexpr double proportion = 1e-4;
  if (options_.method != Method::two_radii) return true;  // its radius falls whatever the models say
  edges_.forget();
  const double predicted = -choose_step(step_.data()), fallen = state_.first_value - state_.best_value;
  const double least = std::max(1e-15 * std::abs(state_.best_value), 0.1 * noise());
  return norm(step_.data(), step_.size()) < 0.5 * state_.resolution ||
         !(predicted > std::max(least, proportion * fallen * state_.resolution / state_.radius_begin));
}

// Whether a scale that the caller gave is far from the lengths by which f bends, so that the resolution ends too early:
// along an axis the models slope by a part of what f has fallen, where they do not see how f bends in so short a step,
// or the resolution of an unknown is lost in its rounding.
bool Solver::scale_misleads() {
  constexpr double proportion = 1e-4, resolutions = 10, rounding = 1e-14;
  const std::size_t n = variables_.free_size();
  if (!scale_given_ || n > Variables::max_turned || options_.method != Method::two_radii) return false;
  if (models_.has_corners()) return false;  // where f may slope along every axis at its minimum
  const double* best = interpolation_.point(interpolation_.best());
  std::fill_n(move_.data(), n, 0.0);
  models_.expand(move_.data(), interpolation_.best(), gradient_.data(), hessian_.data());
  relative_bounds(nullptr);
  const double fallen = state_.first_value - state_.best_value, resolution = state_.resolution;
  const double least_slope = (rounding * std::abs(state_.best_value) + noise()) / resolution;
  const double least = std::max(proportion, resolutions * resolution / state_.radius_begin) * fallen;
  for (std::size_t i = 0; i < n; ++i) {
    const double room = gradient_[i] > 0 ? -low_[i] : high_[i], slope = std::abs(gradient_[i]);
    if (slope > least_slope && slope * std::min(state_.radius_begin, room) > least) return true;
    if (best[i] + 0.25 * resolution == best[i]) return true;
  }
  return false;
}

Request Solver::reduce_resolution() {
  state_.next = Next::step;
  const double end = options_.radius_end;
  if (options_.method == Method::dissertation && state_.radius > end) {
    state_.radius = std::max(end, 0.5 * std::min(state_.radius, state_.predicted));
    return Request::iteration;
  }
  if (at_noise_level()) return restart_or_finish(Stop::noise_limit);
  if (state_.resolution <= 1.0001 * end)
    return restart_or_finish(models_are_flat() && !scale_misleads() ? Stop::converged : Stop::resolution_limit);
  // What is known of edges is from longer steps.
  edges_.forget();
  state_.failures_of_level = 0;
  // Powell 2006, section 7: in the end by few steps of equal ratio.
  const double ratio = state_.resolution / end, fall = growing() && !models_.of_residuals() ? decay_growing : decay;
  state_.radius = 0.5 * state_.resolution;
  state_.resolution = ratio <= 16 ? end : ratio <= 250 ? std::sqrt(state_.resolution * end) : fall * state_.resolution;
  state_.radius = std::max(state_.radius, state_.resolution);
  return Request::iteration;
}

}  // namespace orbicube::trust_region
