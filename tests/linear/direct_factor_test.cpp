// Factors against dense ones, for every engine that is part of the build.
#include "linear/direct/direct_factor.h"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>
#include <string>

#include "base/error.h"
#include "systems.h"
#ifdef ORBICUBE_WITH_CHOLMOD
#include "linear/direct/cholmod_factor.h"
#endif

using namespace orbicube;
using namespace orbicube::linear;

namespace {

std::vector<DirectMethod> methods() {
#ifdef ORBICUBE_WITH_CHOLMOD
  provide_cholmod(&make_cholmod_factor);
#endif
  if (!has_cholmod()) return {DirectMethod::eigen};
  return {DirectMethod::eigen, DirectMethod::cholmod_simplicial, DirectMethod::cholmod_supernodal};
}

struct Factored {
  test::Matrix given;
  SparseMatrix matrix;
  Eigen::MatrixXd dense;
  std::unique_ptr<DirectFactor> factor;

  Factored(const test::Matrix& m, DirectMethod method) : given(m), dense(m.dense()) {
    Array<int> place;
    matrix = by_columns(given.view(), place);
    factor = make_direct_factor(method);
    factor->analyze(matrix);
    REQUIRE(factor->factorize(matrix));
  }
  // Largest error of the solution for a random right side, of what the dense matrix has.
  double error() const {
    const std::vector<double> right = test::random_vector(given.size(), 5);
    std::vector<double> found(right.size());
    factor->solve(right, 1, found);
    const Eigen::Map<const Eigen::VectorXd> b(right.data(), dense.rows()), x(found.data(), dense.rows());
    return (dense.ldlt().solve(b) - x).norm() / x.norm();
  }
};

}  // namespace

TEST_CASE("Factors solve for several right sides, in place, too") {
  for (const DirectMethod method : methods()) {
    const Factored f(test::laplacian(5, 1, 0.1, 100), method);
    CHECK(f.error() < 1e-12);
    CHECK(f.factor->entries() > f.given.values.size() - f.given.size());
    const std::size_t size = f.given.size();
    std::vector<double> right = test::random_vector(3 * size, 2), found(right.size());
    f.factor->solve(right, 3, found);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(test::residual(f.given, std::span(right).subspan(c * size, size),
                           std::span(found).subspan(c * size, size)) < 1e-13);
    f.factor->solve(right, 3, right);
    CHECK(right == found);
  }
}

TEST_CASE("A removed row is one of the identity, and the rest is solved as a new factor does") {
  for (const DirectMethod method : methods()) {
    Factored f(test::laplacian(4, 1, 0.3, 50), method);
    for (const Index row : {17U, 0U, 63U, 40U, 41U}) {
      f.factor->remove_row(row);
      f.dense.row(row).setZero();
      f.dense.col(row).setZero();
      f.dense(row, row) = 1;
      CHECK(f.error() < 1e-12);
    }
  }
}

TEST_CASE("Updates and downdates follow matrices of rank one within the pattern") {
  for (const DirectMethod method : methods()) {
    Factored f(test::laplacian(4, 3, 0.3), method);
    const auto change = [&](const std::vector<Index>& rows, const std::vector<double>& values, int sign) {
      Eigen::VectorXd w = Eigen::VectorXd::Zero(f.dense.rows());
      for (std::size_t i = 0; i < rows.size(); ++i)
        w[rows[i]] = values[i];
      f.dense += sign * w * w.transpose();
      return f.factor->update(rows, values, sign);
    };
    CHECK(change({33, 34, 35}, {1, -2, 0.5}, 1));
    CHECK(f.error() < 1e-12);
    CHECK(change({90, 93}, {3, -3}, 1));
    CHECK(f.error() < 1e-12);
    CHECK(change({33, 34, 35}, {0.5, -1, 0.25}, -1));
    CHECK(f.error() < 1e-12);
    // What leaves the matrix indefinite is reported.
    CHECK_FALSE(change({12}, {100}, -1));
  }
}

TEST_CASE("A matrix that is not positive definite is reported, and other values are factorized again") {
  for (const DirectMethod method : methods()) {
    Factored f(test::laplacian(3, 1, 0.1), method);
    SparseMatrix other = f.matrix;
    other.valuePtr()[other.outerIndexPtr()[13]] = 0;
    const bool positive = f.factor->factorize(other);
    // Factors L D L' exist of some indefinite matrices.
    CHECK_FALSE((positive && f.factor->is_positive()));
    REQUIRE(f.factor->factorize(f.matrix));
    CHECK(f.factor->is_positive());
    CHECK(f.error() < 1e-12);
  }
}

TEST_CASE("Engines that are not part of the program are refused") {
  if (has_cholmod()) return;
  try {
    make_direct_factor(DirectMethod::cholmod_supernodal);
    CHECK(false);
  } catch (const base::Error& error) {
    CHECK(std::string(error.kind()) == "unsupported");
  }
}
