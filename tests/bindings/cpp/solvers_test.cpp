// The C++ wrappers of the solvers: the bits of C, exceptions through callbacks both ways, reverse communication.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include <orbicube/projected_gradient.hpp>
#include <orbicube/sphere_map.hpp>
#include <orbicube/sphere_optimizer.hpp>
#include <orbicube/trust_region.hpp>

using namespace orbicube;

namespace {

struct Mine : std::runtime_error {
  using std::runtime_error::runtime_error;
};

double model(Doubles x, std::size_t i) {
  return x[0] / (1 + x[1] * (0.5 * double(i))) + x[2];
}
void misfit(Doubles x, View<double> residuals) {
  const std::array<double, 3> truth = {2.5, 0.7, 0.4};
  for (std::size_t i = 0; i < residuals.size(); ++i)
    residuals[i] = model(x, i) - model(truth, i);
}
std::int32_t misfit_in_c(const double* x, std::size_t n, double* residuals, void*) {
  misfit(Doubles(x, n), View<double>(residuals, 8));
  return 0;
}
double quadratic(Doubles x, View<double> gradient) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    gradient[i] = 2 * (x[i] - double(i));
    sum += (x[i] - double(i)) * (x[i] - double(i));
  }
  return sum;
}
double height(Doubles x, View<double> gradient) {
  for (std::size_t i = 0; i < gradient.size(); ++i)
    gradient[i] = i % 3 == 2 ? 1 : 0;
  double sum = 0;
  for (std::size_t i = 2; i < x.size(); i += 3)
    sum += x[i];
  return sum;
}

}  // namespace

TEST_CASE("a solver with a closure, by reverse communication, and in C ends in the same bits") {
  trust_region::Problem problem;
  problem.lower = {0, 0, -1};
  problem.upper = {10, 2, 1};
  std::vector<double> x = {1, 0.1, 0}, in_c = x;
  const auto result = trust_region::least_squares(misfit, x, 8, problem);
  CHECK(result.stop == OBC_TRUST_REGION_CONVERGED);

  obc_trust_region_problem plain;
  obc_trust_region_problem_init(&plain, sizeof plain);
  plain.n = 3;
  plain.residuals = 8;
  plain.lower = problem.lower.data();
  plain.upper = problem.upper.data();
  REQUIRE(obc_trust_region_minimize(&plain, nullptr, misfit_in_c, nullptr, in_c.data(), nullptr, nullptr, nullptr) ==
          OBC_OK);
  CHECK(x == in_c);

  trust_region::Solver solver(std::array<double, 3>{1, 0.1, 0}, 8, problem);
  std::vector<double> residuals(8);
  while (solver.ask()) {
    misfit(solver.point(), residuals);
    solver.tell(residuals);
    solver = trust_region::Solver::load(solver.save(), 3, 8, problem);
  }
  CHECK(solver.best() == in_c);
  CHECK(solver.result().evaluations == result.evaluations);
}

TEST_CASE("what a function throws comes out of the solver, and no handle is lost") {
  std::vector<double> x = {0, 0}, ball = {1, 0, 0};
  CHECK_THROWS_AS(trust_region::minimize([](Doubles) -> double { throw Mine("f"); }, x), Mine);
  CHECK_THROWS_AS(projected_gradient::minimize([](Doubles, View<double>) -> double { throw Mine("f"); }, x), Mine);
  CHECK_THROWS_AS(sphere_optimizer::minimize([](Doubles, View<double>) -> double { throw Mine("f"); }, ball, 3), Mine);
  CHECK_THROWS_AS(sphere_optimizer::relax(
                      [](std::size_t, const double*, const double*, double*, double*) -> double { throw Mine("f"); },
                      ball, 3, {{}}),
                  Mine);
  projected_gradient::Problem problem;
  problem.project = [](Doubles, View<double>) { throw Mine("projection"); };
  CHECK_THROWS_AS(projected_gradient::minimize(quadratic, x, problem), Mine);
  CHECK_THROWS_AS(projected_gradient::Solver(x, problem).ask(), Mine);
  Host host;
  host.on_progress([](const Progress&) -> bool { throw Mine("progress"); });
  CHECK_THROWS_AS(sphere_map::compute(Mesh::make("sphere", 200), {}, &host), Mine);
}

TEST_CASE("a function may stop a run or have no value") {
  int calls = 0;
  std::vector<double> x = {-1.2, 1};
  const auto result = trust_region::minimize(
      [&](Doubles at) {
        if (++calls > 20) throw Stop();
        if (calls == 5) throw EvaluationFailed();
        return std::pow(at[0] - 1, 2) + std::pow(at[1], 2);
      },
      x);
  CHECK(result.stop == OBC_TRUST_REGION_CANCELLED);
  CHECK(result.failed_evaluations == 1);
  CHECK(std::pow(x[0] - 1, 2) + std::pow(x[1], 2) == result.value);
}

TEST_CASE("a value that comes with a stop counts") {
  const auto distance = [](Doubles at) { return std::pow(at[0] - 1, 2) + std::pow(at[1] - 1, 2); };
  std::vector<double> x = {0, 0};
  const auto near = [&](Doubles at) {
    if (distance(at) < 1e-3) throw Stop{distance(at)};
    return distance(at);
  };
  const auto result = trust_region::minimize(near, x);
  CHECK(result.stop == OBC_TRUST_REGION_CANCELLED);
  CHECK(result.value < 1e-3);
  CHECK(distance(x) == result.value);
  x = {0, 0};
  const auto slopes = [&](Doubles at, View<double> gradient) {
    gradient[0] = 2 * (at[0] - 1);
    gradient[1] = 2 * (at[1] - 1);
    return near(at);
  };
  CHECK(projected_gradient::minimize(slopes, x).value < 1e-3);
}

TEST_CASE("projected gradient: rows, multipliers, a projection of one's own, a certificate") {
  projected_gradient::Problem problem;
  problem.lower.assign(3, 0.0);
  problem.rows.add({{0, 1}, {1, 1}, {2, 1}}, 1);
  projected_gradient::Solver solver(std::vector<double>{0, 0, 0}, problem);
  std::vector<double> gradient(3);
  while (solver.ask()) {
    const double value = quadratic(solver.point(), gradient);
    solver.tell(value, gradient);
    solver = projected_gradient::Solver::load(solver.save(), 3, problem);
  }
  const std::vector<double> best = solver.best();
  CHECK(best[0] == 0);
  CHECK(std::abs(best[1]) < 1e-8);  // the tolerance is 1e-8
  CHECK(std::abs(best[2] - 1) < 1e-8);
  CHECK(std::abs(solver.multipliers()[0] + 2) < 1e-7);

  std::vector<double> x = {5, 5, 5};
  const auto multipliers = projected_gradient::project(std::vector<double>{2, 2, 2}, x, problem);
  CHECK(std::abs(x[0] - 1. / 3) < 1e-15);
  CHECK(std::abs(multipliers[0] + 5. / 3) < 1e-14);

  problem.rows.b[0] = -1;
  projected_gradient::Solver impossible(std::vector<double>{0, 0, 0}, problem);
  CHECK_FALSE(impossible.ask());
  CHECK(impossible.result().stop == OBC_PROJECTED_GRADIENT_INFEASIBLE);
  CHECK(impossible.certificate()[0] < 0);  // c'A x is at most 0 within the bounds, and c'b positive
  problem.lower.resize(2);
  CHECK_THROWS_AS(projected_gradient::Solver(x, problem), Error);
}

TEST_CASE("points on spheres with products of the Hessian") {
  const double stiffness[] = {3, 1, 2, 5};  // the minimum is 1
  const auto quotient = [&](Doubles x, View<double> gradient) {
    double value = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      gradient[k] = 2 * stiffness[k] * x[k];
      value += stiffness[k] * x[k] * x[k];
    }
    return value;
  };
  const auto product = [&](Doubles, Doubles direction, View<double> out) {
    for (std::size_t k = 0; k < 4; ++k)
      out[k] = 2 * stiffness[k] * direction[k];
  };
  const std::vector<double> start = {1, 1, 1, 1};
  std::vector<double> x = start, numbers(4);
  const sphere_optimizer::Result result = sphere_optimizer::minimize_second_order(quotient, product, x, 4);
  CHECK(std::abs(result.value - 1) < 1e-12);
  CHECK(result.products > 0);
  sphere_optimizer::Options options;
  options.method = OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON;
  options.hessian_products = 1;
  sphere_optimizer::Solver solver(start, 4, options);
  while (solver.ask()) {
    if (solver.direction().empty()) {
      const double value = quotient(solver.point(), numbers);
      solver.tell(value, numbers);
    } else {
      product(solver.point(), solver.direction(), numbers);
      solver.tell_product(numbers);
    }
  }
  CHECK(solver.best() == x);
  const auto broken = [](Doubles, Doubles, View<double>) { throw Mine("product"); };
  x = start;
  CHECK_THROWS_AS(sphere_optimizer::minimize_second_order(quotient, broken, x, 4), Mine);
}

TEST_CASE("points on spheres, all at once and block by block") {
  std::vector<double> x = {1, 0, 0, 0, 1, 0};
  CHECK(std::abs(sphere_optimizer::minimize(height, x, 3).value + 2) < 1e-12);
  sphere_optimizer::Solver solver(std::vector<double>{1, 0, 0, 0, 1, 0}, 3);
  std::vector<double> gradient(6);
  while (solver.ask()) {
    const double value = height(solver.point(), gradient);
    solver.tell(value, gradient);
    solver = sphere_optimizer::Solver::load(solver.save());
  }
  CHECK(solver.best() == x);
  std::vector<double> y = {1, 0, 0, 0, 1, 0};
  sphere_optimizer::Relaxation parts(y, 3, {{}, {}});
  const auto part = [](std::size_t, const double* place, const double*, double* slope, double*) {
    if (slope != nullptr) slope[0] = slope[1] = 0, slope[2] = 1;
    return place[2];
  };
  sphere_optimizer::relax(part, y, 3, {{}, {}});
  CHECK(std::abs(y[2] + 1) < 1e-9);
  CHECK(std::abs(y[5] + 1) < 1e-9);
  // In parts, broken off, saved and loaded: the same bits.
  const auto broken = [](std::size_t, const double*, const double*, double*, double*) -> double { throw 5; };
  CHECK(parts.run(part, 1).stop == OBC_SPHERE_OPTIMIZER_RUNNING);
  CHECK_THROWS_AS(parts.run(broken, 1), int);
  CHECK_THROWS_AS(sphere_optimizer::Relaxation::load(parts.save(), 3, {{1}, {0}}), Error);  // of others
  parts = sphere_optimizer::Relaxation::load(parts.save(), 3, {{}, {}});
  while (parts.run(part, 1).stop == OBC_SPHERE_OPTIMIZER_RUNNING) {
  }
  CHECK(parts.points() == y);
}

TEST_CASE("what a progress function throws comes out of the questions of a solver") {
  Host host;
  host.on_progress([](const Progress&) -> bool { throw Mine("progress"); });
  trust_region::Solver solver(std::array<double, 2>{-1.2, 1}, 0, {}, {}, &host);
  const auto run = [&] {
    while (solver.ask())
      solver.tell(std::pow(solver.point()[0], 2));
  };
  CHECK_THROWS_AS(run(), Mine);
}
