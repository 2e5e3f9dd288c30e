// The first points: evaluations that were given, then steps along the axes that these do not cover. The chain evaluates
// each from the best point so far; the cross can be evaluated all at once. Also how a run begins again, and how a set
// of points that has lost its poise is mended.
#include <algorithm>
#include <cmath>

#include "trust_region/dense.h"
#include "trust_region/solver.h"

namespace orbicube::trust_region {
namespace {

constexpr std::uint64_t tries_of_an_axis = 8;
// The part of f by which it must fall from one end at an edge of the domain, at a corner or in noise to the next for
// another start.
constexpr double gain_of_restart = 1e-3;
// Radii after which f differs by more than its noise where it differed by about as much: in proportion to the square,
// by a hundred times as much. A third and three times of it solve fewer of the cases with noise 1e-3.
constexpr double beyond_noise = 10;

}  // namespace

Request Solver::begin() {
  const std::size_t n = variables_.free_size();
  state_.radius_begin = state_.radius = state_.resolution = options_.radius_begin;
  if (options_.method == Method::dissertation) state_.resolution = options_.radius_end;
  if (interpolation_.size() > 0) return begin_around(interpolation_.size());
  state_.design_next = 0;
  state_.design_end = 1;
  put_request(0, start_.data());
  if (cross_) {
    for (std::size_t k = 0; k < n; ++k) {
      for (const bool second : {false, true}) {
        const std::size_t row = 1 + k + (second ? n : 0);
        if (row >= interpolation_.capacity() || row * size() >= requests_.size()) continue;
        const double first = axis_step(start_.data(), k, state_.radius), center = start_[k];
        double length = first;
        if (second) {
          const auto fits = [&](double step) {
            return center + step >= variables_.lower()[k] && center + step <= variables_.upper()[k];
          };
          length = fits(-first) ? -first : fits(2 * first) ? 2 * first : 0.5 * first;
        }
        std::copy(start_.begin(), start_.end(), candidate_.begin());
        candidate_[k] += length;
        variables_.clip(candidate_.data());
        put_request(row, candidate_.data());
        state_.design_end = std::max<std::uint64_t>(state_.design_end, row + 1);
      }
    }
  }
  return ask(Phase::start);
}

// A step of about `length` (of any sign) from the center along an axis that stays within the bounds.
double Solver::axis_step(const double* center, std::size_t axis, double length) const {
  const double up = variables_.upper()[axis] - center[axis], down = center[axis] - variables_.lower()[axis];
  const double wanted = std::abs(length);
  if (length > 0 ? up >= wanted : down >= wanted) return length;
  if (length > 0 ? down >= wanted : up >= wanted) return -length;
  return up >= down ? up : -down;
}

// The value at one of the design's points.
Request Solver::take_start() {
  const std::size_t n = variables_.free_size(), j = interpolation_.size();
  const bool good = std::isfinite(state_.told_value);
  if (good) {
    interpolation_.place(j, design_.data() + state_.design_next * n);
    interpolation_.resize(j + 1);
    models_.store(j, told_.data());
    values_[j] = state_.told_value;
    if (j == 0 || values_[j] < values_[interpolation_.best()]) interpolation_.set_best(j);
  }
  if (state_.axes_next < state_.axes_end) {
    // Along an axis of the chain: the next one, or the same again to the other side.
    state_.start_tries = good ? 0 : state_.start_tries + 1;
    if (good || state_.start_tries >= tries_of_an_axis) {
      ++state_.axes_next;
      state_.start_tries = 0;
    }
  }
  ++state_.design_next;
  if (state_.design_next == state_.design_end) state_.phase = Phase::start_told;
  return Request::need_values;
}

Request Solver::next_of_start() {
  const std::size_t n = variables_.free_size();
  if (interpolation_.size() == 0) return finish(Stop::evaluation_failed);
  if (state_.failures_in_row > max_failures()) return restart_or_finish(Stop::evaluation_failed);
  if (state_.best_value <= options_.target) return finish(Stop::target_reached);
  if (n == 0) return finish(Stop::converged);
  if (state_.axes_next == state_.axes_end) {
    if (interpolation_.size() >= n + 1 && interpolation_.rebuild()) {
      if (state_.iterations == 0) models_.forget();
      models_.meet(interpolation_);
      state_.phase = Phase::iterate;
      state_.next = Next::step;
      state_.spoiled = 0;
      state_.poise_failures = 0;
      return iterate();
    }
    if (interpolation_.size() >= n + 1 && ++state_.poise_failures > 3) return restart_or_finish(Stop::stalled);
    if (state_.evaluations >= options_.max_evaluations) return finish(Stop::evaluation_budget);
    if (state_.failures_in_row > 0 && follows_edges()) {
      // No value along an axis, nor to its other side: shorter steps.
      state_.radius = std::max(0.1 * state_.radius, options_.radius_end);
      state_.resolution = std::min(state_.resolution, state_.radius);
    }
    plan_axes();
    if (state_.axes_next == state_.axes_end) return next_of_start();
  }
  const double* center = interpolation_.point(interpolation_.best());
  const std::size_t axis = axes_[state_.axes_next];
  const double length = state_.radius * std::pow(-0.6, static_cast<double>(state_.start_tries));
  std::copy_n(center, n, candidate_.data());
  candidate_[axis] += axis_step(center, axis, length);
  variables_.clip(candidate_.data());
  state_.design_next = 0;
  state_.design_end = 1;
  put_request(0, candidate_.data());
  return ask(Phase::start);
}

// Goes on with the first `keep` points, or with the best alone.
Request Solver::begin_around(std::size_t keep) {
  std::size_t best = interpolation_.best();
  for (std::size_t j = 0; j < interpolation_.size(); ++j) {
    if (values_[j] < values_[best]) best = j;
  }
  interpolation_.set_best(best);
  if (keep == 1) {
    interpolation_.place(0, interpolation_.point(best));
    models_.move(best, 0);
    values_[0] = values_[best];
    interpolation_.set_best(0);
    interpolation_.resize(1);
  }
  plan_axes();
  return next_of_start();
}

// Exchanges two points with their values.
void Solver::exchange_points(std::size_t a, std::size_t b) {
  if (a == b) return;
  std::copy_n(interpolation_.point(a), variables_.free_size(), candidate_.data());
  interpolation_.place(a, interpolation_.point(b));
  interpolation_.place(b, candidate_.data());
  std::copy_n(models_.row(a), outputs(), error_.data());
  models_.move(b, a);
  models_.store(b, error_.data());
  std::swap(values_[a], values_[b]);
}

// Adds the direction in move_ to the `count` orthonormal rows of basis_ when more than `least` of it is new; move_ gets
// its new part.
bool Solver::extend_basis(std::size_t& count, double least) {
  const std::size_t n = variables_.free_size();
  const double length = norm(move_.data(), n);
  if (!(length > 0) || count == n) return false;
  for (int twice = 0; twice < 2; ++twice) {
    for (std::size_t k = 0; k < count; ++k)
      add_scaled(move_.data(), -dot(basis_.data() + k * n, move_.data(), n), basis_.data() + k * n, n);
  }
  const double rest = norm(move_.data(), n);
  if (!(rest > least * length)) return false;
  for (std::size_t i = 0; i < n; ++i)
    basis_[count * n + i] = move_[i] / rest;
  ++count;
  return true;
}

// The point nearest to the best one of those from `first` on, and its distance.
std::size_t Solver::nearest_point(std::size_t first, double* distance) const {
  std::size_t nearest = interpolation_.size();
  *distance = 0;
  for (std::size_t j = first; j < interpolation_.size(); ++j) {
    const double away = interpolation_.distance_to_best(j);
    if (away >= 0 && (nearest == interpolation_.size() || away < *distance)) {
      nearest = j;
      *distance = away;
    }
  }
  return nearest;
}

// Keeps points near the best whose directions are independent, nearest first, and lists the axes that complete them.
void Solver::plan_axes() {
  const std::size_t n = variables_.free_size(), size = interpolation_.size();
  exchange_points(0, interpolation_.best());
  interpolation_.set_best(0);
  std::size_t kept = 1, count = 0;
  while (kept < size && count < n) {
    double away = 0;
    const std::size_t nearest = nearest_point(kept, &away);
    if (away > 10 * state_.radius) break;
    for (std::size_t i = 0; i < n; ++i)
      move_[i] = interpolation_.point(nearest)[i] - interpolation_.point(0)[i];
    if (extend_basis(count, 0.1)) {
      exchange_points(kept, nearest);
      ++kept;
    } else {
      // Too much like the others: it goes behind and is forgotten.
      exchange_points(nearest, size - 1);
      interpolation_.resize(size - 1);
      return plan_axes();
    }
  }
  interpolation_.resize(kept);
  state_.axes_next = state_.axes_end = 0;
  state_.start_tries = 0;
  if (kept > 1) {
    list_uncovered_axes(count);
    return;
  }
  // Nothing is covered: every axis, in order.
  state_.axes_end = n;
  for (std::size_t i = 0; i < n; ++i)
    axes_[i] = static_cast<std::uint32_t>(i);
}

// The axes with the largest part outside of the `count` rows of basis_, which they extend.
void Solver::list_uncovered_axes(std::size_t count) {
  const std::size_t n = variables_.free_size();
  while (count < n) {
    std::size_t axis = 0;
    double most = -1;
    for (std::size_t i = 0; i < n; ++i) {
      double covered = 0;
      for (std::size_t k = 0; k < count; ++k)
        covered += basis_[k * n + i] * basis_[k * n + i];
      if (1 - covered > most) {
        most = 1 - covered;
        axis = i;
      }
    }
    std::fill(move_.begin(), move_.end(), 0.0);
    move_[axis] = 1;
    if (!extend_basis(count, 0)) break;
    axes_[state_.axes_end++] = static_cast<std::uint32_t>(axis);
  }
}

// Whether another start may get lower although the caller wants no more of them: a run may end before the lowest point
// at an edge of the domain, at a corner of f, and where the noise hides how f falls. It goes on while that helps.
bool Solver::goes_on_after(Stop stop) {
  const bool at_edge = follows_edges() && state_.failures_of_level > 0 && stop != Stop::evaluation_failed;
  const bool hindered = stop == Stop::noise_limit || stop == Stop::resolution_limit;
  if (options_.method != Method::two_radii || !(at_edge || hindered)) return false;
  const double gain = std::max(gain_of_restart * std::abs(state_.best_value), noise());
  const bool helps = state_.last_end - state_.best_value > gain;
  state_.last_end = state_.best_value;
  return helps;
}

Request Solver::restart_or_finish(Stop stop) {
  if (state_.restarts >= options_.restarts && !goes_on_after(stop)) return finish(stop);
  ++state_.restarts;
  state_.failures_in_row = 0;
  edges_.forget();
  const double part = std::pow(0.1, static_cast<double>(state_.restarts % 4));
  const bool noisy = stop == Stop::noise_limit && options_.method == Method::two_radii;
  const double longer = beyond_noise * std::min(state_.radius, state_.radius_begin);
  state_.radius = std::max(10 * options_.radius_end, noisy ? longer : part * state_.radius_begin);
  if (options_.method != Method::dissertation) state_.resolution = state_.radius;
  // Hessians of steps that noise hides, or of a corner, are of another function than longer steps see.
  if (noisy || stop == Stop::resolution_limit) models_.forget();
  return begin_around(1);
}

}  // namespace orbicube::trust_region
