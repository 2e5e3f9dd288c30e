// Areas of vertices and the mean distance of point sets.
#include "harmonics/fitting/surface.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "samples.h"

using namespace orbicube;
using namespace orbicube::harmonics;

TEST_CASE("The areas of the vertices are thirds of their triangles") {
  const base::Host host;
  const std::vector<Vector3> positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {9, 9, 9}};
  const std::vector<Triangle> triangles = {{0, 2, 1}, {0, 1, 3}};
  const auto areas = vertex_areas(positions, triangles, host);
  const double expected[] = {(3 + 4) / 3.0, (3 + 4) / 3.0, 1, 4 / 3.0, 0};
  for (std::size_t v = 0; v < 5; ++v)
    CHECK(areas[v] == doctest::Approx(expected[v]).epsilon(1e-15));
  CHECK_THROWS_AS(vertex_areas(positions, std::vector<Triangle>{{0, 1, 5}}, host), base::Error);
}

TEST_CASE("The mean distance is that of a search through all points") {
  Samples samples(41);
  for (const std::size_t count : {1UL, 7UL, 300UL, 3000UL}) {
    std::vector<Vector3> a(count), b(count / 2 + 1);
    for (Vector3& p : a)
      p = Vector3(samples.normal(), samples.normal(), 0.01 * samples.normal());
    for (Vector3& p : b)
      p = samples.uniform() < 0.2 ? a[0] : Vector3(samples.normal(), 2 * samples.normal(), 0);
    const auto one_way = [](const std::vector<Vector3>& from, const std::vector<Vector3>& to) {
      double sum = 0;
      for (const Vector3& p : from) {
        double least = std::numeric_limits<double>::infinity();
        for (const Vector3& q : to)
          least = std::min(least, (p - q).norm());
        sum += least;
      }
      return sum / static_cast<double>(from.size());
    };
    base::Host one, three;
    one.thread_count = 1;
    three.thread_count = 3;
    const double found = mean_distance(a, b, one);
    CHECK(found == doctest::Approx(std::max(one_way(a, b), one_way(b, a))).epsilon(1e-13));
    CHECK(mean_distance(a, b, three) == found);
    CHECK(mean_distance(b, a, three) == found);
    CHECK(mean_distance(a, a, one) == 0);
  }
}

TEST_CASE("Sets without points, or with points that are not finite, are refused") {
  const base::Host host;
  const std::vector<Vector3> some = {{1, 2, 3}}, none, bad = {{1, 2, 3}, {std::nan(""), 0, 0}};
  CHECK_THROWS_AS(mean_distance(some, none, host), base::Error);
  CHECK_THROWS_AS(mean_distance(none, some, host), base::Error);
  CHECK_THROWS_WITH_AS(mean_distance(some, bad, host), "point 1 is not finite", base::Error);
}
