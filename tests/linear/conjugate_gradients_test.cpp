#include "linear/iterative/conjugate_gradients.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "systems.h"

using namespace orbicube;

namespace {

Eigen::VectorXd noise(Eigen::Index size) {
  std::mt19937_64 random(5);
  Eigen::VectorXd x(size);
  for (double& entry : x)
    entry = static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5;
  return x;
}

// A dense system, preconditioned by its diagonal, that records its directions.
struct Plain {
  Eigen::MatrixXd a;
  Eigen::VectorXd b, x, r, z, d, image;
  std::vector<Eigen::VectorXd> directions;

  Plain(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) : a(matrix), b(right) {}

  void precondition() { z = r.cwiseQuotient(a.diagonal().cwiseAbs()); }
  double start() {
    x = Eigen::VectorXd::Zero(b.size());
    r = b;
    precondition();
    d = z;
    return r.dot(z);
  }
  double multiply() {
    directions.push_back(d);
    image = a * d;
    return d.dot(image);
  }
  double advance(double length) {
    x += length * d;
    r -= length * image;
    precondition();
    return r.dot(z);
  }
  void turn(double share) { d = z + share * d; }
};

// The same in the form for preconditioners that change.
struct Flexible : Plain {
  using Plain::Plain;
  double along() const { return d.dot(r); }
  double overlap() const { return z.dot(image); }
};

// Without a preconditioner.
struct Bare : Plain {
  using Plain::Plain;
  double start() {
    x = Eigen::VectorXd::Zero(b.size());
    d = r = b;
    return r.dot(r);
  }
  double advance(double length) {
    x += length * d;
    r -= length * image;
    z = r;
    return r.dot(r);
  }
};

}  // namespace

TEST_CASE("Directions are conjugate, and the solution is reached, in both forms") {
  const Eigen::MatrixXd a = linear::test::laplacian(4, 1, 0.1, 10).dense();
  const Eigen::VectorXd b = noise(a.rows());
  const auto check = [&](auto system) {
    const auto outcome = linear::conjugate_gradients(system, 500, 1e-12);
    CHECK(outcome.steps > 3);
    CHECK(outcome.steps < 100);
    CHECK(!outcome.not_positive);
    CHECK(outcome.end <= 1e-24 * outcome.start);
    CHECK((a * system.x - b).norm() < 1e-9 * b.norm());
    CHECK(system.directions.size() == static_cast<std::size_t>(outcome.steps));
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const auto &p = system.directions[i], &q = system.directions[k];
        CHECK(std::abs(p.dot(a * q)) < 1e-10 * std::sqrt(p.dot(a * p) * q.dot(a * q)));
      }
    }
  };
  check(Plain(a, b));
  check(Flexible(a, b));
}

TEST_CASE("As many steps as the matrix has different eigenvalues suffice") {
  Eigen::VectorXd eigenvalues(40);
  for (Eigen::Index i = 0; i < eigenvalues.size(); ++i)
    eigenvalues[i] = static_cast<double>(1 + i % 3);
  const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(Eigen::MatrixXd::Random(40, 40)).householderQ();
  Eigen::MatrixXd a = q * eigenvalues.asDiagonal() * q.transpose();
  Bare system(a, noise(40));
  CHECK(linear::conjugate_gradients(system, 100, 1e-10).steps == 3);
}

TEST_CASE("A run ends where the matrix is not positive, at overflow, at its limit, and at once for a zero right side") {
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(3, 3);
  Plain negative(-identity, noise(3));
  auto outcome = linear::conjugate_gradients(negative, 10, 1e-3);
  CHECK(outcome.not_positive);
  CHECK(outcome.steps == 0);
  CHECK(negative.x.isZero(0));

  const Eigen::VectorXd overflowing = Eigen::VectorXd::Constant(3, 1e100);
  Bare large(1e200 * identity, overflowing);
  CHECK(linear::conjugate_gradients(large, 10, 1e-3).not_positive);

  const Eigen::MatrixXd a = linear::test::laplacian(4, 1, 0.1, 10).dense();
  Plain limited(a, noise(a.rows()));
  outcome = linear::conjugate_gradients(limited, 2, 1e-12);
  CHECK(outcome.steps == 2);
  CHECK(!outcome.not_positive);

  Plain zero(a, 0 * noise(a.rows()));
  CHECK(linear::conjugate_gradients(zero, 10, 1e-3).steps == 0);
}
