// Rotations found from directions.
#include "mesh/search/rotations.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

using namespace orbicube::mesh;

namespace {

constexpr double rounding_of_rotations = 1e-15;

Vector3 random_vector(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

double error(const Eigen::Matrix3d& rotation) {
  return (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() + std::abs(rotation.determinant() - 1);
}

}  // namespace

TEST_CASE("The rotation between two directions takes one to the other without twist") {
  std::mt19937_64 random(1);
  for (int run = 0; run < 200; ++run) {
    const Vector3 a = random_vector(random);
    // Also nearly the same and nearly opposite ones.
    Vector3 b = random_vector(random);
    if (run % 4 == 1) b = a + 1e-4 * b;
    if (run % 4 == 2) b = -a + 1e-4 * b;
    const Eigen::Quaterniond turn = rotation_between(a, b);
    // Near to opposite the axis is a difference of vectors 1e4 times as long.
    const double accuracy = run % 4 == 2 ? 1e-11 : 1e-14;
    CHECK(std::abs(turn.norm() - 1) < accuracy);
    CHECK((turn * a.normalized() - b.normalized()).norm() < accuracy);
    // Without twist: the axis is perpendicular to both.
    CHECK(std::abs(turn.vec().dot(a.normalized())) < accuracy);
    CHECK(std::abs(turn.vec().dot(b.normalized())) < accuracy);
  }
}

TEST_CASE("Between opposite directions there is half a turn") {
  std::mt19937_64 random(2);
  for (int run = 0; run < 20; ++run) {
    const Vector3 a = run < 3 ? Vector3(Vector3::Unit(run)) : random_vector(random);
    const Eigen::Quaterniond turn = rotation_between(a, -2 * a);
    CHECK(std::abs(turn.norm() - 1) < rounding_of_rotations);
    CHECK((turn * a + a).norm() < 10 * rounding_of_rotations * a.norm());
  }
}

TEST_CASE("The nearest rotation is found again, and none has a larger trace") {
  std::mt19937_64 random(3);
  for (int run = 0; run < 50; ++run) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(run, random_vector(random).normalized()).toRotationMatrix();
    const Vector3 stretch = random_vector(random).cwiseAbs();
    // R S with S symmetric and positive has R as its nearest.
    const Eigen::Matrix3d q = Eigen::AngleAxisd(2 * run, random_vector(random).normalized()).toRotationMatrix();
    const Eigen::Matrix3d symmetric = q * stretch.asDiagonal() * q.transpose();
    CHECK((nearest_rotation(turn * symmetric) - turn).norm() < 1e-9);

    Eigen::Matrix3d any;
    any << random_vector(random), random_vector(random), random_vector(random);  // half of them reflect
    const Eigen::Matrix3d nearest = nearest_rotation(any);
    CHECK(error(nearest) < 1e-13);
    const double most = (nearest.transpose() * any).trace();
    for (int k = 0; k < 50; ++k) {
      const Eigen::Matrix3d other = Eigen::AngleAxisd(0.1 * k, random_vector(random).normalized()) * nearest;
      CHECK((other.transpose() * any).trace() <= most + 1e-12);
    }
  }
}
