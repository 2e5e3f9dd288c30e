// The solver, one evaluation at a time: step() says what is requested, tell() gives it. Everything is allocated when
// the solver is made; a run can be saved between any two calls and goes on with the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "base/gradient_run.h"
#include "base/host.h"
#include "base/line_search.h"
#include "projected_gradient/dense_model.h"
#include "projected_gradient/face_step.h"
#include "projected_gradient/feasible_set.h"
#include "projected_gradient/limited_memory.h"
#include "projected_gradient/problem.h"

namespace orbicube::projected_gradient {

using base::Request;

class Solver {
 public:
  // Copies problem and start (n entries, projected to the feasible set first; none for a solver that a run is loaded
  // into). Throws invalid-argument.
  // `host` must outlive the solver.
  Solver(const Problem& problem, const Options& options, std::span<const double> start, const base::Host& host);

  Request step();
  std::span<const double> point() const { return state_.asked() ? trial_ : x_; }
  // After need_value_and_gradient only (throws invalid-argument otherwise). A value or an entry that is not finite says
  // that f could not be evaluated there.
  void tell(double value, std::span<const double> gradient);
  void tell_failure() { state_.tell_failure(); }
  // Ends the run as cancelled; what is known stays available.
  void cancel() { state_.finish(Stop::cancelled); }
  bool cancelled_by_host() const { return state_.cancelled_by_host != 0; }

  Result result() const;
  // The point that result() speaks of: the iterate that met the tolerance, else the lowest feasible point evaluated
  // (among values that differ by rounding only, the one with the minimum projected gradient); before the first
  // evaluation, the projected start.
  std::span<const double> best_point() const;
  std::span<const double> certificate() const { return set_.certificate(); }
  std::size_t size() const { return x_.size(); }
  std::size_t rows() const { return set_.rows(); }

  // Multipliers t of the rows as given, m entries: near a solution g - A't is zero on the unknowns within their bounds.
  void copy_multipliers(std::span<double> out) const;

  // The run's whole state as save_size() bytes, and back into a solver of the same problem and options (options_of).
  // load() throws invalid-argument for a blob of another problem and parse for one that is damaged. Blobs are for
  // machines with the same order of bytes.
  std::size_t save_size() const;
  void save(std::span<std::byte> blob) const;
  void load(std::span<const std::byte> blob);
  static Options options_of(std::span<const std::byte> blob);

 private:
  using Phase = base::RunPhase;

  // Where value and gradient of the iterate come from.
  enum class Iterate : std::uint64_t {
    evaluated,
    interpolated,   // of a quadratic f (quadratic.cpp)
    asked,          // interpolated, meets the tolerance, and f is requested there
    without_value,  // the same, where f turned out to have none
  };

  // All that a run is besides its arrays and its model; saved as bytes, so it holds no pointer and no padding. Its
  // measure is |P(x - g) - x|inf.
  struct State : base::GradientRun<Stop> {
    std::uint64_t without_memory = 0;  // 1 while the current direction was made with an empty model
    Iterate iterate = Iterate::evaluated;
    std::uint64_t quadratic = 0;            // searches in a row that agree with a quadratic f, or never (quadratic.cpp)
    double curvature = 0;                   // lambda of eq. 4.13
    double average = 0, average_count = 0;  // C and Q of Zhang and Hager
    base::WolfeSearch wolfe{};
    base::BacktrackingSearch backtracking{};
  };

  Request advance();
  Request begin_iteration();
  Request take_trial();
  Request take_step(double minimum);
  double length_to_minimum(double length, double slope);
  void move_trial(double minimum, double step_curvature);
  bool trial_is_stationary() const;
  Request verify();
  Request take_verification();
  bool choose_direction();
  bool choose_dissertation_direction();
  void accept_trial();
  bool project(std::span<const double> y, std::span<double> x, double step);
  bool settle_projection(Projected outcome);
  double reference_value() const;
  double measure_in_large();
  void start_search(double slope);
  void follow_direction(double length);
  HessianModel& model() { return dense_.size() > 0 ? static_cast<HessianModel&>(dense_) : limited_; }
  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit);

  const base::Host& host_;
  Options options_;
  FeasibleSet set_;
  LimitedMemory limited_;  // one of the two is the model, the other is of no unknowns or pairs
  DenseModel dense_;
  FaceStep face_step_;
  State state_;
  base::Array<double> x_, gradient_, trial_, trial_gradient_, target_, direction_, best_;  // n each
  base::Array<double> multipliers_;  // m: gradients are kept as those of f - t'(A x - b)
  base::Array<double> last_values_;  // ring of Options::history values of f
};

}  // namespace orbicube::projected_gradient
