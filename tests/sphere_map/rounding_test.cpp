// Maps that are stored with fewer bits than they were computed with.
#include "sphere_map/sampling/rounding.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "shapes.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sphere_map.h"

using namespace orbicube;
using namespace orbicube::sphere_map;

TEST_CASE("A map rounded to float32 holds floats and is a bijection by exact arithmetic") {
  const test::Surface s = test::creature(4);
  const auto map = compute(s.positions, s.triangles, {}, base::Host());
  const auto rounded = round_to_float(s.triangles, map, base::Host());
  CHECK(count_not_positive(s.triangles, rounded) == 0);
  for (std::size_t v = 0; v < map.size(); ++v) {
    for (int k = 0; k < 3; ++k)
      CHECK(std::remainder(std::ldexp(rounded[v][k], 24 - std::ilogb(rounded[v][k])), 2.0) == 0);  // 24 bits
    CHECK((rounded[v] - map[v]).norm() < 1e-3);
  }
}

TEST_CASE("Triangles that a coarse grid flips are repaired on the grid") {
  const test::Surface s = test::creature(4);
  const auto map = compute(s.positions, s.triangles, {}, base::Host());
  // Half of an edge: at 1 / 24, less than that, one triangle of this map stays.
  const double grid = 1.0 / 26;
  const Store coarse = [&](Index, const Vector3& d) -> Vector3 {
    return grid * Vector3(std::round(d.x() / grid), std::round(d.y() / grid), std::round(d.z() / grid));
  };
  std::vector<Vector3> only_rounded;
  for (Index v = 0; v < map.size(); ++v)
    only_rounded.push_back(coarse(v, map[v]));
  REQUIRE(count_not_positive(s.triangles, only_rounded) > 0);  // or there would be nothing to repair
  const RoundedMap repaired = round_and_repair(s.triangles, map, coarse, 0, base::Host());
  CHECK(repaired.not_positive == 0);
  CHECK(repaired.moved > 0);
  CHECK(count_not_positive(s.triangles, repaired.directions) == 0);
  for (Index v = 0; v < map.size(); ++v)
    CHECK(repaired.directions[v] == coarse(v, repaired.directions[v]));
}

TEST_CASE("Slack leaves room: every vertex may move by it and no triangle flips") {
  const test::Surface s = test::creature(3);
  const auto map = compute(s.positions, s.triangles, {}, base::Host());
  const double slack = 1e-4;
  const RoundedMap stored = round_and_repair(
      s.triangles, map, [](Index, const Vector3& d) { return d; }, slack, base::Host());
  REQUIRE(stored.not_positive == 0);
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Vector3> shaken(stored.directions.begin(), stored.directions.end());
    for (Vector3& p : shaken) {
      p += slack * Vector3(uniform(random), uniform(random), uniform(random)).normalized();
    }
    REQUIRE(count_not_positive(s.triangles, shaken) == 0);
  }
}

TEST_CASE("A map that a grid cannot hold is refused, and one that is mirrored stays so") {
  const test::Surface s = test::creature(4);
  const auto map = compute(s.positions, s.triangles, {}, base::Host());
  const RoundedMap hopeless = round_and_repair(
      s.triangles, map, [](Index, const Vector3& d) -> Vector3 { return d.array().round().matrix(); }, 0, base::Host());
  CHECK(hopeless.not_positive > 0);

  test::Surface inward = s;
  for (Triangle& t : inward.triangles)
    std::swap(t[1], t[2]);
  const auto mirrored = compute(inward.positions, inward.triangles, {}, base::Host());
  const auto rounded = round_to_float(inward.triangles, mirrored, base::Host());
  CHECK(count_not_positive(s.triangles, rounded) == 0);

  // Two vertices at distance 1e-12 on the sphere are one in float32.
  std::vector<Vector3> collapsed(map.begin(), map.end());
  const Triangle& t = s.triangles[0];
  collapsed[t[1]] = (map[t[0]] + 1e-12 * (map[t[1]] - map[t[0]])).normalized();
  CHECK_NOTHROW(round_to_float(s.triangles, map, base::Host()));
}
