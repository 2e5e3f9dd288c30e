// What is minimized, how, and how it ended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace orbicube::trust_region {

// How f is made of residuals.
enum class Objective : std::int32_t {
  sum_of_squares = 0,     // sum_i sign_i r_i^2
  sum_of_magnitudes = 1,  // sum_i |r_i|
  max_magnitude = 2,      // max_i |r_i|
  max_value = 3,          // max_i r_i
};

// min f(x), or min h(r(x)) for residuals r and h an Objective, subject to lower <= x <= upper. Views of the caller's
// arrays; a solver copies what it needs.
struct Problem {
  std::size_t n = 0;                     // unknowns
  std::size_t residuals = 0;             // m, or 0 for a scalar f
  std::span<const double> lower, upper;  // n each, or empty: unbounded; infinities allowed
  std::span<const double> scale;         // n typical magnitudes, or empty: chosen. Radii are lengths of (x - y) / scale
  std::span<const double> sign;          // of squares: m entries +1 or -1, or empty: all +1
  Objective objective = Objective::sum_of_squares;

  std::size_t outputs() const { return residuals == 0 ? 1 : residuals; }
};

enum class Method : std::int32_t {
  two_radii = 0,     // Powell's trust-region radius and resolution
  dissertation = 1,  // the dissertation's section 4.4.2: one radius
};

enum class Start : std::int32_t {
  automatic = 0,
  chain = 1,  // n + 1 points, each a step along an axis from the best so far
  cross = 2,  // x0 and steps along the axes to both sides, which can be evaluated at the same time
};

struct Options {
  Method method = Method::two_radii;
  Start start = Start::automatic;
  std::uint64_t points = 0;  // maximum number interpolated, n + 2 to (n+1)(n+2)/2; 0: automatic
  double radius_begin = 0;   // 0: a tenth of max(1, |x0 / scale|inf), of 1 where the scale is chosen
  double radius_end = 1e-8;  // of the resolution
  double target = -std::numeric_limits<double>::infinity();  // stop once f <= target
  double noise_absolute = 0, noise_relative = 0;  // f is known to max(noise_absolute, noise_relative |f|) only
  std::uint64_t restarts = 0;                     // times to begin again around the best point
  std::uint64_t max_evaluations = 0;              // 0: 500 (n + 1)
  // 0: a failed evaluation only shortens a step, which is enough for a run of few evaluations.
  std::uint64_t follow_edges = 1;
};

enum class Stop : std::int32_t {
  running = 0,
  converged = 1,  // the resolution reached radius_end, and no step improves the models
  target_reached = 2,
  evaluation_budget = 3,
  noise_limit = 4,  // the values left to compare differ by less than the noise
  stalled = 5,      // no step that the arithmetic resolves
  cancelled = 6,
  evaluation_failed = 7,  // no value at the start, or too many failures in a row
  resolution_limit = 8,   // the resolution reached radius_end, and the models still slope: f ends there, is not smooth,
                          // or bends by lengths that the given scale is far from
};

const char* stop_name(Stop stop);

// What is known of a run at any time.
struct Result {
  Stop stop = Stop::running;
  double value = std::numeric_limits<double>::quiet_NaN();  // f at the best point
  double radius = 0, resolution = 0;                        // now
  std::uint64_t evaluations = 0, failed_evaluations = 0, iterations = 0, restarts = 0;
  std::uint64_t points = 0;    // interpolated now
  std::uint64_t rebuilds = 0;  // of the interpolation's inverse from scratch
};

}  // namespace orbicube::trust_region
