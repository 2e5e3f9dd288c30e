// Rotations and warps between the spheres of two shapes.
#include "sphere_map/correspondence/alignment.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <vector>

#include "base/error.h"
#include "sphere_map/correspondence/correspondence.h"
#include "sphere_map/correspondence/landmark_flow.h"
#include "uneven_maps.h"

using namespace orbicube;
using mesh::Vector3;
using sphere_map::Alignment;
using sphere_map::Matrix3;
using sphere_map::SphereWarp;

namespace {

std::vector<Vector3> random_directions(std::size_t count, std::uint64_t seed, double apart) {
  std::mt19937_64 random(seed);
  std::vector<Vector3> result;
  while (result.size() < count) {
    const Vector3 d = test::random_direction(random);
    const bool far =
        std::all_of(result.begin(), result.end(), [&](const Vector3& e) { return (d - e).norm() > apart; });
    if (far) result.push_back(d);
  }
  return result;
}

// Each moved by up to `most`, in a direction of its own.
std::vector<Vector3> moved(const std::vector<Vector3>& directions, double most, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vector3> result;
  for (const Vector3& d : directions)
    result.push_back((d + most * d.cross(test::random_direction(random))).normalized());
  return result;
}

std::string kind_of(const std::vector<Vector3>& from, const std::vector<Vector3>& to) {
  try {
    const SphereWarp warp(from, to, base::Host());
  } catch (const base::Error& e) {
    return e.kind();
  }
  return "";
}

}  // namespace

TEST_CASE("The best rotation is found back, is the best of noisy pairs, and turns little where pairs leave it open") {
  const auto from = random_directions(7, 1, 0.1);
  const Matrix3 truth = Eigen::AngleAxisd(2.3, Vector3(1, -2, 0.5).normalized()).toRotationMatrix();
  std::vector<Vector3> to;
  for (const Vector3& d : from)
    to.push_back(3.5 * (truth * d));  // lengths do not matter
  CHECK((sphere_map::best_rotation(from, to) - truth).norm() < 1e-14);

  const auto noisy = moved(to, 0.3, 5);
  const Matrix3 best = sphere_map::best_rotation(from, noisy);
  const auto cost = [&](const Matrix3& r) {
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
      sum += (r * from[i] - noisy[i]).squaredNorm();
    return sum;
  };
  CHECK((best * best.transpose() - Matrix3::Identity()).norm() < 1e-14);
  CHECK(best.determinant() == doctest::Approx(1));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double angle : {-0.01, 0.01})
      CHECK(cost(Eigen::AngleAxisd(angle, Vector3::Unit(axis)).toRotationMatrix() * best) > cost(best));
  }
  // One pair: the shortest way.
  const Matrix3 one = sphere_map::best_rotation(std::vector<Vector3>{{0, 0, 1}}, std::vector<Vector3>{{1, 0, 1}});
  CHECK((one - Eigen::AngleAxisd(M_PI / 4, Vector3::UnitY()).toRotationMatrix()).norm() < 1e-6);
  CHECK_THROWS_AS(sphere_map::best_rotation({}, {}), base::Error);
  CHECK_THROWS_AS(Alignment(2 * Matrix3::Identity()), base::Error);
  CHECK_THROWS_AS(Alignment(Matrix3(-Matrix3::Identity())), base::Error);
  CHECK_THROWS_AS(Alignment(Matrix3(Matrix3::Constant(NAN))), base::Error);
}

TEST_CASE("A warp carries landmarks onto landmarks, is a bijection, and its inverse is its inverse") {
  struct Landmarks {
    std::size_t count;
    double apart, distance;
  };
  for (const Landmarks& landmarks : {Landmarks{1, 0.1, 1.2}, {4, 0.8, 0.6}, {12, 0.4, 0.35}, {40, 0.15, 0.1}}) {
    CAPTURE(landmarks.count);
    const auto from = random_directions(landmarks.count, 11, landmarks.apart);
    const auto to = moved(from, landmarks.distance, 12);
    const SphereWarp warp(from, to, base::Host());
    for (std::size_t i = 0; i < from.size(); ++i) {
      CHECK((warp.forward(from[i]) - to[i]).norm() < 4e-16);
      CHECK((warp.backward(to[i]) - from[i]).norm() < 4e-16);
    }
    CHECK(sphere_map::count_not_positive(warp.triangles(), warp.moved()) == 0);
    const sphere_map::Measurement m = warp.distortion(base::Host());
    CHECK(m.bijective);
    std::mt19937_64 random(3);
    for (int i = 0; i < 500; ++i) {
      const Vector3 d = test::random_direction(random);
      const Vector3 there = warp.forward(d);
      CHECK(there.norm() == doctest::Approx(1).epsilon(1e-15));
      // Roundings, times how much the warp shrinks areas and so stretches errors on the way back.
      CHECK((warp.backward(there) - d).norm() < 1e-13 * m.max_quasi_conformal / std::sqrt(m.min_area_ratio));
    }
  }
}

TEST_CASE("A warp without anything to move is the identity, and near to nothing it is smooth") {
  const auto from = random_directions(6, 2, 0.3);
  const SphereWarp still(from, from, base::Host());
  const SphereWarp little(from, moved(from, 0.01, 3), base::Host());
  std::mt19937_64 random(4);
  for (int i = 0; i < 200; ++i) {
    const Vector3 d = test::random_direction(random);
    CHECK((still.forward(d) - d).norm() < 1e-14);
    CHECK((little.forward(d) - d).norm() < 0.03);
  }
  CHECK(little.distortion(base::Host()).max_quasi_conformal < 1.2);
}

TEST_CASE("The flow moves its landmarks to where they should be, with an error of the fourth order at most") {
  const auto from = random_directions(5, 21, 0.6);
  const auto to = moved(from, 0.5, 22);
  const sphere_map::LandmarkFlow flow(from, to, base::Host());
  std::vector<Vector3> points = from;
  flow.move(points, base::Host());
  for (std::size_t i = 0; i < from.size(); ++i)
    CHECK((points[i] - to[i]).norm() < 1e-5);
}

TEST_CASE("A warp is the same bits on any number of threads") {
  const auto from = random_directions(8, 31, 0.4);
  const auto to = moved(from, 0.3, 32);
  base::Host one, four;
  one.thread_count = 1;
  four.thread_count = 4;
  const SphereWarp a(from, to, one), b(from, to, four);
  REQUIRE(a.moved().size() == b.moved().size());
  CHECK(std::memcmp(a.moved().data(), b.moved().data(), a.moved().size_bytes()) == 0);
}

TEST_CASE("Landmarks that cannot be, are refused") {
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
  CHECK(kind_of({}, {}) == "invalid-argument");
  CHECK(kind_of({x}, {x, y}) == "invalid-argument");
  CHECK(kind_of({x, Vector3::Zero()}, {x, y}) == "invalid-argument");
  CHECK(kind_of({x, y}, {x, Vector3(0, NAN, 0)}) == "invalid-argument");
  CHECK(kind_of({x, x + 0.001 * y}, {x, y}) == "invalid-argument");
  CHECK(kind_of({x, y}, {z, z}) == "invalid-argument");
  // They change places on one great circle, and meet in the middle.
  CHECK(kind_of({x, y}, {y, x}) == "no-valid-result");
}

TEST_CASE("A shape that is carried over by a rotation and a warp is itself at its own vertices") {
  const test::MappedShape shape = test::mapped("creature", 3000);
  const auto& triangles = shape.surface.triangles;
  const sphere_map::Locator locator(triangles, shape.directions, base::Host());
  Alignment alignment(Eigen::AngleAxisd(0.7, Vector3(1, 1, 0).normalized()).toRotationMatrix());
  const auto from = random_directions(6, 41, 0.5);
  std::vector<Vector3> rotated;
  for (const Vector3& d : from)
    rotated.push_back(alignment.rotation() * d);
  const auto to = moved(rotated, 0.3, 42);
  alignment.add_warp(from, to, base::Host());
  for (std::size_t i = 0; i < from.size(); ++i)
    CHECK((alignment.to_common(from[i]) - to[i]).norm() < 1e-14);

  const auto placed = sphere_map::place(shape.directions, alignment, base::Host());
  const auto carried =
      sphere_map::carry_over(locator, shape.surface.positions, alignment, placed, triangles, {}, base::Host());
  CHECK(carried.flipped == 0);
  for (std::size_t v = 0; v < placed.size(); ++v)
    CHECK((carried.positions[v] - shape.surface.positions[v]).norm() < 1e-8);

  // Nothing turned, nothing changed.
  const auto same = sphere_map::place(shape.directions, Alignment(), base::Host());
  CHECK(std::equal(same.begin(), same.end(), shape.directions.begin()));
}
