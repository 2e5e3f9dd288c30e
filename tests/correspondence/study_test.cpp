// Studies: the group's pose is the optimum, distances are those of the scores, and a subject that lies differently is
// carried to the same points.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/random.h"
#include "correspondence/closed_surface.h"
#include "correspondence/study/group_pose.h"
#include "correspondence/study/subject.h"
#include "mesh/shapes/make_shape.h"

using namespace orbicube;
using correspondence::Population;
using correspondence::Pose;

namespace {

Eigen::Matrix3d random_rotation(base::Random& random) {
  Eigen::Vector4d q;
  for (double& x : q)
    x = random.unit() - 0.5;
  return Eigen::Quaterniond(q.normalized()).toRotationMatrix();
}

// One cloud of points with noise, each copy moved, rotated and scaled.
Population clouds(Eigen::Index count, double noise, std::uint64_t seed) {
  constexpr Eigen::Index points = 50;
  base::Random random(seed);
  Eigen::Matrix3Xd cloud(3, points);
  for (double& x : cloud.reshaped())
    x = random.unit();
  Population result(count, 3 * points);
  for (Eigen::Index i = 0; i < count; ++i) {
    Eigen::Matrix3Xd x = cloud;
    for (double& c : x.reshaped())
      c += noise * (random.unit() - 0.5);
    x = (1 + random.unit()) * random_rotation(random) * x;
    x.colwise() += Eigen::Vector3d(random.unit(), 5 * random.unit(), random.unit());
    result.row(i) = x.reshaped().transpose();
  }
  return result;
}

double spread(const Population& shapes) {
  return (shapes.rowwise() - shapes.colwise().mean()).squaredNorm();
}

mesh::Mesh oriented_creature(std::uint64_t seed) {
  mesh::Mesh result = mesh::make_shape("creature", {.triangles = 400, .seed = seed}, base::Host());
  correspondence::orient_genus_zero(result, base::Host());
  return result;
}

}  // namespace

TEST_CASE("copies of one shape coincide after generalized Procrustes analysis, where the first one stood") {
  Population shapes = clouds(6, 0, 1);
  const Population given = shapes;
  const correspondence::GroupPose pose = correspondence::place_group(Pose::scaled, shapes, base::Host());
  CHECK(pose.converged);
  CHECK(spread(shapes) < 1e-20);
  const Eigen::Matrix3Xd first = given.row(0).reshaped(3, 50), mean = shapes.row(0).reshaped(3, 50);
  CHECK((first.rowwise().mean() - mean.rowwise().mean()).norm() < 1e-12);
  // The similarities take each shape to where it is.
  for (Eigen::Index i = 0; i < given.rows(); ++i) {
    const correspondence::Similarity& s = pose.moved[static_cast<std::size_t>(i)];
    const Eigen::Matrix3Xd moved = (s.scale * s.rotation * given.row(i).reshaped(3, 50)).colwise() + s.shift;
    CHECK((moved - shapes.row(i).reshaped(3, 50)).norm() < 1e-12);
  }
}

TEST_CASE("no rotation of one shape brings the group nearer to its mean") {
  Population shapes = clouds(5, 0.3, 2);
  CHECK(correspondence::place_group(Pose::turned, shapes, base::Host()).converged);
  base::Random random(3);
  for (Eigen::Index i = 0; i < shapes.rows(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
      for (const double angle : {-1e-4, 1e-4}) {
        Population other = shapes;
        Eigen::Matrix3Xd x = other.row(i).reshaped(3, 50);
        const Eigen::Vector3d middle = x.rowwise().mean();
        x = (Eigen::AngleAxisd(angle, axis).toRotationMatrix() * (x.colwise() - middle)).colwise() + middle;
        other.row(i) = x.reshaped().transpose();
        CHECK(spread(other) > spread(shapes));
      }
    }
  }
}

TEST_CASE("distances of shapes are those of their scores") {
  Population shapes = clouds(5, 0.3, 4);
  correspondence::place_group(Pose::turned, shapes, base::Host());
  const Eigen::MatrixXd distances = correspondence::distances_between(shapes, base::Host());
  const Eigen::MatrixXd scores = correspondence::principal_modes(shapes, base::Host()).scores;
  for (Eigen::Index i = 0; i < 5; ++i)
    for (Eigen::Index j = 0; j < 5; ++j)
      CHECK(distances(i, j) * std::sqrt(50.0) == doctest::Approx((scores.row(i) - scores.row(j)).norm()));
}

TEST_CASE("a group with nothing to align is refused") {
  Population shapes = clouds(3, 0.1, 5);
  shapes(1, 2) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(correspondence::place_group(Pose::turned, shapes, base::Host()), base::Error);
  shapes.row(1).setConstant(2);
  CHECK_THROWS_AS(correspondence::place_group(Pose::turned, shapes, base::Host()), base::Error);
  Population none(0, 3);
  CHECK_THROWS_AS(correspondence::place_group(Pose::turned, none, base::Host()), base::Error);
}

TEST_CASE("a subject that lies differently is carried to the same points, with any number of threads") {
  const correspondence::SubjectOptions options{.resolution = 3};
  const mesh::Mesh surface = oriented_creature(7);
  const correspondence::Subject first = correspondence::map_subject(surface, nullptr, options, base::Host());
  REQUIRE(first.functions);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  mesh::Mesh moved = surface;
  double size = 0;
  for (mesh::Vector3& p : moved.positions) {
    size = std::max(size, p.norm());
    p = rotation * p;
  }
  const correspondence::Subject second = correspondence::map_subject(moved, &*first.functions, options, base::Host());
  CHECK(second.flipped == 0);
  CHECK(second.correlation > 0.99);
  CHECK(second.turn == doctest::Approx(2 * 180 / 3.14159265).epsilon(0.01));
  double worst = 0;
  for (std::size_t v = 0; v < first.positions.size(); ++v)
    worst = std::max(worst, (rotation * first.positions[v] - second.positions[v]).norm());
  CHECK(worst < 0.1 * size);  // its own map to the sphere is another local minimum
  // A copy that does not move is carried to the same points but for rounding.
  const correspondence::Subject copy = correspondence::map_subject(surface, &*first.functions, options, base::Host());
  CHECK(copy.correlation == doctest::Approx(1));
  CHECK(copy.positions == first.positions);
  base::Host other;
  other.thread_count = 3;
  const correspondence::Subject again = correspondence::map_subject(moved, &*first.functions, options, other);
  CHECK(again.positions == second.positions);
}
