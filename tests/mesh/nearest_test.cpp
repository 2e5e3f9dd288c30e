// Searches against looking at everything.
#include "mesh/search/nearest.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>
#include <random>
#include <vector>

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

struct Random {
  std::mt19937_64 engine{31};
  double number() { return std::uniform_real_distribution<double>(-1, 1)(engine); }
  Vector3 point() { return Vector3(number(), number(), number()); }
  // Of a coarse grid, so that many are equally near.
  Vector3 grid_point() {
    const auto coordinate = [&] { return static_cast<double>(engine() % 5); };
    return {coordinate(), coordinate(), coordinate()};
  }
};

}  // namespace

TEST_CASE("The nearest vertex and those within a radius are those found by looking at all, the lowest of equals") {
  Random random;
  for (const bool on_grid : {false, true}) {
    const auto point = [&] { return on_grid ? random.grid_point() : random.point(); };
    for (const std::size_t count : std::initializer_list<std::size_t>{0, 1, 3, 5, 700}) {
      std::vector<Vector3> positions;
      for (std::size_t i = 0; i < count; ++i)
        positions.push_back(point());
      const VertexSearch search(positions, base::Host());
      for (int trial = 0; trial < 200; ++trial) {
        const Vector3 p = 1.5 * point();
        Index expected = no_index;
        std::vector<Index> within, found;
        for (Index v = 0; v < count; ++v) {
          const double d = (positions[v] - p).squaredNorm();
          if (expected == no_index || d < (positions[expected] - p).squaredNorm()) expected = v;
          if (d <= 0.25) within.push_back(v);
        }
        REQUIRE(search.nearest(p) == expected);
        search.for_each_within(p, 0.5, [&](Index v) { found.push_back(v); });
        std::sort(found.begin(), found.end());
        REQUIRE(found == within);
      }
    }
  }
}

TEST_CASE("The nearest point of a triangle is in it, and no other point of it is nearer") {
  Random random;
  for (int trial = 0; trial < 3000; ++trial) {
    const Vector3 a = random.point(), b = random.point(), p = 2 * random.point();
    Vector3 c = random.point();
    if (trial % 5 == 0) c = a + random.number() * (b - a);  // flat but for rounding
    if (trial % 5 == 1) c = b;
    const TrianglePoint found = nearest_on_triangle(p, a, b, c);
    REQUIRE(found.weights.minCoeff() >= 0);
    REQUIRE(found.weights.sum() == doctest::Approx(1).epsilon(1e-14));
    // Some roundings of numbers of size 1.
    REQUIRE((found.weights[0] * a + found.weights[1] * b + found.weights[2] * c - found.position).norm() < 1e-14);
    const double distance = (found.position - p).norm();
    for (int i = 0; i < 30; ++i) {
      Vector3 w = Vector3::Random().cwiseAbs();
      if (i % 3 == 0) w[i % 9 / 3] = 0;
      w /= w.sum();
      // A triangle that is flat but for rounding has its weights from a normal of few correct bits.
      REQUIRE((w[0] * a + w[1] * b + w[2] * c - p).norm() >= distance - (trial % 5 == 0 ? 1e-7 : 1e-14));
    }
  }
}

TEST_CASE("The nearest point of a surface is that of its nearest triangle") {
  Random random;
  std::vector<Vector3> positions;
  std::vector<Triangle> triangles;
  for (Index t = 0; t < 400; ++t) {
    const Vector3 at = random.point();
    for (int k = 0; k < 3; ++k)
      positions.push_back(at + 0.1 * random.point());
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const SurfaceSearch search(positions, triangles, base::Host());
  for (int trial = 0; trial < 300; ++trial) {
    const Vector3 p = 1.5 * random.point();
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& t : triangles) {
      const TrianglePoint on = nearest_on_triangle(p, positions[t[0]], positions[t[1]], positions[t[2]]);
      least = std::min(least, (on.position - p).norm());
    }
    const SurfacePoint found = search.nearest(p);
    REQUIRE(found.distance == doctest::Approx(least).epsilon(1e-14));
    REQUIRE((found.position - p).norm() == doctest::Approx(least).epsilon(1e-14));
    // From any triangle to begin with.
    for (const Index start : {found.triangle, static_cast<Index>(trial)}) {
      const SurfacePoint again = search.nearest(p, start);
      REQUIRE(again.triangle == found.triangle);
      REQUIRE(again.position == found.position);
      REQUIRE(search.distance(start, p) >= found.distance);
    }
  }
  CHECK(SurfaceSearch(positions, {}, base::Host()).nearest(Vector3::Zero()).triangle == no_index);
  // Of some triangles, and of none.
  for (int trial = 0; trial < 300; ++trial) {
    const Vector3 p = 1.5 * random.point();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t t = 1; t < triangles.size(); t += 3) {
      const Triangle& c = triangles[t];
      least = std::min(least,
                       (nearest_on_triangle(p, positions[c[0]], positions[c[1]], positions[c[2]]).position - p).norm());
    }
    const SurfacePoint found = search.nearest_of(p, [](Index t) { return t % 3 == 1; });
    REQUIRE(found.triangle % 3 == 1);
    REQUIRE(found.distance == doctest::Approx(least).epsilon(1e-14));
    REQUIRE((found.position - p).norm() == doctest::Approx(least).epsilon(1e-14));
  }
  CHECK(search.nearest_of(Vector3::Zero(), [](Index) { return false; }).triangle == no_index);
}
