// Options and result of the all-at-once solver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace orbicube::sphere_optimizer {

// N = count unit spheres in R^d, d = dimension: the unknowns are N blocks of d numbers.
struct Shape {
  std::size_t count, dimension;
  std::size_t size() const { return count * dimension; }
};

enum class Method : std::int32_t {
  limited_memory = 0,    // L-BFGS whose pairs are transported along the great circles
  barzilai_borwein = 1,  // nonmonotone Barzilai-Borwein steps
  great_circle = 2,      // the dissertation's Algorithm 2 with its flaws mended
  dissertation = 3,      // Algorithm 2 as printed
  truncated_newton = 4,  // trust region with conjugate gradients that end early
};

struct Options {
  Method method = Method::limited_memory;
  std::uint32_t memory = 16;           // pairs of limited_memory
  std::uint32_t history = 10;          // values that barzilai_borwein looks back on
  std::uint32_t hessian_products = 0;  // 1: the caller supplies those of truncated_newton, 0: differences of gradients
  double gradient_tolerance = 1e-8;    // on the longest of the blocks' tangent gradients
  double target = -std::numeric_limits<double>::infinity();
  std::uint64_t max_evaluations = 100000, max_iterations = 100000;
  std::uint64_t starts = 1;  // points to start from: the given one, then random ones
  std::uint64_t seed = 0;    // of the random ones
};

enum class Stop : std::int32_t {
  running = 0,
  converged = 1,
  target_reached = 2,
  evaluation_budget = 3,
  iteration_budget = 4,
  stalled = 5,
  cancelled = 6,
  evaluation_failed = 7,
};

// Short English name, e.g. "evaluation budget". Never null.
const char* stop_name(Stop stop);

struct Result {
  Stop stop = Stop::running;
  double value = std::numeric_limits<double>::quiet_NaN();  // at the point handed out
  double gradient_norm =
      std::numeric_limits<double>::infinity();  // longest tangent gradient of a block, at the iterate
  std::uint64_t evaluations = 0, failed_evaluations = 0, iterations = 0;
  std::uint64_t products = 0;                // of the Hessian, supplied or from differences
  std::uint64_t starts = 0, best_start = 0;  // how many were begun; the one that led to the value, from 0
};

}  // namespace orbicube::sphere_optimizer
