// Sums of magnitudes and maxima of residuals: their smooth neighbors, and runs on problems with known minima.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>

#include "base/error.h"
#include "runs.h"
#include "trust_region/corners.h"

using namespace orbicube;
using namespace orbicube::test;
using trust_region::Corners;
using trust_region::Objective;

namespace {

constexpr std::array objectives = {Objective::sum_of_magnitudes, Objective::max_magnitude, Objective::max_value};

struct Minimax {
  const char* name;
  Objective objective;
  double minimum;
  std::vector<double> start;
  std::size_t residuals;
  Function function;
};

using Point = std::span<const double>;
using Values = std::vector<double>;

// Luksan and Vlcek 2000, "Test problems for nonsmooth unconstrained and linearly constrained optimization": CB2, CB3,
// DEM, QL, LQ, Rosen-Suzuki; Rosenbrock's and Wood's residuals; and a line through points with outliers.
std::vector<Minimax> minimax_problems() {
  const auto square = [](double x) { return x * x; };
  return {
      {"CB2",
       Objective::max_value,
       1.9522244942,
       {2, 2},
       3,
       [=](Point x) {
         return Values{square(x[0]) + square(square(x[1])), square(2 - x[0]) + square(2 - x[1]),
                       2 * std::exp(x[1] - x[0])};
       }},
      {"CB3",
       Objective::max_value,
       2,
       {2, 2},
       3,
       [=](Point x) {
         return Values{square(square(x[0])) + square(x[1]), square(2 - x[0]) + square(2 - x[1]),
                       2 * std::exp(x[1] - x[0])};
       }},
      {"DEM",
       Objective::max_value,
       -3,
       {1, 1},
       3,
       [=](Point x) {
         return Values{5 * x[0] + x[1], -5 * x[0] + x[1], square(x[0]) + square(x[1]) + 4 * x[1]};
       }},
      {"QL",
       Objective::max_value,
       7.2,
       {-1, 5},
       3,
       [=](Point x) {
         const double f = square(x[0]) + square(x[1]);
         return Values{f, f + 10 * (-4 * x[0] - x[1] + 4), f + 10 * (-x[0] - 2 * x[1] + 6)};
       }},
      {"LQ",
       Objective::max_value,
       -std::sqrt(2.0),
       {-0.5, -0.5},
       2,
       [=](Point x) {
         return Values{-x[0] - x[1], -x[0] - x[1] + square(x[0]) + square(x[1]) - 1};
       }},
      {"Rosen-Suzuki",
       Objective::max_value,
       -44,
       {0, 0, 0, 0},
       4,
       [=](Point x) {
         const double a = square(x[0]), b = square(x[1]), c = square(x[2]), d = square(x[3]);
         const double f = a + b + 2 * c + d - 5 * x[0] - 5 * x[1] - 21 * x[2] + 7 * x[3];
         return Values{f, f + 10 * (a + b + c + d + x[0] - x[1] + x[2] - x[3] - 8),
                       f + 10 * (a + 2 * b + c + 2 * d - x[0] - x[3] - 10),
                       f + 10 * (2 * a + b + c + 2 * x[0] - x[1] - x[3] - 5)};
       }},
      {"line",
       Objective::sum_of_magnitudes,
       9,
       {0, 0},
       8,
       [](Point x) {
         Values r(8);
         for (std::size_t i = 0; i < 8; ++i) {
           const double t = static_cast<double>(i), outlier = i == 2 ? 5.0 : i == 5 ? -4.0 : 0.0;
           r[i] = x[0] + x[1] * t - (1 + 2 * t + outlier);
         }
         return r;
       }},
      {"Rosenbrock, largest", Objective::max_magnitude, 0, {-1.2, 1}, 2, rosenbrock().function},
      {"Rosenbrock, sum", Objective::sum_of_magnitudes, 0, {-1.2, 1}, 2, rosenbrock().function},
      {"Wood, largest", Objective::max_magnitude, 0, {-3, -1, -3, -1}, 6, wood().function},
      {"Wood, sum", Objective::sum_of_magnitudes, 0, {-3, -1, -3, -1}, 6, wood().function},
  };
}

Problem problem_of(const Minimax& m) {
  Problem p;
  p.n = m.start.size();
  p.residuals = m.residuals;
  p.objective = m.objective;
  return p;
}

}  // namespace

TEST_CASE("Smooth neighbors of sums of magnitudes and maxima are as near as they say, with exact derivatives") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  constexpr std::size_t count = 5;
  for (const Objective objective : objectives) {
    for (const double width : {1.0, 0.1, 1e-3}) {
      CAPTURE(static_cast<int>(objective));
      CAPTURE(width);
      Corners corners(objective);
      corners.set_width(width);
      std::array<double, count> r{}, change{}, at{}, p{}, q{}, beside{}, unused{};
      for (std::size_t i = 0; i < count; ++i) {
        r[i] = normal(random);
        change[i] = normal(random);
        at[i] = r[i] + change[i];
      }
      const double smooth = corners.smooth_value(r.data(), change.data(), count);
      const double exact = corners.value(at.data(), count);
      CHECK(smooth >= exact - 1e-14);
      CHECK(smooth <= exact + corners.error(count) + 1e-14);
      const double shared = corners.expand(r.data(), change.data(), count, p.data(), q.data());
      for (std::size_t i = 0; i < count; ++i) {
        const double h = 1e-5 * width;
        std::array<double, count> ahead = change, behind = change;
        ahead[i] += h;
        behind[i] -= h;
        const double slope = (corners.smooth_value(r.data(), ahead.data(), count) -
                              corners.smooth_value(r.data(), behind.data(), count)) /
                             (2 * h);
        CHECK(slope == doctest::Approx(p[i]).epsilon(1e-6).scale(1));
        corners.expand(r.data(), ahead.data(), count, beside.data(), unused.data());
        for (std::size_t k = 0; k < count; ++k) {
          const double bend = (k == i ? q[i] : 0) - shared * p[i] * p[k];
          CHECK((beside[k] - p[k]) / h * width == doctest::Approx(bend * width).epsilon(1e-4).scale(1));
        }
      }
    }
  }
}

TEST_CASE("Minima at corners are found to many digits in few evaluations") {
  for (const Minimax& m : minimax_problems()) {
    for (const Method method : {Method::two_radii, Method::dissertation}) {
      // One radius ends at another local minimum of Wood's largest residual.
      if (method == Method::dissertation && m.objective != Objective::max_value) continue;
      CAPTURE(std::string(m.name));
      CAPTURE(static_cast<int>(method));
      const base::Host host;
      Options options;
      options.method = method;
      Solver solver(problem_of(m), options, m.start, host);
      const Run end = drive(solver, m.function);
      CHECK(end.result.value <= m.minimum + 1e-7);
      CHECK(end.result.value >= m.minimum - 1e-9);
      CHECK(end.result.stop == Stop::converged);
      CHECK(end.result.evaluations <= 60 * (m.start.size() + 1));
    }
  }
}

TEST_CASE("Minima at corners within bounds") {
  // CB3, whose minimum (1, 1) is cut off: at x = 0.5, the lowest maximum is that of the second function and the third.
  Minimax m = minimax_problems()[1];
  Problem p = problem_of(m);
  const std::vector<double> lower = {-1, -1}, upper = {0.5, 3};
  p.lower = lower;
  p.upper = upper;
  const base::Host host;
  Solver solver(p, {}, m.start, host);
  const Run end = drive(solver, m.function);
  for (const std::vector<double>& x : end.asked)
    CHECK((x[0] >= -1 && x[0] <= 0.5 && x[1] >= -1 && x[1] <= 3));
  // By bisection of (1.5)^2 + (2 - y)^2 = 2 exp(y - 0.5), which falls and rises in y.
  double low = -1, high = 2;
  for (int i = 0; i < 80; ++i) {
    const double y = 0.5 * (low + high);
    (2.25 + (2 - y) * (2 - y) > 2 * std::exp(y - 0.5) ? low : high) = y;
  }
  CHECK(end.result.value == doctest::Approx(2 * std::exp(low - 0.5)).epsilon(1e-8));
}

TEST_CASE("A run on corners that is saved goes on with the same bits, and is not that of squares") {
  const Minimax m = minimax_problems()[5];
  const base::Host host;
  const Problem p = problem_of(m);
  Solver whole(p, {}, m.start, host), first(p, {}, m.start, host);
  const Run end = drive(whole, m.function);
  for (int i = 0; i < 30; ++i) {
    if (first.step() == Request::need_values) first.tell(m.function(first.pending().first(first.size())));
  }
  std::vector<std::byte> blob(first.save_size());
  first.save(blob);
  Solver second(p, Solver::options_of(blob), {}, host);
  second.load(blob);
  CHECK(drive(second, m.function).x == end.x);
  Problem squares = p;
  squares.objective = Objective::sum_of_squares;
  Solver other(squares, Solver::options_of(blob), {}, host);
  CHECK_THROWS_AS(other.load(blob), base::Error);
}

TEST_CASE("Objectives of residuals need residuals, and no signs") {
  const base::Host host;
  const std::vector<double> start = {0, 0}, sign = {1, -1};
  for (const Objective objective : objectives) {
    Problem p;
    p.n = 2;
    p.objective = objective;
    CHECK_THROWS_AS(Solver(p, {}, start, host), base::Error);
    p.residuals = 2;
    CHECK_NOTHROW(Solver(p, {}, start, host));
    p.sign = sign;
    CHECK_THROWS_AS(Solver(p, {}, start, host), base::Error);
  }
  Problem p;
  p.n = p.residuals = 2;
  p.objective = static_cast<Objective>(4);
  CHECK_THROWS_AS(Solver(p, {}, start, host), base::Error);
}
