// The C functions of linear: what they promise about arguments, memory and cancelling. What solutions are worth is
// tested in tests/linear/.
#include "orbicube/linear.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "../linear/path.h"
#include "promises.h"

using namespace orbicube;
using test::Path;

TEST_CASE("A factor solves, follows new values, and is released") {
  const Path path(50);
  const obc_linear_matrix matrix = path.view();
  obc_linear_direct* factor = nullptr;
  obc_error error;
  REQUIRE(obc_linear_direct_create(&matrix, nullptr, nullptr, &factor, &error) == OBC_OK);
  CHECK(obc_linear_direct_entry_count(factor) == 49);
  std::vector<double> right(50, 1.0), x(50);
  right[7] = -3;
  REQUIRE(obc_linear_direct_solve(factor, 1, right.data(), x.data(), &error) == OBC_OK);
  CHECK(path.residual(right, x) < 1e-13);
  std::vector<double> doubled = path.values, half(50);
  for (double& value : doubled)
    value *= 2;
  REQUIRE(obc_linear_direct_refactor(factor, doubled.data(), doubled.size(), &error) == OBC_OK);
  REQUIRE(obc_linear_direct_solve(factor, 1, right.data(), half.data(), &error) == OBC_OK);
  for (std::size_t i = 0; i < x.size(); ++i)
    CHECK(half[i] == doctest::Approx(x[i] / 2));
  REQUIRE(obc_linear_direct_refactor(factor, path.values.data(), path.values.size(), &error) == OBC_OK);
  REQUIRE(obc_linear_direct_remove_row(factor, 20, &error) == OBC_OK);
  REQUIRE(obc_linear_direct_solve(factor, 1, right.data(), x.data(), &error) == OBC_OK);
  CHECK(x[20] == right[20]);
  const std::uint32_t rows[] = {30, 31};
  const double w[] = {1, 2};
  REQUIRE(obc_linear_direct_update(factor, rows, w, 2, 1, &error) == OBC_OK);
  REQUIRE(obc_linear_direct_update(factor, rows, w, 2, -1, &error) == OBC_OK);
  std::vector<double> again(50);
  REQUIRE(obc_linear_direct_solve(factor, 1, right.data(), again.data(), &error) == OBC_OK);
  for (std::size_t i = 0; i < x.size(); ++i)
    CHECK(again[i] == doctest::Approx(x[i]).epsilon(1e-12));
  obc_linear_direct_destroy(factor);
  obc_linear_direct_destroy(nullptr);
  CHECK(obc_linear_direct_entry_count(nullptr) == 0);
}

TEST_CASE("A matrix that is not positive definite is no valid result, also after an update") {
  Path path(5);
  obc_linear_direct* factor = nullptr;
  obc_error error;
  obc_linear_matrix matrix = path.view();
  path.values[4] = -2;
  CHECK(obc_linear_direct_create(&matrix, nullptr, nullptr, &factor, &error) == OBC_NO_VALID_RESULT);
  CHECK(factor == nullptr);
  path.values[4] = 2.1;
  REQUIRE(obc_linear_direct_create(&matrix, nullptr, nullptr, &factor, &error) == OBC_OK);
  const std::uint32_t row = 3;
  const double large = 10;
  std::vector<double> x(5, 1.0);
  CHECK(obc_linear_direct_update(factor, &row, &large, 1, -1, &error) == OBC_NO_VALID_RESULT);
  CHECK(obc_linear_direct_solve(factor, 1, x.data(), x.data(), &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_linear_direct_refactor(factor, path.values.data(), path.values.size(), &error) == OBC_OK);
  CHECK(obc_linear_direct_solve(factor, 1, x.data(), x.data(), &error) == OBC_OK);
  obc_linear_direct_destroy(factor);
}

TEST_CASE("Conjugate gradients report what they reached") {
  const Path path(3000);
  const obc_linear_matrix matrix = path.view();
  obc_error error;
  for (const std::int32_t method : {OBC_LINEAR_ITERATIVE_AUTO, OBC_LINEAR_GAUSS_SEIDEL, OBC_LINEAR_MULTIGRID}) {
    for (const std::int32_t block : {1, 3}) {
      obc_linear_iterative_options options;
      REQUIRE(obc_linear_iterative_options_init(&options, sizeof options) == OBC_OK);
      options.method = method;
      options.block_size = block;
      options.tolerance = 1e-11;
      obc_linear_iterative* solver = nullptr;
      REQUIRE(obc_linear_iterative_create(&matrix, &options, nullptr, &solver, &error) == OBC_OK);
      std::vector<double> right(3000, 1.0), x(3000);
      obc_linear_iterative_report report;
      REQUIRE(obc_linear_iterative_report_init(&report, sizeof report) == OBC_OK);
      REQUIRE(obc_linear_iterative_solve(solver, right.data(), x.data(), &report, &error) == OBC_OK);
      CHECK(report.converged == 1);
      CHECK(report.residual <= 1e-11);
      CHECK(path.residual(right, x) < 1e-9);
      obc_linear_iterative_destroy(solver);
    }
  }
  obc_linear_iterative_destroy(nullptr);
}

TEST_CASE("Wrong arguments are refused with what is wrong") {
  Path path(4);
  obc_linear_matrix matrix = path.view();
  obc_linear_direct* factor = nullptr;
  obc_linear_iterative* solver = nullptr;
  obc_error error;
  const auto direct = [&] { return obc_linear_direct_create(&matrix, nullptr, nullptr, &factor, &error); };
  CHECK(obc_linear_direct_create(nullptr, nullptr, nullptr, &factor, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_linear_direct_create(&matrix, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  matrix.values = nullptr;
  CHECK(direct() == OBC_INVALID_ARGUMENT);
  matrix = path.view();
  path.columns[1] = 1;
  CHECK(direct() == OBC_INVALID_ARGUMENT);
  CHECK(std::string(error.message).find("row 1 of the matrix") == 0);
  path.columns[1] = 0;
  path.values[3] = std::numeric_limits<double>::infinity();
  CHECK(direct() == OBC_INVALID_ARGUMENT);
  path.values[3] = -1;
  obc_linear_direct_options direct_options;
  REQUIRE(obc_linear_direct_options_init(&direct_options, sizeof direct_options) == OBC_OK);
  direct_options.method = 9;
  CHECK(obc_linear_direct_create(&matrix, &direct_options, nullptr, &factor, &error) == OBC_INVALID_ARGUMENT);
  REQUIRE(direct() == OBC_OK);
  const std::uint32_t far[] = {0, 3}, twice[] = {1, 1}, outside[] = {4};
  const double w[] = {1, 1};
  double x[4] = {1, 1, 1, std::numeric_limits<double>::quiet_NaN()};
  CHECK(obc_linear_direct_update(factor, far, w, 2, 1, &error) == OBC_INVALID_ARGUMENT);
  CHECK(std::string(error.message).find("no entry for rows 0 and 3") != std::string::npos);
  CHECK(obc_linear_direct_update(factor, twice, w, 2, 1, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_linear_direct_update(factor, outside, w, 1, 1, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_linear_direct_update(factor, far, w, 1, 2, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_linear_direct_remove_row(factor, 4, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_linear_direct_solve(factor, 1, x, x, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_linear_direct_solve(factor, SIZE_MAX / 8, x, x, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_linear_direct_refactor(factor, x, 3, &error) == OBC_INVALID_ARGUMENT);
  obc_linear_direct_destroy(factor);

  obc_linear_iterative_options options;
  const auto iterative = [&] { return obc_linear_iterative_create(&matrix, &options, nullptr, &solver, &error); };
  REQUIRE(obc_linear_iterative_options_init(&options, sizeof options) == OBC_OK);
  options.block_size = 4;
  CHECK(iterative() == OBC_INVALID_ARGUMENT);
  options.block_size = 3;
  CHECK(iterative() == OBC_INVALID_ARGUMENT);
  options.block_size = 1;
  options.tolerance = 0;
  CHECK(iterative() == OBC_INVALID_ARGUMENT);
  options.tolerance = 1e-8;
  options.method = -1;
  CHECK(iterative() == OBC_INVALID_ARGUMENT);
  CHECK(solver == nullptr);
}

TEST_CASE("Allocations that fail and reports that cancel leave nothing behind") {
  const Path path(300);
  const obc_linear_matrix matrix = path.view();
  const std::vector<double> right(300, 1.0);
  std::vector<double> x(300);
  test::check_failing_allocations(test::destroying<obc_linear_direct>(
      obc_linear_direct_destroy, [&](const obc_host* host, obc_linear_direct** out) {
        obc_linear_direct_options options;
        obc_linear_direct_options_init(&options, sizeof options);
        options.method = OBC_LINEAR_EIGEN;
        const obc_status status = obc_linear_direct_create(&matrix, &options, host, out, nullptr);
        return status != OBC_OK ? status : obc_linear_direct_solve(*out, 1, right.data(), x.data(), nullptr);
      }));
  const auto iterate = [&](const obc_host* host, obc_linear_iterative** out) {
    obc_linear_iterative_options options;
    obc_linear_iterative_options_init(&options, sizeof options);
    options.method = OBC_LINEAR_MULTIGRID;
    const obc_status status = obc_linear_iterative_create(&matrix, &options, host, out, nullptr);
    return status != OBC_OK ? status : obc_linear_iterative_solve(*out, right.data(), x.data(), nullptr, nullptr);
  };
  test::check_failing_allocations(test::destroying<obc_linear_iterative>(obc_linear_iterative_destroy, iterate));
  // Reports come every 16384 rows.
  const Path large(60000);
  const obc_linear_matrix more = large.view();
  const std::vector<double> ones(60000, 1.0);
  std::vector<double> found(60000);
  test::check_cancelling(test::destroying<obc_linear_iterative>(
      obc_linear_iterative_destroy, [&](const obc_host* host, obc_linear_iterative** out) {
        const obc_status status = obc_linear_iterative_create(&more, nullptr, host, out, nullptr);
        return status != OBC_OK ? status
                                : obc_linear_iterative_solve(*out, ones.data(), found.data(), nullptr, nullptr);
      }));
}
