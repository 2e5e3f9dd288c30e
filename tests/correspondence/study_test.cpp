// Studies: the group's pose is the optimum, distances are those of the scores, and a subject that lies differently is
// carried to the same points.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/random.h"
#include "correspondence/closed_surface.h"
#include "correspondence/statistics/group_test.h"
#include "correspondence/study/group_pose.h"
#include "correspondence/study/robust_placement.h"
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

namespace {

// Ellipsoids on one grid, moved and rotated at random, of which every second has its end z = 1 pulled out by 0.3.
struct GrownGroup {
  mesh::Mesh sphere = mesh::make_shape("sphere", {.triangles = 800}, base::Host());
  Population shapes;

  explicit GrownGroup(Eigen::Index count) : shapes(count, static_cast<Eigen::Index>(3 * sphere.positions.size())) {
    base::Random random(11);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Matrix3d rotation =
          i == 0 ? Eigen::Matrix3d::Identity()
                 : Eigen::AngleAxisd(0.2 * random.unit(), Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
      const Eigen::Vector3d shift(random.unit(), random.unit(), i == 0 ? 0 : random.unit());
      for (std::size_t v = 0; v < sphere.positions.size(); ++v) {
        const mesh::Vector3 p = sphere.positions[v].normalized();
        const double growth = i % 2 == 1 ? 0.3 * std::pow(std::max(0.0, p.z()), 4) : 0;
        const mesh::Vector3 point = (1 + growth) * mesh::Vector3(1.5 * p.x(), 1.2 * p.y(), p.z());
        shapes.row(i).segment<3>(static_cast<Eigen::Index>(3 * v)) = (rotation * point + shift).transpose();
      }
    }
  }

  // The largest distance between the first two shapes on the half that did not grow.
  double apart() const {
    double result = 0;
    for (std::size_t v = 0; v < sphere.positions.size(); ++v) {
      const auto at = static_cast<Eigen::Index>(3 * v);
      if (sphere.positions[v].z() < 0)
        result = std::max(result, (shapes.row(0).segment<3>(at) - shapes.row(1).segment<3>(at)).norm());
    }
    return result;
  }
};

}  // namespace

TEST_CASE("a local difference of half of the group hardly moves the rest of it with a robust placement") {
  GrownGroup group(20), squares(20);
  const Population given = group.shapes;
  const correspondence::GroupPose pose =
      correspondence::place_robustly(group.shapes, group.sphere.triangles, base::Host());
  CHECK(pose.converged);
  correspondence::place_group(Pose::turned, squares.shapes, base::Host());
  CHECK(squares.apart() > 0.02);  // least squares distribute the growth of 0.3
  CHECK(group.apart() < 0.1 * squares.apart());
  // The similarities take each shape to where it is.
  for (Eigen::Index i = 0; i < given.rows(); ++i) {
    const correspondence::Similarity& s = pose.moved[static_cast<std::size_t>(i)];
    const Eigen::Index points = given.cols() / 3;
    const Eigen::Matrix3Xd moved = (s.rotation * given.row(i).reshaped(3, points)).colwise() + s.shift;
    CHECK((moved - group.shapes.row(i).reshaped(3, points)).norm() < 1e-10);
  }
}

TEST_CASE("a robust placement has the same bits for any number of threads, and leaves copies where they are") {
  GrownGroup one(6), three(6);
  base::Host host;
  host.thread_count = 1;
  correspondence::place_robustly(one.shapes, one.sphere.triangles, host);
  host.thread_count = 3;
  correspondence::place_robustly(three.shapes, three.sphere.triangles, host);
  CHECK(one.shapes == three.shapes);
  Population copies = one.shapes;
  for (Eigen::Index i = 1; i < copies.rows(); ++i)
    copies.row(i) = copies.row(0);
  const Population before = copies;
  CHECK(correspondence::place_robustly(copies, one.sphere.triangles, base::Host()).converged);
  CHECK((copies - before).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("a test along directions has the T2 of one coordinate, and ignores shifts across them") {
  base::Random random(5);
  Population shapes(12, 6);
  for (double& x : shapes.reshaped())
    x = random.unit();
  std::vector<std::uint8_t> halves;
  for (Eigen::Index i = 0; i < 12; ++i) {
    halves.push_back(i < 6 ? 0 : 1);
    if (i >= 6) shapes.row(i).segment<3>(0) += Eigen::RowVector3d(0, 0, 5);
  }
  const std::vector<mesh::Vector3> across = {mesh::Vector3::UnitX(), mesh::Vector3::UnitY()};
  correspondence::GroupTestOptions options;
  options.directions = across;
  const correspondence::GroupTest test = correspondence::compare_groups(shapes, halves, options, base::Host());
  for (Eigen::Index v = 0; v < 2; ++v) {
    // Student's t of two samples of six, squared.
    const Eigen::VectorXd x = shapes.col(3 * v + v), a = x.head(6), b = x.tail(6);
    const double within = (a.array() - a.mean()).square().sum() + (b.array() - b.mean()).square().sum();
    const double t2 = 3 * std::pow(b.mean() - a.mean(), 2) / (within / 10);
    CHECK(test.t2[static_cast<std::size_t>(v)] == doctest::Approx(t2).epsilon(1e-9));
    CHECK(test.difference[static_cast<std::size_t>(4 * v)] == doctest::Approx(b.mean() - a.mean()));
  }
  CHECK(test.difference[2] == 0);
  CHECK(correspondence::compare_groups(shapes, halves, {}, base::Host()).t2[0] > 100);
  options.directions = std::span(across).first(1);
  CHECK_THROWS_AS(correspondence::compare_groups(shapes, halves, options, base::Host()), base::Error);
}
