// Truncated Newton: steps against the solution of the subproblem, products that are supplied against differences, and
// what happens without them.
#include "base/error.h"
#include "base/sums.h"
#include "problems.h"
#include "sphere_optimizer/newton_step.h"

using namespace orbicube;
using namespace orbicube::test;
using orbicube::sphere_optimizer::NewtonStep;

namespace {

// The product of the Hessian of f and a direction, both in R^(N d).
using Product =
    std::function<void(std::span<const double> x, std::span<const double> direction, std::span<double> out)>;

Options second_order(double gradient_tolerance = 1e-8) {
  Options options = with(Method::truncated_newton, gradient_tolerance);
  options.hessian_products = 1;
  return options;
}

Run run_second_order(const Problem& problem, const Product& product, const Options& options = second_order()) {
  const base::Host host;
  Solver solver(problem.shape, options, problem.start, host);
  return drive_with_gradient<Run>(solver, problem.start.size(), problem.function, product);
}

// Of a quadratic form, whose gradient is linear.
Product quadratic_product(const Function& function) {
  return [function](std::span<const double>, std::span<const double> direction, std::span<double> out) {
    function(direction, out);
  };
}

// Of any function, by differences in R^(N d).
Product central_product(const Function& function) {
  return [function](std::span<const double> x, std::span<const double> direction, std::span<double> out) {
    double longest = 0;
    for (const double value : direction)
      longest = std::max(longest, std::abs(value));
    const double length = 1e-5 / longest;
    std::vector<double> at(x.size()), ahead(x.size());
    for (const double side : {-1.0, 1.0}) {
      for (std::size_t k = 0; k < x.size(); ++k)
        at[k] = x[k] + side * length * direction[k];
      function(at, side > 0 ? std::span<double>(ahead) : out);
    }
    for (std::size_t k = 0; k < x.size(); ++k)
      out[k] = (ahead[k] - out[k]) / (2 * length);
  };
}

}  // namespace

TEST_CASE("A step within the radius solves Newton's equation; a longer one ends at the radius and lowers the model") {
  // Tangent to one sphere at the last axis: the last entries of all vectors are 0.
  constexpr std::size_t n = 12;
  using Vector = std::vector<double>;
  const Vector random = normal_numbers(n * n, 3), scale{2.5};
  Vector gradient = normal_numbers(n + 1, 4);
  gradient[n] = 0;
  const auto dot = [](std::span<const double> a, std::span<const double> b) { return base::dot(a, b); };
  for (const double shift : {1.0, -6.0}) {  // H is positive definite, then indefinite
    const auto multiplied = [&](std::span<const double> v) {
      Vector inner(n, 0.0), product(n + 1, 0.0);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < n; ++k)
          inner[k] += random[i * n + k] * v[i];
      }
      for (std::size_t i = 0; i < n; ++i) {
        product[i] = shift * v[i];
        for (std::size_t k = 0; k < n; ++k)
          product[i] += random[i * n + k] * inner[k];
      }
      return product;
    };
    for (const double radius : {1e-3, 0.1, 100.0}) {
      NewtonStep step({1, n + 1}, true, std::pmr::get_default_resource());
      step.begin(gradient, scale, radius, 1e-10);
      while (!step.advance(multiplied(step.direction()), scale)) {
      }
      const Vector found(step.step().begin(), step.step().end()), product = multiplied(found);
      const double length = std::sqrt(scale[0] * dot(found, found));
      const double change = dot(gradient, found) + 0.5 * dot(found, product);
      CHECK(std::abs(step.change(gradient) - change) < 1e-12 * std::abs(change));
      CHECK(std::abs(step.length() - length) < 1e-9 * length);
      CHECK(length <= radius * (1 + 1e-12));
      // At least as low as the lowest point along the gradient within the radius.
      const double slope = std::sqrt(dot(gradient, gradient)), room = radius / std::sqrt(scale[0]);
      const double curvature = dot(gradient, multiplied(gradient)) / (slope * slope);
      const double along = curvature > 0 ? std::min(room, slope / curvature) : room;
      CHECK(change <= (-slope * along + 0.5 * curvature * along * along) * (1 - 1e-12));
      if (shift < 0) CHECK(step.at_boundary());
      if (shift > 0 && radius == 100.0) {
        CHECK(!step.at_boundary());
        for (std::size_t k = 0; k <= n; ++k)
          CHECK(std::abs(product[k] + gradient[k]) < 1e-9 * slope);
      }
    }
  }
}

TEST_CASE("With supplied products the energies are those without, in fewer evaluations") {
  const Problem cut = maximum_cut(10, 16, 5), line = laplacian(60, 1), charges = thomson(50, 1);
  const std::pair<const Problem*, Product> rows[] = {{&cut, quadratic_product(cut.function)},
                                                     {&line, quadratic_product(line.function)},
                                                     {&charges, central_product(charges.function)}};
  for (const auto& row : rows) {
    const Problem& problem = *row.first;
    const Run without = run(problem), end = run_second_order(problem, row.second, second_order(1e-10));
    CHECK(end.result.stop == Stop::converged);
    CHECK(stationarity(problem, end.x) < 1.1e-10);
    CHECK(std::abs(end.result.value - without.result.value) < 1e-9 * std::abs(without.result.value));
    CHECK(end.result.products > end.result.iterations);
    CHECK(end.result.evaluations == end.asked.size());
    CHECK(4 * end.result.evaluations < without.result.evaluations);
  }
}

TEST_CASE("Products from differences are those of the Hessian on the sphere") {
  // Both runs take the same steps as long as their products agree.
  const Problem problem = thomson(12, 2);
  Options options = second_order();
  options.max_iterations = 3;
  const Run supplied = run_second_order(problem, central_product(problem.function), options);
  options.hessian_products = 0;
  const Run differenced = run(problem, options);
  REQUIRE(supplied.x.size() == differenced.x.size());
  for (std::size_t k = 0; k < supplied.x.size(); ++k)
    CHECK(std::abs(supplied.x[k] - differenced.x[k]) < 1e-5);
  CHECK(supplied.result.products == differenced.result.products);
}

TEST_CASE("Saved while a product or a value is requested and loaded, a run goes on with the same bits") {
  const Problem problem = maximum_cut(3, 4, 1);
  const Product product = quadratic_product(problem.function);
  const Run whole = run_second_order(problem, product, second_order(1e-6));
  const base::Host host;
  Solver solver(problem.shape, second_order(1e-6), problem.start, host);
  std::vector<double> numbers(problem.shape.size());
  std::size_t products = 0;
  for (Request request; (request = solver.step()) != Request::done;) {
    if (request == Request::iteration) continue;
    const bool multiplies = request == Request::need_product;
    CHECK(solver.asks_product() == multiplies);
    for (const bool told : {false, true}) {
      if (told && multiplies) {
        product(solver.point(), solver.direction(), numbers);
        solver.tell_product(numbers);
        ++products;
      } else if (told) {
        const double value = problem.function(solver.point(), numbers);
        solver.tell(value, numbers);
      }
      std::vector<std::byte> blob(solver.save_size());
      solver.save(blob);
      Solver loaded(Solver::shape_of(blob), Solver::options_of(blob), {}, host);
      loaded.load(blob);
      const Run rest = drive_with_gradient<Run>(loaded, problem.start.size(), problem.function, product);
      CHECK(same_bits(rest.x, whole.x));
      CHECK(rest.result.products == whole.result.products);
    }
  }
  CHECK(products == whole.result.products);
}

TEST_CASE("Products that are missing or not finite shorten steps but not the run") {
  const Problem problem = maximum_cut(4, 5, 2);
  const Product right = quadratic_product(problem.function);
  const std::uint64_t count = run_second_order(problem, right).result.products;
  for (std::uint64_t bad = 0; bad < count; bad += 3) {
    std::uint64_t call = 0;
    const Run end = run_second_order(problem, [&](auto x, auto direction, auto out) {
      right(x, direction, out);
      if (call++ == bad) out[0] = std::nan("");
    });
    CAPTURE(bad);
    CHECK(end.result.stop == Stop::converged);
    CHECK(stationarity(problem, end.x) <= 1.01e-8);
  }
  // Without any, steps follow the gradient.
  Options options = second_order();
  options.max_evaluations = 2000;
  const Run end = run_second_order(
      problem, [](auto, auto, auto out) { std::fill(out.begin(), out.end(), std::nan("")); }, options);
  CHECK(stationarity(problem, end.x) < 1e-3);
}

TEST_CASE("Replies out of turn are refused") {
  const Problem problem = laplacian(5, 1);
  const base::Host host;
  std::vector<double> numbers(5);
  Solver solver(problem.shape, second_order(), problem.start, host);
  CHECK_THROWS_AS(solver.tell_product(numbers), base::Error);
  REQUIRE(solver.step() == Request::need_value_and_gradient);
  CHECK_THROWS_AS(solver.tell_product(numbers), base::Error);
  solver.tell(problem.function(solver.point(), numbers), numbers);
  REQUIRE(solver.step() == Request::iteration);
  REQUIRE(solver.step() == Request::need_product);
  REQUIRE(solver.step() == Request::need_product);
  CHECK_THROWS_AS(solver.tell(1, numbers), base::Error);
  CHECK_THROWS_AS(solver.tell_product(std::vector<double>(4)), base::Error);
  solver.tell_product_failure();
  CHECK_THROWS_AS(solver.tell_product_failure(), base::Error);
}
