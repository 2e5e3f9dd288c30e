// Maps that correspond: how a surface is numbered, how it lies, and a little noise hardly move them.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <random>
#include <string>

#include "mesh/files/read.h"
#include "shapes.h"
#include "sphere_map/correspondence/alignment.h"
#include "sphere_map/sphere_map.h"

using namespace orbicube;
using namespace orbicube::sphere_map;
using test::Surface;

namespace {

std::vector<Vector3> default_map_of(const Surface& s) {
  const Array<Vector3> map = compute(s.positions, s.triangles, Options(), base::Host());
  return {map.begin(), map.end()};
}

// Mean angle in degrees between two maps of a surface after the best rotation, weighted by area.
double angle_between(const Surface& s, const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  const Matrix3 rotation = best_rotation(b, a);
  double sum = 0, total = 0;
  for (const Triangle& t : s.triangles) {
    const Vector3 normal = (s.positions[t[1]] - s.positions[t[0]]).cross(s.positions[t[2]] - s.positions[t[0]]);
    for (const Index v : t)
      sum += normal.norm() * 2 * std::asin(std::min(1.0, 0.5 * (a[v] - rotation * b[v]).norm()));
    total += 3 * normal.norm();
  }
  return sum / total * 180 / std::numbers::pi;
}

struct Renumbered {
  Surface surface;
  std::vector<Index> place;  // of each vertex before
};

Renumbered renumbered(const Surface& original, std::mt19937_64& random) {
  Renumbered r{original, std::vector<Index>(original.positions.size())};
  std::iota(r.place.begin(), r.place.end(), Index{0});
  std::shuffle(r.place.begin(), r.place.end(), random);
  for (std::size_t v = 0; v < r.place.size(); ++v)
    r.surface.positions[r.place[v]] = original.positions[v];
  for (Triangle& t : r.surface.triangles)
    t = {r.place[t[1]], r.place[t[2]], r.place[t[0]]};
  std::shuffle(r.surface.triangles.begin(), r.surface.triangles.end(), random);
  return r;
}

void turn(Surface& s, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(w, x, y, z).normalized();
  for (Vector3& p : s.positions)
    p = rotation * p;
}

std::vector<Vector3> map_by_place(const Renumbered& r) {
  const std::vector<Vector3> map = default_map_of(r.surface);
  std::vector<Vector3> result;
  for (const Index place : r.place)
    result.push_back(map[place]);
  return result;
}

// The same on both sides of the plane y = 0.
Surface mirrored_creature(int levels) {
  Surface s = test::sphere(levels);
  for (Vector3& p : s.positions) {
    const Vector3 direction = p;
    double radius = 0.7 + 0.2 * direction.x();
    for (const Vector3& axis : {Vector3(1, 1, 0.4), Vector3(1, -1, 0.4), Vector3(-1, 0.7, -1), Vector3(-1, -0.7, -1)})
      radius += 2 * std::exp(-30 * (1 - axis.normalized().dot(direction)));
    p = radius * direction;
  }
  return s;
}

}  // namespace

TEST_CASE("A limbed surface that is renumbered and turned has the same map to a fifth of a degree") {
  std::mt19937_64 random(5);
  for (const Surface& original : {test::creature(4), mirrored_creature(4)}) {
    const std::vector<Vector3> map = default_map_of(original);
    for (int trial = 0; trial < 3; ++trial) {
      Renumbered r = renumbered(original, random);
      CHECK(angle_between(original, map, map_by_place(r)) < 0.2);
      turn(r.surface, random);
      CHECK(angle_between(original, map, map_by_place(r)) < 0.2);
    }
  }
}

TEST_CASE("Noise of a thousandth of the diagonal moves the map of a limbed surface by less than a degree") {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  const Surface original = test::creature(4);
  const std::vector<Vector3> map = default_map_of(original);
  for (int trial = 0; trial < 3; ++trial) {
    Surface noisy = original;
    for (Vector3& p : noisy.positions)
      p += 1e-3 * 5 * normal(random) * p.normalized();  // the diagonal is about 5
    CHECK(angle_between(original, map, default_map_of(noisy)) < 1);
  }
}

TEST_CASE("Animals have one map, whatever the order of decimation, and noise moves it by less than a degree") {
  const char* const models = std::getenv("ORBICUBE_MODELS");
  if (models == nullptr) {
    MESSAGE("skipped: ORBICUBE_MODELS is not set");
    return;
  }
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  for (const char* const name : {"cow.off", "dino.off"}) {
    const mesh::Mesh read = mesh::read_mesh(std::string(models) + "/dev/" + name, {}, base::Host());
    Surface original;
    original.positions.assign(read.positions.begin(), read.positions.end());
    original.triangles.assign(read.triangles.begin(), read.triangles.end());
    const std::vector<Vector3> map = default_map_of(original);
    for (std::uint64_t seed = 1; seed < 3; ++seed) {
      const Array<Vector3> other = compute(original.positions, original.triangles, {.seed = seed}, base::Host());
      CHECK(angle_between(original, map, {other.begin(), other.end()}) < 0.3);
    }
    Surface noisy = original;
    Vector3 low = noisy.positions[0], high = low;
    for (const Vector3& p : original.positions) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const double size = 1e-3 * (high - low).norm() / std::sqrt(3.0);
    for (Vector3& p : noisy.positions)
      p += size * Vector3(normal(random), normal(random), normal(random));
    CHECK(angle_between(original, map, default_map_of(noisy)) < 1);
  }
}
