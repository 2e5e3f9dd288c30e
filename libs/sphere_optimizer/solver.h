// All spheres at once, one evaluation at a time: step() says what is requested, tell() gives it. Everything is
// allocated when the solver is made; a run can be saved between any two calls and goes on with the same bits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>

#include "base/array.h"
#include "base/gradient_run.h"
#include "base/host.h"
#include "base/line_search.h"
#include "sphere_optimizer/limited_memory.h"
#include "sphere_optimizer/newton_step.h"
#include "sphere_optimizer/problem.h"
#include "sphere_optimizer/spheres.h"

namespace orbicube::sphere_optimizer {

using base::Request;

class Solver {
 public:
  // `start` holds N blocks of d numbers, none of them zero, which are scaled to length 1; it is empty for a solver that
  // a run is loaded into. Throws invalid-argument. `host` must outlive the solver.
  Solver(const Shape& shape, const Options& options, std::span<const double> start, const base::Host& host);

  Request step();
  std::span<const double> point() const { return state_.asked() ? trial_ : x_; }
  // After need_value_and_gradient only (throws invalid-argument otherwise). `gradient` is the gradient of f in R^d of
  // each block, or any vector with the same part tangent to the spheres (but Method::dissertation looks at the whole).
  // A value or an entry that is not finite says that f could not be evaluated there.
  void tell(double value, std::span<const double> gradient);
  void tell_failure() { state_.tell_failure(); }
  // After need_product: the tangent vector, N d numbers, whose product with the Hessian of f in R^d of all blocks is
  // requested at point().
  std::span<const double> direction() const { return newton_step_.direction(); }
  // The reply to need_product (throws invalid-argument after others). Entries that are not finite say that there is no
  // product.
  void tell_product(std::span<const double> product);
  void tell_product_failure();
  bool asks_product() const { return state_.phase == Phase::asked_product; }
  // While a request waits, memory of the solver's that the gradient may be written to before tell(), which saves
  // the copy.
  std::span<double> gradient_room() { return trial_gradient_; }
  // Ends the run as cancelled; what is known stays available.
  void cancel() { state_.finish(Stop::cancelled); }
  bool cancelled_by_host() const { return state_.cancelled_by_host != 0; }

  Result result() const;
  // The point that result() speaks of: the iterate that met the tolerance, else the lowest point evaluated (among
  // values that differ by rounding only, the one with the minimum gradient); before the first evaluation, the start.
  std::span<const double> best_point() const {
    return earlier_is_lower() ? lowest_point_ : state_.stop == Stop::converged ? x_ : best_;
  }
  const Shape& shape() const { return shape_; }

  // The run's whole state as save_size() bytes, and back into a solver of the same shape and options (options_of).
  // load() throws invalid-argument for a blob of another shape or method and malformed-file kinds for one that is
  // damaged. Blobs are for machines with the same order of bytes.
  std::size_t save_size() const;
  void save(std::span<std::byte> blob) const;
  void load(std::span<const std::byte> blob);
  static Options options_of(std::span<const std::byte> blob);
  static Shape shape_of(std::span<const std::byte> blob);

 private:
  using Phase = base::RunPhase;

  // How the earlier start ended that led to the lowest value.
  struct Ended {
    std::uint64_t start = 0, converged = 0;
    double value = std::numeric_limits<double>::infinity(), measure = std::numeric_limits<double>::infinity();
  };

  // What truncated_newton keeps between steps. Lengths are the root of the sum of squares of angles.
  struct Newton {
    double radius = 0;          // 0 before the first step
    double first_gradient = 0;  // length of the first gradient
    double difference =
        0;  // length of the move to where a gradient was requested for a product, times direction(); else 0
    std::uint64_t products = 0;
    std::uint64_t known = 0;  // 1 if the last request for a product was met
  };

  // All that a run is besides its arrays and its memory; saved as bytes, so it holds no pointer and no padding. Its
  // measure is the longest tangent gradient of a block.
  struct State : base::GradientRun<Stop> {
    std::uint64_t without_memory = 0;  // 1 while the current direction is along the gradient
    std::uint64_t start = 0;           // number of the current start
    Ended lowest;
    double step_length = 0;               // of barzilai_borwein, times the gradient; 0 while it is not known
    double arc = 0.5 * std::numbers::pi;  // of great_circle: angle of the block that turned farthest, last time
    Newton newton;
    base::WolfeSearch wolfe{};
    base::BacktrackingSearch backtracking{};
  };

  static constexpr const char* phase_name = "sphere optimizer";

  // Reports to the host how far the run is; throws when it cancels.
  void report() const {
    host_.report(phase_name, state_.evaluations, options_.max_evaluations,
                 std::min(state_.best_value, state_.lowest.value));
  }
  // body(d, i) for every block i, with reports in between.
  template <class Body>
  void for_each_block(const Body& body) const;
  Request advance();
  Request end_start(Stop reason);
  void place_random_start();
  double reached_value() const { return state_.stop == Stop::converged ? state_.value : state_.best_value; }
  // The first of equals is the result.
  bool earlier_is_lower() const { return std::isfinite(state_.lowest.value) && state_.lowest.value <= reached_value(); }
  Request begin_iteration();
  Request take_trial();
  Request begin_newton_step();
  Request ask_product();
  Request take_difference();
  Request take_product();
  Request take_newton_step();
  bool choose_direction();
  void estimate_curvature();
  double cancelled_part() const;
  void choose_printed_direction();
  double longest_block(std::span<const double> v) const;
  double chord_slope() const;
  base::Search judge_trial();
  double trial_length() const;
  void place_trial(double length);
  void accept_trial();
  void begin_at_trial();
  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit);

  const base::Host& host_;
  Shape shape_;
  Options options_;
  LimitedMemory memory_;
  NewtonStep newton_step_;
  State state_;
  base::Array<double> x_, gradient_, trial_, trial_gradient_, direction_, velocity_, best_;  // N d each
  base::Array<double> lowest_point_;             // N d for several starts: the lowest point of those that have ended
  base::Array<double> radial_, trial_radial_;    // N each: parts of the gradient along the points
  base::Array<double> curvature_;                // N: what is known of the Hessian's size, by block
  base::Array<double> ambient_, trial_ambient_;  // the gradients as supplied, for Method::dissertation
  base::Array<double> last_values_;              // ring of Options::history values of f, for barzilai_borwein
};

template <class Body>
void Solver::for_each_block(const Body& body) const {
  constexpr std::size_t piece = 16384;
  with_dimension(shape_.dimension, [&](auto d) {
    for (std::size_t begin = 0; begin < shape_.count; begin += piece) {
      if (begin > 0) report();
      for (std::size_t i = begin; i < std::min(begin + piece, shape_.count); ++i)
        body(d, i);
    }
  });
}

}  // namespace orbicube::sphere_optimizer
