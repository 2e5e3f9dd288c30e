// Iterative solvers by the residual of the matrix itself.
#include "linear/iterative/iterative_solver.h"

#include <doctest/doctest.h>

#include <string>

#include "base/error.h"
#include "systems.h"

using namespace orbicube;
using namespace orbicube::linear;

TEST_CASE("Both methods reach the tolerance, for single unknowns and for blocks of two and three") {
  const base::Host host;
  for (const int block : {1, 2, 3}) {
    const test::Matrix matrix = test::laplacian(12, block, 1e-3, 10);
    const std::vector<double> right = test::random_vector(matrix.size(), 3);
    for (const IterativeMethod method : {IterativeMethod::gauss_seidel, IterativeMethod::multigrid}) {
      const auto solver = make_iterative_solver(matrix.view(), block, method, host);
      std::vector<double> solution(matrix.size());
      for (const double tolerance : {1e-3, 1e-8, 1e-12}) {
        const IterativeReport report = solver->solve(right, {tolerance, 1000}, solution);
        CHECK(report.converged);
        CHECK(report.residual <= tolerance);
        CHECK(test::residual(matrix, right, solution) == doctest::Approx(report.residual).epsilon(1e-3));
        CHECK(report.iterations > 0);
      }
    }
  }
}

TEST_CASE("The iterations of multigrid hardly grow with the system, those of Gauss-Seidel do") {
  const base::Host host;
  const auto iterations = [&](int n, IterativeMethod method) {
    const test::Matrix matrix = test::laplacian(n, 1, 1e-6);
    const std::vector<double> right = test::random_vector(matrix.size(), 3);
    std::vector<double> solution(matrix.size());
    return make_iterative_solver(matrix.view(), 1, method, host)->solve(right, {1e-8, 1000}, solution).iterations;
  };
  const int small = iterations(10, IterativeMethod::multigrid), large = iterations(40, IterativeMethod::multigrid);
  CHECK(large <= small + small / 2 + 2);
  CHECK(iterations(40, IterativeMethod::gauss_seidel) > 2 * large);
}

TEST_CASE("The end of the iterations is reported as it is") {
  const base::Host host;
  const test::Matrix matrix = test::laplacian(12, 1, 1e-3);
  const std::vector<double> right = test::random_vector(matrix.size(), 3);
  std::vector<double> solution(matrix.size());
  const auto solver = make_iterative_solver(matrix.view(), 1, IterativeMethod::gauss_seidel, host);
  const IterativeReport few = solver->solve(right, {1e-10, 3}, solution);
  CHECK_FALSE(few.converged);
  CHECK(few.iterations == 3);
  CHECK(few.residual == doctest::Approx(test::residual(matrix, right, solution)));
  // Rounding ends the iterations for a tolerance below its own size.
  const IterativeReport fine = solver->solve(right, {1e-18, 100000}, solution);
  CHECK_FALSE(fine.converged);
  CHECK(fine.iterations < 2000);
  CHECK(fine.residual < 1e-13);
  const IterativeReport none = solver->solve(std::vector<double>(matrix.size(), 0.0), {1e-8, 10}, solution);
  CHECK(none.converged);
  CHECK(none.residual == 0);
  CHECK(solution == std::vector<double>(matrix.size(), 0.0));
}

TEST_CASE("Matrices that are not rows of a lower triangle are refused with the row") {
  const auto refused = [](const std::vector<std::size_t>& row_begin, const std::vector<Index>& columns,
                          const std::vector<double>& values) {
    try {
      require_valid({row_begin, columns, values});
    } catch (const base::Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refused({0, 1, 3}, {0, 0, 1}, {2, 1, 3}).empty());
  CHECK(refused({0, 1, 3}, {0, 1, 0}, {2, 3, 1}).find("row 1 of the matrix: its last entry is not the diagonal") == 0);
  CHECK(refused({0, 1, 1}, {0}, {2}).find("row 1") == 0);
  CHECK(refused({0, 1, 9}, {0, 0, 1}, {2, 1, 3}).find("row 1") == 0);
  CHECK(refused({0, 1, 4}, {0, 0, 0, 1}, {2, 1, 1, 3}).find("row 1 of the matrix: its columns do not ascend") == 0);
  CHECK(refused({0, 1, 3}, {0, 0, 1}, {2, NAN, 3}).find("row 1 of the matrix: a value is not finite") == 0);
}

TEST_CASE("Right sides of any size are solved alike") {
  const base::Host host;
  const test::Matrix matrix = test::laplacian(8, 1, 0.1);
  const std::vector<double> right = test::random_vector(matrix.size(), 3);
  const auto solver = make_iterative_solver(matrix.view(), 1, IterativeMethod::gauss_seidel, host);
  std::vector<double> usual(matrix.size()), found(matrix.size());
  const IterativeReport expected = solver->solve(right, {1e-10, 1000}, usual);
  for (const int exponent : {-900, 900}) {
    std::vector<double> scaled(right);
    for (double& entry : scaled)
      entry = std::ldexp(entry, exponent);
    const IterativeReport report = solver->solve(scaled, {1e-10, 1000}, found);
    CHECK(report.iterations == expected.iterations);
    CHECK(report.residual == expected.residual);
    for (std::size_t i = 0; i < usual.size(); ++i)
      CHECK(std::ldexp(found[i], -exponent) == usual[i]);
  }
}
