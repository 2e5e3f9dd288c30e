// Block by block (Gauss-Seidel): the dissertation's Algorithm 1 without its hierarchy.
//
// First by a queue, those blocks first that promise most. The priority is the gain that the block's or its neighbor's
// latest step brought, which costs nothing; with Method::dissertation it is eq. 3.6, violation of the first-order
// condition times mean distance from the neighbors. When the remaining gain is spread over all blocks, which shows in
// gains that fall slowly from pass to pass, sweeps over the blocks in their order take over, and steps are over-relaxed
// by Young's factor for the rate that was seen (Young 1954, "Iterative methods for solving partial difference equations
// of elliptic type"; its estimate after Carre 1961).
//
// Algorithm 1's stop |E_j - E_(j-1)| < eps ends on one unlucky block; here the work ends when the queue is empty or a
// whole sweep moved nothing, which says that every tangent gradient is within the tolerance, or when a pass over as
// many blocks as there are gains too little.
#pragma once

#include <numbers>
#include <span>

#include "base/array.h"
#include "base/bucket_queue.h"
#include "base/host.h"
#include "sphere_optimizer/block_step.h"
#include "sphere_optimizer/problem.h"

namespace orbicube::sphere_optimizer {

enum class Order : std::int32_t {
  automatic = 0,  // the queue, then sweeps when gains fall slowly
  queue = 1,
  sweeps = 2,  // the blocks' own order, forward
};

struct RelaxationOptions {
  Method method = Method::great_circle;  // or dissertation, which keeps to the queue and does not over-relax
  Order order = Order::automatic;
  std::int32_t second_order = 0;     // for callers that choose their energy by it; nothing here looks at it
  std::uint32_t reserved = 0;        // saved runs hold no padding
  double gradient_tolerance = 1e-6;  // blocks with a shorter tangent gradient stay
  double relative_gain = 0;          // ends when a pass gains at most this part of all that was gained
  double over_relaxation = 0;        // from 1 to below 2, or 0: chosen from the rate at which gains fall
  std::uint64_t max_passes = 10000;  // of as many steps as there are blocks
};

struct RelaxationResult {
  // converged, iteration_budget, evaluation_failed, or stalled: a block above the tolerance cannot be improved, or a
  // pass gained too little; running before the end.
  Stop stop = Stop::running;
  std::uint32_t reserved = 0;  // saved runs hold no padding
  double gain = 0;             // by how much the energy fell, all steps together
  double gradient_norm = 0;    // longest tangent gradient of a block, known at the end
  std::uint64_t steps = 0, evaluations = 0, failed_steps = 0;
  double over_relaxation = 1;  // of the latest step
};

namespace detail {

// Mean distance of a block from its neighbors, the dissertation's d of eq. 3.6.
template <class Energy>
double mean_distance(const Energy& energy, std::size_t block, std::span<const double> points) {
  const auto d = energy.dimension();
  double sum = 0, count = 0;
  energy.for_each_neighbor(block, [&](std::size_t other) {
    double square = 0;
    for (std::size_t k = 0; k < d; ++k) {
      const double difference = points[block * d + k] - points[other * d + k];
      square += difference * difference;
    }
    sum += std::sqrt(square);
    count += 1;
  });
  return count > 0 ? sum / count : 1;
}

template <class Energy>
double tangent_gradient_norm(const Energy& energy, std::size_t block, std::span<const double> points) {
  const auto d = energy.dimension();
  BlockVector<DimensionOf<Energy>> gradient;
  const double value = energy.value_and_gradient(block, gradient.data());
  make_tangent(d, &points[block * d], gradient.data());
  const double norm = std::sqrt(block_dot(d, gradient.data(), gradient.data()));
  return std::isfinite(value) ? norm : value;
}

}  // namespace detail

// One relaxation, from begin() to its end in one call of run() or in several. All memory is allocated by the
// constructor; begin() makes it serve again.
class Relaxation {
 public:
  // Throws invalid-argument. `problem` is a number of the caller's that load() compares, e.g. a hash of who is whose
  // neighbor.
  Relaxation(const Shape& shape, const RelaxationOptions& options, std::pmr::memory_resource* memory,
             std::uint64_t problem = 0);

  // Starts again; throws invalid-argument.
  void begin(const RelaxationOptions& options);

  // Lowers the energy of `points`, unit vectors that the energy sees where they are, until the end, or for about
  // `max_steps` steps: run() again goes on as if there had been no break, and so it does when the host (Error
  // "cancelled") or the energy threw. Points and result are those of the last whole step then.
  template <class Energy>
  void run(const Energy& energy, std::span<double> points, const base::Host& host,
           std::uint64_t max_steps = std::numeric_limits<std::uint64_t>::max());

  bool done() const { return state_.phase == Phase::done; }
  const RelaxationResult& result() const { return state_.result; }
  const Shape& shape() const { return shape_; }
  const RelaxationOptions& options() const { return options_; }

  // The run and its points as save_size() bytes between two calls of run(), and back into a relaxation of the same
  // shape and problem, with the options of the saved one. load() throws invalid-argument for a blob of another problem
  // and malformed-file kinds for one that is damaged.
  std::size_t save_size() const;
  void save(std::span<const double> points, std::span<std::byte> blob) const;
  void load(std::span<const std::byte> blob, std::span<double> points);

 private:
  enum class Phase : std::int32_t { filling, stepping, measuring, done };

  // All that a run is besides its arrays; saved as bytes, so it holds no pointer.
  struct State {
    Phase phase = Phase::filling;
    std::uint32_t woken = 0;   // the block whose neighbors are to be woken before the next step
    std::uint64_t waking = 0;  // 1: they are
    std::uint64_t sweeping = 0;
    std::uint64_t next = 0;  // block to be put into the queue, stepped in a sweep, or measured
    std::uint64_t idle = 0;  // blocks in a row that stayed
    double step_gain = 0, pass_gain = 0;
    std::uint64_t window = 1;  // passes since the over-relaxation was last looked at
    double window_gain = 0;    // of the window's first pass
    RelaxationResult result;
  };

  template <class Energy>
  double printed_priority(const Energy& energy, std::size_t block, std::span<const double> points) const {
    return detail::tangent_gradient_norm(energy, block, points) * detail::mean_distance(energy, block, points);
  }
  template <class Energy>
  void take_step(const Energy& energy, std::span<double> points);
  template <class Energy>
  void wake(const Energy& energy, std::span<const double> points);
  // After as many steps as there are blocks.
  void end_pass();
  void choose_over_relaxation();
  void measure_from_here() {
    state_.phase = Phase::measuring;
    state_.next = 0;
    state_.result.gradient_norm = 0;
  }
  Stop stop_at_end() const;
  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit);

  // Gains of any size are distinguished: one bucket for each exponent.
  static constexpr std::size_t exponents = 2048;

  Shape shape_;
  std::uint64_t problem_;
  RelaxationOptions options_;
  State state_;
  base::BucketQueue<exponents> queue_;
  base::Array<double> reach_;  // each block's memory of its last step (block_step.h)
};

template <class Energy>
void Relaxation::run(const Energy& energy, std::span<double> points, const base::Host& host, std::uint64_t max_steps) {
  const bool as_printed = options_.method == Method::dissertation;
  RelaxationResult& result = state_.result;
  result.stop = Stop::running;
  for (; state_.phase == Phase::filling; ++state_.next) {
    if (state_.next == shape_.count) {
      state_.phase = Phase::stepping;
      state_.next = 0;
      break;
    }
    if (as_printed && state_.next % 16 == 0) host.report("relaxation: priorities", state_.next, shape_.count);
    queue_.raise(static_cast<std::uint32_t>(state_.next),
                 as_printed ? printed_priority(energy, state_.next, points) : 1.0);
    if (as_printed) ++result.evaluations;
  }
  while (state_.phase == Phase::stepping) {
    if (state_.waking != 0) wake(energy, points);
    if (state_.phase != Phase::stepping) break;
    if (state_.sweeping != 0 ? state_.idle >= shape_.count : queue_.empty()) {
      measure_from_here();
      break;
    }
    if (max_steps-- == 0) return;
    if (result.steps % 16 == 0) host.report("relaxation", result.steps, 0, -result.gain);
    take_step(energy, points);
  }
  for (; state_.phase == Phase::measuring; ++state_.next) {
    if (state_.next == shape_.count) {
      state_.phase = Phase::done;
      break;
    }
    if (state_.next % 16 == 0) host.report("relaxation: gradient", state_.next, shape_.count, -result.gain);
    const double norm = detail::tangent_gradient_norm(energy, state_.next, points);
    if (!(norm <= result.gradient_norm || std::isnan(result.gradient_norm))) result.gradient_norm = norm;
    ++result.evaluations;
  }
  result.stop = stop_at_end();
}

template <class Energy>
void Relaxation::take_step(const Energy& energy, std::span<double> points) {
  const auto d = energy.dimension();
  RelaxationResult& result = state_.result;
  const auto block = state_.sweeping != 0 ? static_cast<std::uint32_t>(state_.next) : queue_.front();
  const StepRule rule{options_.gradient_tolerance, result.over_relaxation, options_.method == Method::dissertation};
  const BlockStep step = improve_block(energy, block, rule, &points[block * d], reach_[block]);
  // Nothing throws from here on, so the step is taken wholly or not at all.
  if (state_.sweeping != 0) {
    state_.next = state_.next + 1 < shape_.count ? state_.next + 1 : 0;
  } else {
    queue_.pop();
  }
  ++result.steps;
  result.evaluations += step.evaluations;
  if (step.failed) ++result.failed_steps;
  state_.idle = step.gain > 0 ? 0 : state_.idle + 1;
  result.gain += step.gain;
  state_.pass_gain += step.gain;
  state_.step_gain = step.gain;
  state_.woken = block;
  state_.waking = 1;
}

// Puts the block of the last step and its neighbors into the queue. To do it twice does no harm, so it may be broken
// off anywhere.
template <class Energy>
void Relaxation::wake(const Energy& energy, std::span<const double> points) {
  const double gain = state_.step_gain;
  if (gain > 0 && state_.sweeping == 0) {
    std::uint64_t evaluations = 0;
    const bool as_printed = options_.method == Method::dissertation;
    const auto raise = [&](std::size_t block, double priority) {
      if (as_printed) {
        priority = printed_priority(energy, block, points);
        ++evaluations;
      }
      queue_.raise(static_cast<std::uint32_t>(block), priority);
    };
    // The block's own next step gains less, as a rule a good deal less.
    raise(state_.woken, 0.25 * gain);
    energy.for_each_neighbor(state_.woken, [&](std::size_t other) { raise(other, gain); });
    state_.result.evaluations += evaluations;
  }
  state_.waking = 0;
  if (state_.result.steps % shape_.count == 0) end_pass();
}

// The whole relaxation at once.
template <class Energy>
RelaxationResult relax(const Energy& energy, std::span<double> points, const RelaxationOptions& options,
                       const base::Host& host) {
  const std::size_t d = energy.dimension();
  Relaxation relaxation({points.size() / d, d}, options, host.memory);
  relaxation.run(energy, points, host);
  return relaxation.result();
}

}  // namespace orbicube::sphere_optimizer
