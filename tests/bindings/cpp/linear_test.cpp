// The C++ wrappers of linear: factors and iterations of a sparse symmetric matrix.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include <orbicube/linear.hpp>

#include "../../linear/path.h"

using namespace orbicube;

namespace {

struct Mine : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using test::Path;

}  // namespace

TEST_CASE("a factor of a sparse symmetric matrix solves, follows changes, and says what it cannot do") {
  Path path(200);
  linear::Direct factor(path.view());
  CHECK(factor.entry_count() == 199);
  std::vector<double> b(200);
  for (std::size_t i = 0; i < b.size(); ++i)
    b[i] = std::sin(3.0 * double(i));
  const std::vector<double> x = factor.solve(b);
  CHECK(path.residual(b, x) < 1e-13);
  std::vector<double> both = b;
  both.insert(both.end(), b.begin(), b.end());
  const std::vector<double> twice = factor.solve(both);
  CHECK(std::equal(x.begin(), x.end(), twice.begin()));
  CHECK(std::equal(x.begin(), x.end(), twice.begin() + 200));

  factor.remove_row(80);
  CHECK(factor.solve(b)[80] == b[80]);
  factor.refactor(path.values);
  factor.update({20, 21}, {3, -2});
  Path updated = path;
  updated.values[updated.row_begin[21] - 1] += 9;
  updated.values[updated.row_begin[22] - 2] -= 6;
  updated.values[updated.row_begin[22] - 1] += 4;
  CHECK(updated.residual(b, factor.solve(b)) < 1e-12);
  factor.update({20, 21}, {3, -2}, -1);
  CHECK(path.residual(b, factor.solve(b)) < 1e-12);

  linear::Direct moved = std::move(factor);
  CHECK(path.residual(b, moved.solve(b)) < 1e-12);
  CHECK_THROWS_AS(moved.solve(std::vector<double>(199)), std::invalid_argument);
  CHECK_THROWS_AS(moved.update({0}, {1, 2}), std::invalid_argument);
  CHECK_THROWS_AS(moved.update({0, 199}, {1, 1}), Error);
  CHECK_THROWS_AS(moved.remove_row(200), Error);
  CHECK_THROWS_AS(moved.update({0}, {100}, -1), Error);
  CHECK_THROWS_AS(moved.solve(b), Error);
  path.values[path.row_begin[7] - 1] = -2;
  try {
    linear::Direct(path.view());
    FAIL("a matrix that is not positive definite was factorized");
  } catch (const Error& error) {
    CHECK(error.status() == OBC_NO_VALID_RESULT);
  }
}

TEST_CASE("iterations for a sparse symmetric matrix report what they reached, and pass exceptions of progress on") {
  const Path path(30000);
  const std::vector<double> b(30000, 1.0);
  for (const std::int32_t method : {OBC_LINEAR_GAUSS_SEIDEL, OBC_LINEAR_MULTIGRID}) {
    linear::IterativeOptions options;
    options.method = method;
    options.block_size = 3;
    options.tolerance = 1e-11;
    linear::IterativeReport report;
    linear::Iterative solver(path.view(), options);
    CHECK(path.residual(b, solver.solve(b, &report)) < 1e-8);
    CHECK(report.converged == 1);
    CHECK(report.residual <= 1e-11);
    CHECK_THROWS_AS(solver.solve(std::vector<double>(3)), std::invalid_argument);
  }
  Host host;
  bool fails = false;
  int told = 0;
  host.on_progress([&](const Progress&) {
    ++told;
    if (fails) throw Mine("progress");
    return true;
  });
  linear::Iterative solver(path.view(), {}, &host);
  const std::vector<double> x = solver.solve(b);
  CHECK(told > 0);
  fails = true;
  // Reports are at most one in 20 ms, longer than a solution may take.
  const auto solve_on = [&] {
    for (;;)
      solver.solve(b);
  };
  CHECK_THROWS_AS(solve_on(), Mine);
  fails = false;
  CHECK(solver.solve(b) == x);
}
