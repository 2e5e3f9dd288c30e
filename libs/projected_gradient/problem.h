// What is minimized over what: min f(x) subject to A x = b and lower <= x <= upper, how, and how it ended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>

namespace orbicube::projected_gradient {

// Of a start, and of what bounds must leave room for: so that squares stay in the range of double.
inline constexpr double max_coordinate = 1e150;

// The feasible set, as views of the caller's arrays; a solver copies what it needs.
struct Problem {
  std::size_t n = 0;                       // unknowns
  std::span<const double> lower, upper;    // n each, or empty: unbounded; infinities allowed
  std::span<const std::size_t> row_start;  // m + 1 offsets into column and value, or empty: m = 0
  std::span<const std::uint32_t> column;   // entries of one column in one row are summed
  std::span<const double> value;
  std::span<const double> rhs;  // b, m entries

  // Instead of rows and bounds: the nearest point of a closed convex set, from y into x (n each, never the same array).
  // Returns false when it cannot. Must be a function of y alone.
  std::function<bool(const double* y, double* x)> project;

  std::size_t rows() const { return rhs.size(); }
};

enum class Method : std::int32_t {
  face = 0,          // Barzilai-Borwein steps find the face, a limited-memory model is minimized in it
  dissertation = 1,  // the dissertation's: eq. 4.11 to 4.13 with a nonmonotone line search
};

enum class LineSearch : std::int32_t {  // of Method::dissertation
  max_of_last = 0,                      // Grippo, Lampariello, Lucidi 1986
  average = 1,                          // Zhang, Hager 2004
};

struct Options {
  Method method = Method::face;
  LineSearch line_search = LineSearch::max_of_last;
  std::uint32_t memory = 10;                                 // pairs of the limited-memory model
  std::uint32_t history = 10;                                // values that LineSearch::max_of_last looks back on
  double average_weight = 0.85;                              // eta of LineSearch::average, in [0, 1]
  double gradient_tolerance = 1e-8;                          // on |P(x - g) - x|inf
  double target = -std::numeric_limits<double>::infinity();  // stop once f <= target
  std::uint64_t max_evaluations = 100000;
  std::uint64_t max_iterations = 100000;
};

enum class Stop : std::int32_t {
  running = 0,
  converged = 1,  // the projected gradient is within the tolerance
  target_reached = 2,
  evaluation_budget = 3,
  iteration_budget = 4,
  stalled = 5,     // no step that the arithmetic can resolve improves f
  infeasible = 6,  // no x satisfies the constraints
  cancelled = 7,
  evaluation_failed = 8,  // f or its gradient not finite at the start, or at every point tried along two directions
  projection_failed = 9,  // the user's projection failed, or the rows are too ill-conditioned to be met
  unbounded = 10,         // f falls along a direction without end, or below every number
};

const char* stop_name(Stop stop);

// What is known of a run at any time.
struct Result {
  Stop stop = Stop::running;
  double value = std::numeric_limits<double>::quiet_NaN();  // f at the point handed out
  // |P(x - g) - x|inf at the current iterate; where x is so large that x - g rounds to x, by the multipliers
  double projected_gradient = std::numeric_limits<double>::infinity();
  double equality_residual = 0;  // largest |a'x - b| / (|b| + sum |a_j x_j|) of a row, at the point handed out
  std::uint64_t evaluations = 0, failed_evaluations = 0, iterations = 0;
  std::uint64_t projection_passes = 0;  // over the unknowns, all projections together
  double certificate_gap = 0;           // see FeasibleSet::certificate
};

}  // namespace orbicube::projected_gradient
