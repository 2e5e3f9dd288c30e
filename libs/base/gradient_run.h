// What every solver that requests from its caller value and gradient, one point at a time, keeps of its run: where it
// stands, its counts, which value and which stationarity were the lowest, and when to end. The method itself is the
// solver's.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "base/error.h"
#include "base/host.h"

namespace orbicube::base {

enum class Request : std::int32_t {
  need_value_and_gradient = 1,  // of f at point(); supply with tell()
  iteration = 2,                // point() is a new iterate; nothing to supply
  done = 3,                     // see result()
  need_product = 4,             // of the Hessian at point() with direction(); supply with tell_product()
};

enum class RunPhase : std::int32_t {
  created,
  asked_first,
  told_first,
  iterate,
  asked,
  told,
  done,
  asked_product,
  told_product
};

// Plain data without padding, saved as bytes. `Stop` is the library's, with running, converged, target_reached,
// evaluation_budget, iteration_budget, stalled and cancelled among its values.
template <class Stop>
struct GradientRun {
  RunPhase phase = RunPhase::created;
  Stop stop = Stop::running;
  std::uint64_t evaluations = 0, failed_evaluations = 0, iterations = 0;
  std::uint64_t cancelled_by_host = 0;
  std::uint64_t without_gain = 0;  // iterations since value or stationarity were lower than ever before
  std::uint64_t gained_at = 0;     // evaluations then
  double value = 0, trial_value = 0;
  double best_value = std::numeric_limits<double>::infinity();
  double measure = std::numeric_limits<double>::infinity();       // of stationarity, at the iterate
  double best_measure = std::numeric_limits<double>::infinity();  // at the best point, infinite while it is not known
  double lowest_measure = std::numeric_limits<double>::infinity();

  // Values of f that differ by less may be the same.
  static double rounding_of(double value) { return 8 * std::numeric_limits<double>::epsilon() * std::abs(value); }

  bool asked() const { return phase == RunPhase::asked || phase == RunPhase::asked_first; }

  // One step of the solver: advance() returns the request. Reports first; a host that cancels, there or inside, ends
  // the run.
  template <class Advance>
  Request step(const Host& host, const char* name, std::uint64_t max_evaluations, const Advance& advance) {
    if (asked()) return Request::need_value_and_gradient;
    if (phase == RunPhase::asked_product) return Request::need_product;
    try {
      host.report(name, evaluations, max_evaluations, best_value);
      return advance();
    } catch (const Error& error) {
      if (error.status() != Status::cancelled) throw;
      cancelled_by_host = 1;
      return finish(Stop::cancelled);
    }
  }

  Request ask(RunPhase next, std::uint64_t max_evaluations) {
    if (evaluations >= max_evaluations) return finish(Stop::evaluation_budget);
    phase = next;
    return Request::need_value_and_gradient;
  }

  Request ask_product() {
    phase = RunPhase::asked_product;
    return Request::need_product;
  }

  Request finish(Stop reason) {
    phase = RunPhase::done;
    stop = reason;
    return Request::done;
  }

  // The result to a request: a finite value. True when it is the lowest so far, by more than rounding.
  bool tell(double told) {
    ++evaluations;
    trial_value = told;
    phase = phase == RunPhase::asked_first ? RunPhase::told_first : RunPhase::told;
    const bool known = std::isfinite(best_measure);
    if (!(told < best_value - (known ? rounding_of(best_value) : 0))) return false;
    best_value = told;
    best_measure = std::numeric_limits<double>::infinity();
    without_gain = 0;
    gained_at = evaluations;
    return true;
  }

  // f could not be evaluated.
  void tell_failure() {
    require(asked(), "nothing was requested");
    ++evaluations;
    ++failed_evaluations;
    trial_value = std::numeric_limits<double>::quiet_NaN();
    phase = phase == RunPhase::asked_first ? RunPhase::told_first : RunPhase::told;
  }

  // The iterate's stationarity. True when the iterate is the best point: evaluated there, no higher by more than
  // rounding, and nearer to stationary.
  bool settle(double new_measure, bool evaluated = true) {
    measure = new_measure;
    ++without_gain;
    if (measure < lowest_measure) {
      lowest_measure = measure;
      without_gain = 0;
      gained_at = evaluations;
    }
    if (!evaluated || !(measure < best_measure && value <= best_value + rounding_of(best_value))) return false;
    best_value = value;
    best_measure = measure;
    return true;
  }

  // The iterate's stationarity, known to be larger than it was thought.
  void unsettle(double larger) {
    if (!(larger > measure)) return;
    if (best_measure == measure) best_measure = larger;
    measure = lowest_measure = larger;
  }

  // Why the run is to end before another iteration, or running.
  template <class Options>
  Stop reason_to_end(const Options& options) const {
    if (measure <= options.gradient_tolerance) return Stop::converged;
    if (best_value <= options.target) return Stop::target_reached;
    // Lower values are found for a while after the last that rounding resolves; nonmonotone searches may need more.
    constexpr std::uint64_t patience = 200;
    if (without_gain >= patience + 10 * options.history) return Stop::stalled;
    // Searches that take many evaluations and gain nothing tell that f is at its floor of rounding, or that the
    // gradient is not that of f.
    constexpr std::uint64_t fruitless = 40, per_iteration = 4;
    if (evaluations - gained_at >= fruitless && without_gain * per_iteration <= evaluations - gained_at) {
      return Stop::stalled;
    }
    if (iterations >= options.max_iterations) return Stop::iteration_budget;
    return Stop::running;
  }

  // The parts of a library's result that all have.
  template <class Result>
  void describe(Result& result) const {
    result.stop = stop;
    if (evaluations > failed_evaluations) result.value = stop == Stop::converged ? value : best_value;
    result.evaluations = evaluations;
    result.failed_evaluations = failed_evaluations;
    result.iterations = iterations;
  }
};

}  // namespace orbicube::base
