// The solver, one evaluation at a time: step() says what is requested, tell() gives it. Everything is allocated when
// the solver is made, or a run is given evaluations or loaded: room for as many points as the budget of evaluations
// allows, and for models only where it allows one. A run can be saved between any two calls and goes on with the same
// bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "base/host.h"
#include "trust_region/edges.h"
#include "trust_region/interpolation.h"
#include "trust_region/models.h"
#include "trust_region/problem.h"
#include "trust_region/quadratic_step.h"
#include "trust_region/tridiagonal.h"
#include "trust_region/variables.h"

namespace orbicube::trust_region {

enum class Request : std::int32_t {
  need_values = 1,  // f, or all residuals, at the points of pending(); supply with tell(), one point after the other
  iteration = 2,    // best_point() and radii are those of a new iteration; nothing to supply
  done = 3,         // see result()
};

class Solver {
 public:
  // Copies problem and start (n entries, moved into the bounds; none for a solver that a run is loaded into). Throws
  // invalid-argument. `host` must outlive the solver.
  Solver(const Problem& problem, const Options& options, std::span<const double> start, const base::Host& host);

  // An evaluation made before the run: x (n entries, within the bounds) and its outputs. Before the first step only;
  // not counted. The run then begins at the lowest of them. Throws invalid-argument.
  void give(std::span<const double> x, std::span<const double> outputs);

  Request step();
  // The points requested, pending_count() rows of n entries; they may be evaluated at the same time. One, but at the
  // start of a run with Start::cross.
  std::size_t pending_count() const { return asked() ? design_count() - state_.design_next : 0; }
  std::span<const double> pending() const;
  // f or the residuals at the first of the points requested. A number that is not finite says that it could not be
  // evaluated there. Throws invalid-argument when no request waits.
  void tell(std::span<const double> outputs);
  void tell_failure();
  // Ends the run as cancelled; what is known stays available.
  void cancel() { finish(Stop::cancelled); }
  bool cancelled_by_host() const { return state_.cancelled_by_host != 0; }

  Result result() const;
  // The lowest point evaluated and its outputs; before the first value, the start.
  std::span<const double> best_point() const { return best_; }
  std::span<const double> best_outputs() const { return best_outputs_; }
  std::size_t size() const { return best_.size(); }
  std::size_t outputs() const { return best_outputs_.size(); }

  // The run's whole state as save_size() bytes, and back into a solver of the same problem and options (options_of).
  // load() throws invalid-argument for a blob of another problem and parse for one that is damaged. Blobs are for
  // machines with the same order of bytes.
  std::size_t save_size() const;
  void save(std::span<std::byte> blob) const;
  void load(std::span<const std::byte> blob);
  static Options options_of(std::span<const std::byte> blob);

 private:
  enum class Phase : std::int32_t {
    created,
    start,
    start_told,
    iterate,
    trial,
    trial_told,
    geometry,
    geometry_told,
    done
  };
  enum class Next : std::int32_t { step, geometry, reduce };

  // All that a run is besides its arrays; saved as bytes, so it holds no pointer and no padding.
  struct State {
    Phase phase = Phase::created;
    Stop stop = Stop::running;
    Next next = Next::step;
    std::int32_t short_step = 0;    // 1 while the trial is shorter than half the resolution
    std::int32_t reduce_after = 0;  // 1 when the resolution falls once no point is too far
    std::int32_t spoiled = 0;       // 1 when the inverse must be made afresh
    std::int32_t cancelled_by_host = 0, padding = 0;
    std::uint64_t evaluations = 0, failed_evaluations = 0, iterations = 0, restarts = 0;
    std::uint64_t failures_in_row = 0;
    std::uint64_t design_next = 0, design_end = 0, axes_next = 0, axes_end = 0;
    std::uint64_t metric_at = 0, poor_steps = 0;  // evaluations at the last change of coordinates; steps since
    std::uint64_t leaving = 0;                    // the point that the geometry step replaces
    std::uint64_t geometry_tries = 0, start_tries = 0, poise_failures = 0;
    std::uint64_t cliffs = 0;  // 1 once values are known to be beyond an edge, 2 once earlier ones are forgotten
    std::uint64_t failures_of_level = 0;                        // since the resolution fell
    double last_end = std::numeric_limits<double>::infinity();  // the lowest value when an edge ended the run
    double cliff_height = 0, cliff_length = 0;
    double radius = 0, resolution = 0, radius_begin = 0, predicted = 0;
    double best_value = 0, told_value = 0;
    double first_value = std::numeric_limits<double>::infinity();
  };

  bool asked() const {
    return state_.phase == Phase::start || state_.phase == Phase::trial || state_.phase == Phase::geometry;
  }
  std::size_t design_count() const { return state_.design_end; }
  // Radii within which failed points and others determine edges.
  static constexpr double reach_of_edges = 2;
  Request advance();
  Request ask(Phase phase);
  Request finish(Stop stop);
  void put_request(std::size_t row, const double* u);
  double noise() const;
  bool at_noise_level() const;
  bool beyond_cliff(double value);
  void forget_cliffs();
  bool follows_edges() const { return options_.method == Method::two_radii && options_.follow_edges != 0; }
  // Failures in a row after which steps get shorter, and after which the run ends.
  std::uint64_t patience() const { return 30 + 2 * variables_.free_size(); }
  std::uint64_t max_failures() const {
    const std::uint64_t n = variables_.free_size();
    return follows_edges() ? 80 + 8 * n : 20 + 2 * n;
  }
  // Whether there may be more than Powell's 2n + 1 points.
  bool growing() const { return max_points_ > 2 * variables_.free_size() + 1; }
  void allocate(bool whole);

  // start.cpp
  Request begin();
  Request begin_around(std::size_t keep);
  void exchange_points(std::size_t a, std::size_t b);
  bool extend_basis(std::size_t& count, double least);
  std::size_t nearest_point(std::size_t first, double* distance) const;
  void plan_axes();
  void list_uncovered_axes(std::size_t count);
  Request next_of_start();
  Request take_start();
  double axis_step(const double* center, std::size_t axis, double length) const;
  bool goes_on_after(Stop stop);
  Request restart_or_finish(Stop stop);

  // iteration.cpp, step.cpp
  Request iterate();
  bool prepare_models();
  bool mend();
  void forget_point(std::size_t j);
  std::size_t farthest_point(double* distance);
  double choose_step(double* d);
  double change_of(const double* d);
  void expand_at(const double* d);
  void refine_step(double* d, double* value);
  double sharpen_step(double* d);
  double move_within(const double* d, double inner, double* trial);
  Request try_step();
  Request take_trial();
  bool models_are_flat();
  bool scale_misleads();
  Request reduce_resolution();
  void include(std::size_t j, double value);
  std::size_t who_leaves(bool better);
  void drop_far_points();
  void relative_bounds(const double* d);

  // geometry.cpp
  Request improve_geometry();
  Request leave_geometry();
  void put_candidate(double part);
  Request ask_geometry();
  double lagrange_at(const double* s) const;
  double maximize_lagrange(double radius);
  double maximize_lagrange_along_lines(double radius, double most);
  Request take_geometry();

  // metric.cpp
  bool wants_metric() const;
  bool adapt_metric();

  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit);

  const base::Host& host_;
  Options options_;
  Variables variables_;
  std::size_t max_points_ = 0;  // that a budget without end would have
  bool scale_given_ = false;    // by the caller
  bool cross_ = false;          // the first points are those of Start::cross
  std::uint64_t whole_ = 0;     // 1: there is room for max_points_ and a model, whatever the budget
  Interpolation interpolation_;
  Models models_;
  Edges edges_;
  QuadraticStep quadratic_step_;
  State state_;
  double edge_weight_ = 0;                   // of the penalty beyond planes, for one step
  base::Array<double> best_, best_outputs_;  // n of the caller's, outputs
  base::Array<double> values_;               // f at the interpolation points
  base::Array<double> start_;                // free unknowns
  base::Array<double> design_;               // rows of free unknowns requested
  base::Array<std::uint32_t> axes_;
  base::Array<double> requests_;      // the same rows as the caller sees them
  base::Array<double> told_, error_;  // outputs
  base::Array<double> step_, gradient_, hessian_, move_, low_, high_;
  base::Array<double> sharpest_;  // a step, for corners
  base::Array<double> candidate_;
  base::Array<double> squares_;       // of the points' distances
  base::Array<double> coefficients_;  // of a Lagrange function
  base::Array<double> basis_;         // free x free, for plan_axes() and adapt_metric()
  Tridiagonal eigen_;
};

}  // namespace orbicube::trust_region
