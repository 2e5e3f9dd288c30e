// Gradients that are not quite those of f, functions that fall without end, and the check of a gradient.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "base/error.h"
#include "projected_gradient/gradient_check.h"
#include "runs.h"

using namespace orbicube;
using namespace orbicube::test;
using projected_gradient::check_gradient;
using projected_gradient::GradientCheck;

namespace {

// Evaluations after the last by which f fell.
std::size_t after_last_gain(Case c, const Options& options, Run* end) {
  double lowest = std::numeric_limits<double>::infinity();
  std::size_t count = 0, last = 0;
  c.function = [&, inner = c.function](std::span<const double> x, std::span<double> g) {
    const double f = inner(x, g);
    ++count;
    if (f < lowest) {
      lowest = f;
      last = count;
    }
    return f;
  };
  *end = run(c, options);
  return count - last;
}

Case free_case(const std::vector<double>& start, const Function& f) {
  return {Constraints(start.size()), start, f};
}

Function differenced(double step, double offset) {
  return [=](std::span<const double> x, std::span<double> g) {
    std::vector<double> at(x.begin(), x.end()), unused(x.size());
    const double f = rosenbrock(at, unused) + offset;
    for (std::size_t j = 0; j < x.size(); ++j) {
      at[j] = x[j] + step;
      g[j] = (rosenbrock(at, unused) + offset - f) / step;
      at[j] = x[j];
    }
    return f;
  };
}

Function squares(const std::vector<double>& factor) {  // gradients times these
  return [=](std::span<const double> x, std::span<double> g) {
    double f = 0;
    for (std::size_t j = 0; j < x.size(); ++j) {
      f += (x[j] - 1) * (x[j] - 1);
      g[j] = factor[j] * 2 * (x[j] - 1);
    }
    return f;
  };
}

projected_gradient::ValueAndGradient checked(const Function& f, std::size_t n) {
  return [f, n](const double* x, double* gradient) {
    std::vector<double> g(n);
    const double value = f({x, n}, g);
    if (gradient != nullptr) std::copy(g.begin(), g.end(), gradient);
    return value;
  };
}

GradientCheck check(const Function& f, const std::vector<double>& x, const Constraints& constraints) {
  const base::Host host;
  return check_gradient(constraints.problem(), x, checked(f, x.size()), host);
}

}  // namespace

TEST_CASE("With a gradient of differences a run ends soon after f is at its floor") {
  for (const double step : {1e-8, 1e-6, 1e-5}) {
    for (const double offset : {0.0, 1.0}) {
      CAPTURE(step);
      CAPTURE(offset);
      Run end;
      CHECK(after_last_gain(free_case({-1.2, 1}, differenced(step, offset)), {}, &end) <= 80);
      CHECK((end.result.stop == Stop::stalled || end.result.stop == Stop::converged));
      // Where the differenced gradient is zero f is about step^2 times its curvatures above the minimum.
      CHECK(end.result.value - offset < 1e6 * step * step + 1e-12);
      CHECK(end.result.evaluations < 200);
    }
  }
}

TEST_CASE("With a gradient in single precision a run ends soon after f is at its floor") {
  const auto in_single = [](bool value_too) {
    return [=](std::span<const double> x, std::span<double> g) {
      const double f = rosenbrock(x, g) + 1;
      for (double& entry : g)
        entry = static_cast<double>(static_cast<float>(entry));
      return value_too ? static_cast<double>(static_cast<float>(f)) : f;
    };
  };
  for (const bool value_too : {false, true}) {
    Run end;
    CHECK(after_last_gain(free_case({-1.2, 1, -1.2, 1}, in_single(value_too)), {}, &end) <= 80);
    CHECK(end.result.value < 1 + 1e-6);
  }
}

TEST_CASE("Noise of f does not end a run early where the gradient is right") {
  constexpr double noise = 5e-12;
  std::mt19937 random(5);
  double orders = 0;
  std::size_t runs = 0, converged = 0;
  for (int k = 0; k < 40; ++k) {
    std::vector<double> start(10), unused(10);
    for (double& x : start)
      x = 4e-9 * static_cast<double>(random() >> 2) - 2;
    const Case c = free_case(start, [](std::span<const double> x, std::span<double> g) {
      std::uint64_t bits = 0;
      for (const double entry : x)
        bits = ((bits ^ std::bit_cast<std::uint64_t>(entry)) * 0x9e3779b97f4a7c15) ^ (bits >> 29);
      return (1 + rosenbrock(x, g)) * (1 + noise * (0x1p-63 * static_cast<double>(bits) - 1));
    });
    Options options;
    options.gradient_tolerance = 1e-7;
    const Run end = run(c, options);
    CHECK(end.result.evaluations < 600);
    converged += end.result.stop == Stop::converged ? 1 : 0;
    const double above = rosenbrock(end.x, unused);
    CHECK((above < 1e-11 || std::abs(above - 3.98658) < 1e-5));  // the two minima
    if (above < 1) {
      orders += std::log10(std::max(above, 1e-20));
      ++runs;
    }
  }
  CHECK(runs >= 25);
  // Where the noise that a search sees does not let f end higher, 22 runs of 40 stall.
  CHECK(converged == 40);
  // Slopes resolve f far below its noise. By searches that stop as soon as values contradict slopes the mean is -15.0.
  CHECK(orders / static_cast<double>(runs) < -17.5);
}

TEST_CASE("A gradient of the wrong sign is given up within some tens of evaluations, by every method") {
  for (const Options& options : every_method) {
    for (const auto& factor : std::vector<std::vector<double>>{{-1, -1}, {1, -1}, {-1e-3, -1e3}}) {
      for (const bool boxed : {false, true}) {
        Case c = free_case({3, 4}, squares(factor));
        if (boxed) c.constraints = Constraints(2, -5, 5);
        const Run end = run(c, options);
        CHECK(end.result.stop == Stop::stalled);
        CHECK(end.result.evaluations < 130);
        CHECK(end.result.value <= 13);
      }
    }
  }
}

TEST_CASE("Where f falls without end a run says so, and never that it converged") {
  const Function linear = [](std::span<const double> x, std::span<double> g) {
    std::fill(g.begin(), g.end(), 1.0);
    return x[0] + x[1];
  };
  const Function downward = [](std::span<const double> x, std::span<double> g) {
    g[0] = -2 * x[0];
    g[1] = -2 * x[1];
    return -x[0] * x[0] - x[1] * x[1];
  };
  const Function difference = [](std::span<const double> x, std::span<double> g) {
    g[0] = 1;
    g[1] = -1;
    return x[0] - x[1];
  };
  const Function exponential = [](std::span<const double> x, std::span<double> g) {
    g[0] = -std::exp(x[0]);
    g[1] = 0;
    return -std::exp(x[0]);
  };
  Constraints half(2), row(2);
  half.lower = {-infinity, 0};
  row.add_row({{0, 1}, {1, 1}}, 3);
  const Case cases[] = {
      {Constraints(2), {1, 2}, linear}, {Constraints(2), {1e9, -1e9}, linear}, {half, {1, 2}, linear},
      {row, {1, 2}, difference},        {Constraints(2), {1, 2}, downward},    {Constraints(2), {1, 2}, exponential}};
  for (const Case& c : cases) {
    const Run end = run(c);
    CHECK(end.result.stop == Stop::unbounded);
    CHECK(end.result.evaluations < 200);
    CHECK(end.result.value < -1e15);
    CHECK(end.result.projected_gradient > 1e-8);
    Options seed = with(Method::dissertation);
    seed.max_evaluations = 2000;
    CHECK(run(c, seed).result.stop != Stop::converged);
  }
  // The projection of the caller's is on a half-plane, along the edge of which f falls.
  projected_gradient::Problem own;
  own.n = 2;
  own.project = [](const double* y, double* x) {
    x[0] = y[0];
    x[1] = std::max(y[1], 0.0);
    return true;
  };
  const base::Host host;
  Solver solver(own, {}, std::vector<double>{1, 2}, host);
  CHECK(drive(solver, linear).result.stop != Stop::converged);
}

TEST_CASE("A far minimum is one, though x is large") {
  for (const double far : {1e6, 1e9, 1e12}) {
    const Case c = free_case({0, 0}, [=](std::span<const double> x, std::span<double> g) {
      g[0] = 2 * (x[0] - far);
      g[1] = 4 * (x[1] + far);
      return (x[0] - far) * (x[0] - far) + 2 * (x[1] + far) * (x[1] + far);
    });
    const Run end = run(c);
    CHECK(end.result.stop == Stop::converged);
    CHECK(end.x[0] == doctest::Approx(far).epsilon(1e-12));
  }
}

TEST_CASE("A value that comes before a run is cancelled counts") {
  const base::Host host;
  const Case c = free_case({0, 0}, squares({1, 1}));
  Solver solver(c.constraints.problem(), {}, c.start, host);
  std::vector<double> g(2);
  double lowest = infinity;
  for (int k = 0; k < 2; ++k) {
    while (solver.step() == Request::iteration) {
    }
    const double f = c.function(solver.point(), g);
    lowest = std::min(lowest, f);
    solver.tell(f, g);
  }
  solver.cancel();
  CHECK(solver.result().stop == Stop::cancelled);
  CHECK(solver.result().value == lowest);
  CHECK(c.function(solver.best_point(), g) == lowest);
}

TEST_CASE("A gradient that is right agrees with differences, at bounds and in any unit too") {
  const Function right = rosenbrock;
  for (const auto& x : std::vector<std::vector<double>>{{-1.2, 1}, {0, 0}, {1, 1}, {3, -7, 2}}) {
    const GradientCheck found = check(right, x, Constraints(x.size()));
    CHECK(found.agrees);
    CHECK(found.compared == x.size());
    CHECK(found.evaluations <= 1 + 8 * x.size());
  }
  Constraints box(2);
  box.lower = {-1.2, 0.5};
  box.upper = {0, 1};
  CHECK(check(right, {-1.2, 1}, box).agrees);
  CHECK(check(right, {-9, 9}, box).agrees);  // moved into the box
  for (const double unit : {1e-8, 1e8}) {
    const Function scaled = [=](std::span<const double> x, std::span<double> g) {
      std::vector<double> u(x.begin(), x.end());
      for (double& value : u)
        value /= unit;
      const double f = rosenbrock(u, g);
      for (double& entry : g)
        entry /= unit;
      return f;
    };
    CHECK(check(scaled, {-1.2 * unit, 1.5 * unit}, Constraints(2)).agrees);
  }
  CHECK(check(differenced(1e-8, 0), {-1.2, 1.5}, Constraints(2)).agrees);
}

TEST_CASE("A gradient that is wrong is found, with its worst entry") {
  const GradientCheck sign = check(squares({1, -1, 1}), {3, 4, 5}, Constraints(3));
  CHECK(!sign.agrees);
  CHECK(sign.worst == 1);
  CHECK(sign.told == -6);
  CHECK(sign.difference == doctest::Approx(6));
  CHECK(sign.error > 1);
  const GradientCheck factor = check(squares({1, 1, 1.001}), {3, 4, 5}, Constraints(3));
  CHECK(!factor.agrees);
  CHECK(factor.worst == 2);
  CHECK(factor.error == doctest::Approx(1e-3).epsilon(0.01));
  // One that differences with the value's own rounding do not tell from right.
  CHECK(check(squares({1, 1, 1 + 1e-7}), {3, 4, 5}, Constraints(3)).agrees);
}

TEST_CASE("What cannot be compared is left out, and a start without a value is refused") {
  Constraints fixed(2);
  fixed.lower[1] = fixed.upper[1] = 4;
  CHECK(check(squares({1, -1}), {3, 4}, fixed).compared == 1);
  CHECK(check(squares({1, -1}), {3, 4}, fixed).agrees);
  const Function root = [](std::span<const double> x, std::span<double> g) {
    g[0] = 0.5 / std::sqrt(x[0]);
    return std::sqrt(x[0]);
  };
  CHECK(check(root, {1e-12}, Constraints(1)).agrees);  // no value on one side of some steps
  CHECK_THROWS_AS(check(root, {-1}, Constraints(1)), base::Error);
}
