// What a relaxation does between its passes, and the run as bytes.
#include "sphere_optimizer/relaxation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/files/saved_run.h"

namespace orbicube::sphere_optimizer {

using base::require;

namespace {

struct RelaxationDescription {
  std::uint64_t count, dimension, problem;
  RelaxationOptions options;
};
constexpr base::SavedRun<RelaxationDescription> saved_relaxation("OBCRELX1", "sphere_optimizer's relaxation");

}  // namespace

Relaxation::Relaxation(const Shape& shape, const RelaxationOptions& options, std::pmr::memory_resource* memory,
                       std::uint64_t problem)
    : shape_(shape), problem_(problem), queue_(shape.count, memory), reach_(shape.count, 0.0, memory) {
  require(shape.count >= 1 && shape.count < std::numeric_limits<std::uint32_t>::max(),
          "there must be from 1 to 4294967294 blocks");
  begin(options);
}

void Relaxation::begin(const RelaxationOptions& options) {
  require(options.method == Method::great_circle || options.method == Method::dissertation,
          "the method must be great_circle or dissertation");
  require(options.order >= Order::automatic && options.order <= Order::sweeps, "unknown order");
  require(options.gradient_tolerance >= 0 && options.relative_gain >= 0,
          "gradient_tolerance and relative_gain must not be negative");
  require(options.over_relaxation == 0 || (options.over_relaxation >= 1 && options.over_relaxation < 2),
          "over_relaxation must be from 1 to below 2, or 0");
  options_ = options;
  if (options_.method == Method::dissertation) {
    options_.order = Order::queue;
    options_.over_relaxation = 1;
  }
  state_ = {};
  if (options_.over_relaxation > 0) state_.result.over_relaxation = options_.over_relaxation;
  if (options_.order == Order::sweeps) {
    state_.sweeping = 1;
    state_.phase = Phase::stepping;
  }
  queue_.start(0x1p1023);
  std::fill(reach_.begin(), reach_.end(), 0.0);
}

void Relaxation::end_pass() {
  if (state_.pass_gain <= options_.relative_gain * state_.result.gain ||
      state_.result.steps / shape_.count >= options_.max_passes) {
    return measure_from_here();
  }
  choose_over_relaxation();
  state_.pass_gain = 0;
}

// Gains of passes fall by the square of the rate at which the distance from the optimum falls. Where Gauss-Seidel with
// factor w has the rate r, the Jacobi method has the rate m with (r + w - 1)^2 = r w^2 m^2, and the best factor is
// 2 / (1 + sqrt(1 - m^2)), approached from below as Carre advises: beyond it the rate has no information.
void Relaxation::choose_over_relaxation() {
  constexpr std::uint64_t passes = 4;  // that the rate is seen over; one more settles after each change
  constexpr double largest = 1.97;     // the rate is w - 1 at best
  constexpr double slow = 0.5;         // rates above this are what sweeps and over-relaxation are for
  if (options_.method == Method::dissertation) return;
  if (state_.window == 1) state_.window_gain = state_.pass_gain;
  if (state_.window++ <= passes) return;
  state_.window = 0;
  const double rate = std::pow(state_.pass_gain / state_.window_gain, 0.5 / static_cast<double>(passes));
  if (!(rate > slow && rate < 1)) return;
  if (options_.over_relaxation == 0) {
    double& factor = state_.result.over_relaxation;
    if (rate < 1.02 * (factor - 1)) {
      // Rates below w - 1 cannot be, those about it say that w is the best or too large: it was chosen on the way from
      // the start, where gains fall more slowly than near the optimum.
      factor = 1 + 0.75 * (factor - 1);
    } else {
      const double sum = rate + factor - 1;
      const double square = std::min(sum * sum / (rate * factor * factor), 1.0);
      const double best = 2 / (1 + std::sqrt(1 - square));
      factor = std::clamp(best - 0.25 * (2 - best), factor, std::max(factor, largest));
    }
  }
  if (options_.order == Order::automatic && state_.sweeping == 0) {
    state_.sweeping = 1;
    state_.next = state_.idle = 0;
  }
}

Stop Relaxation::stop_at_end() const {
  const RelaxationResult& result = state_.result;
  if (result.gradient_norm <= options_.gradient_tolerance) return Stop::converged;
  if (result.steps / shape_.count >= options_.max_passes) return Stop::iteration_budget;
  return result.failed_steps > 0 ? Stop::evaluation_failed : Stop::stalled;
}

template <class Self, class Visit>
void Relaxation::visit_state(Self& self, const Visit& visit) {
  static_assert(std::is_trivially_copyable_v<State>);
  visit(std::span(&self.state_, 1));
  visit(std::span(self.reach_));
  base::BucketQueue<exponents>::visit_state(self.queue_, visit);
}

std::size_t Relaxation::save_size() const {
  return shape_.size() * sizeof(double) +
         saved_relaxation.size([this](const auto& visit) { visit_state(*this, visit); });
}

void Relaxation::save(std::span<const double> points, std::span<std::byte> blob) const {
  require(points.size() == shape_.size(), "points must be those of the relaxation");
  saved_relaxation.write(blob, {shape_.count, shape_.dimension, problem_, options_}, [&](const auto& visit) {
    visit_state(*this, visit);
    visit(points);
  });
}

void Relaxation::load(std::span<const std::byte> blob, std::span<double> points) {
  const RelaxationDescription saved = saved_relaxation.description(blob);
  const bool same = saved.count == shape_.count && saved.dimension == shape_.dimension && saved.problem == problem_ &&
                    points.size() == shape_.size();
  saved_relaxation.read(blob, same, [&](const auto& visit) {
    visit_state(*this, visit);
    visit(points);
  });
  options_ = saved.options;
}

}  // namespace orbicube::sphere_optimizer
