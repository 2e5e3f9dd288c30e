// Block by block (Gauss-Seidel), those first that promise most: the dissertation's Algorithm 1 without its hierarchy.
//
// Its stop |E_j - E_(j-1)| < eps ends on one unlucky block; here the work ends when no block is left in the queue,
// which says that every tangent gradient is within the tolerance, or when a pass over as many blocks as there are gains
// too little. The priority is the gain that the block's or its neighbour's latest step brought, which costs nothing;
// with Method::seed it is eq. 3.6, violation of the first-order condition times mean distance from the neighbours.
#pragma once

#include <span>

#include "base/array.h"
#include "base/host.h"
#include "sphere_optimizer/block_step.h"
#include "sphere_optimizer/bucket_queue.h"
#include "sphere_optimizer/problem.h"

namespace orbicube::sphere_optimizer {

struct RelaxationOptions {
  Method method = Method::great_circle;  // or seed
  double gradient_tolerance = 1e-6;      // blocks with a shorter tangent gradient stay
  double relative_gain = 0;              // ends when a pass gains at most this part of all that was gained
  std::uint64_t max_passes = 10000;      // of as many steps as there are blocks
};

struct RelaxationResult {
  // converged, iteration_budget, evaluation_failed, or stalled: a block above the tolerance cannot be improved, or a
  // pass gained too little; running when an exception ended the work.
  Stop stop = Stop::running;
  double gain = 0;           // by how much the energy fell, all steps together
  double gradient_norm = 0;  // longest tangent gradient of a block at the end
  std::uint64_t steps = 0, evaluations = 0, failed_steps = 0;
};

// What a relaxation needs besides the points; made once, it serves any number of relaxations without an allocation.
class RelaxationSpace {
 public:
  RelaxationSpace(std::size_t count, std::pmr::memory_resource* memory) : queue(count, memory), angle(count, memory) {}
  BucketQueue queue;
  base::Array<double> angle;  // how far each block went last
};

namespace detail {

// Mean distance of a block from its neighbours, the dissertation's d of eq. 3.6.
template <class Energy>
double mean_distance(const Energy& energy, std::size_t block, std::span<const double> points) {
  const auto d = energy.dimension();
  double sum = 0, count = 0;
  energy.for_each_neighbour(block, [&](std::size_t other) {
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

// Lowers the energy of `points`, count unit vectors that the energy sees where they are. When the host cancels (Error
// "cancelled") points and result are those of the last step.
template <class Energy>
void relax(const Energy& energy, std::span<double> points, const RelaxationOptions& options, RelaxationSpace& space,
           const base::Host& host, RelaxationResult& result) {
  const auto d = energy.dimension();
  const std::size_t count = points.size() / d;
  const bool as_printed = options.method == Method::seed;
  result = {};
  BucketQueue& queue = space.queue;
  while (!queue.empty())
    queue.pop();
  std::fill(space.angle.begin(), space.angle.end(), 0.5 * std::numbers::pi);
  const auto printed_priority = [&](std::size_t block) {
    ++result.evaluations;
    return detail::tangent_gradient_norm(energy, block, points) * detail::mean_distance(energy, block, points);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (as_printed && i % 16 == 0) host.report("relaxation: priorities", i, count);
    queue.raise(static_cast<std::uint32_t>(i), as_printed ? printed_priority(i) : 1.0);
  }
  double pass_gain = 0;
  bool out_of_budget = false;
  while (!queue.empty()) {
    if (result.steps % count == 0 && result.steps > 0) {
      if (pass_gain <= options.relative_gain * result.gain) break;
      if (result.steps / count >= options.max_passes) {
        out_of_budget = true;
        break;
      }
      pass_gain = 0;
    }
    if (result.steps % 16 == 0) host.report("relaxation", result.steps, 0, -result.gain);
    const std::uint32_t block = queue.pop();
    const BlockStep step =
        improve_block(energy, block, options.gradient_tolerance, as_printed, &points[block * d], space.angle[block]);
    ++result.steps;
    result.evaluations += step.evaluations;
    if (step.failed) ++result.failed_steps;
    if (!(step.gain > 0)) continue;
    result.gain += step.gain;
    pass_gain += step.gain;
    // Its own next step gains less, as a rule a good deal less.
    queue.raise(block, as_printed ? printed_priority(block) : 0.25 * step.gain);
    energy.for_each_neighbour(block, [&](std::size_t other) {
      queue.raise(static_cast<std::uint32_t>(other), as_printed ? printed_priority(other) : step.gain);
    });
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 16 == 0) host.report("relaxation: gradient", i, count, -result.gain);
    const double norm = detail::tangent_gradient_norm(energy, i, points);
    if (!(norm <= result.gradient_norm || std::isnan(result.gradient_norm))) result.gradient_norm = norm;
  }
  result.evaluations += count;
  result.stop = out_of_budget                                        ? Stop::iteration_budget
                : result.gradient_norm <= options.gradient_tolerance ? Stop::converged
                : result.failed_steps > 0                            ? Stop::evaluation_failed
                                                                     : Stop::stalled;
}

}  // namespace orbicube::sphere_optimizer
