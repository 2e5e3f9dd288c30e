// Surfaces with triangles without area, or nearly, and with vertices in no triangle.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/host.h"
#include "shapes.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sphere_map.h"

using namespace orbicube;
using namespace orbicube::sphere_map;

namespace {

// The unit cube with a vertex on the edge from 0 to 1. One of the two triangles there has it as a corner, and the other
// is whole: between them is a triangle of the given height; 0: none has area.
test::Surface cube_with_sliver(double height) {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, height, 0}},
          {{0, 2, 8},
           {8, 2, 1},
           {0, 3, 2},
           {0, 8, 1},
           {0, 1, 5},
           {0, 5, 4},
           {1, 2, 6},
           {1, 6, 5},
           {2, 3, 7},
           {2, 7, 6},
           {3, 0, 4},
           {3, 4, 7},
           {4, 5, 6},
           {4, 6, 7}}};
}

// The same without the triangle in between.
test::Surface cube_split() {
  test::Surface s = cube_with_sliver(0);
  s.triangles[3] = {0, 8, 5};
  s.triangles[4] = {8, 1, 5};
  return s;
}

Measurement mapped(const test::Surface& s, Method method = Method::balanced) {
  const base::Host host;
  const auto directions = compute(s.positions, s.triangles, {.method = method}, host);
  return measure(s.positions, s.triangles, directions, 0.1, 1, host);
}

// Splits one of the two triangles at the edge from a to b alone, by a vertex off the edge by a part of the third
// corner's distance.
void add_sliver(test::Surface& s, std::size_t triangle, double share, double height) {
  const auto [a, b, c] = s.triangles[triangle];
  const auto m = static_cast<Index>(s.positions.size());
  const Vector3 at = (1 - share) * s.positions[a] + share * s.positions[b];
  s.positions.push_back(at + height * (s.positions[c] - at));
  s.triangles[triangle] = {a, m, c};
  s.triangles.push_back({m, b, c});
  s.triangles.push_back({a, b, m});
}

}  // namespace

TEST_CASE("A triangle without area, or nearly, leaves the map of the others as it is without it") {
  const Measurement without = mapped(cube_split());
  CHECK(without.zero_area_faces == 0);
  for (const double height : {1e-6, 1e-5, 1e-4}) {
    // Slivers that figures keep: what is beside them is still mapped well.
    CAPTURE(height);
    const Measurement with = mapped(cube_with_sliver(height));
    CHECK(with.bijective);
    CHECK(with.mean_quasi_conformal < 1.1 * without.mean_quasi_conformal);
    CHECK(with.stretch_efficiency > 0.9 * without.stretch_efficiency);
  }
  for (const double height : {0.0, 1e-16, 1e-12, 1e-9, 1e-7}) {
    CAPTURE(height);
    const Measurement with = mapped(cube_with_sliver(height));
    CHECK(with.bijective);
    CHECK(with.zero_area_faces == 1);
    // The cube has an edge fewer there, which changes the map a little.
    CHECK(with.energy < 1.05 * without.energy);
    CHECK(with.mean_quasi_conformal < 1.05 * without.mean_quasi_conformal);
    CHECK(with.max_quasi_conformal < 1.5 * without.max_quasi_conformal);
    CHECK(with.stretch_efficiency > 0.9 * without.stretch_efficiency);
  }
}

TEST_CASE("One sliver of many triangles does not raise the mean quasi-conformal distortion, with any method") {
  const test::Surface plain = test::sphere(3);
  for (const Method method : {Method::balanced, Method::angle_area, Method::stretch, Method::isometric,
                              Method::conformal, Method::dissertation}) {
    const Measurement before = mapped(plain, method);
    for (const double height : {0.0, 1e-14, 1e-8}) {
      CAPTURE(static_cast<int>(method));
      CAPTURE(height);
      test::Surface s = plain;
      add_sliver(s, 17, 0.4, height);
      const Measurement m = mapped(s, method);
      CHECK(m.bijective);
      CHECK(m.zero_area_faces == 1);
      CHECK(m.mean_quasi_conformal < before.mean_quasi_conformal + 0.02);
      CHECK(m.energy < 1.02 * before.energy);
    }
  }
}

TEST_CASE("A surface of which a third of the triangles has no area is mapped as well") {
  test::Surface s = test::creature(3);
  const Measurement before = mapped(s);
  const std::size_t count = s.triangles.size();
  for (std::size_t t = 0; t < count; t += 4)
    add_sliver(s, t, 0.3, t % 8 == 0 ? 0 : 1e-13);
  const Measurement m = mapped(s);
  CHECK(m.bijective);
  CHECK(m.zero_area_faces == (count + 3) / 4);
  CHECK(m.energy < 1.1 * before.energy);
  CHECK(m.mean_quasi_conformal < 1.1 * before.mean_quasi_conformal);
}

TEST_CASE("Vertices at one point, and all triangles without area, still have a map") {
  test::Surface s = test::sphere(2);
  s.positions[20] = s.positions[s.triangles[0][0]];
  for (const auto& t : s.triangles) {
    if (t[0] == 20) s.positions[t[1]] = s.positions[20];
  }
  CHECK(mapped(s).bijective);
  for (Vector3& p : s.positions)
    p = {p.x(), 0, 0};
  const Measurement flat = mapped(s);
  CHECK(flat.bijective);
  CHECK(flat.zero_area_faces == s.triangles.size());
  CHECK(flat.energy == 0);
  CHECK(flat.mean_quasi_conformal == 0);
}

TEST_CASE("Vertices in no triangle change no bit of the map or its figures, and get a direction") {
  const base::Host host;
  const test::Surface s = test::creature(3);
  const auto plain = compute(s.positions, s.triangles, {}, host);
  const Measurement expected = measure(s.positions, s.triangles, plain, 0.1, 1, host);
  test::Surface with = s;
  with.positions.insert(with.positions.end(), {{1e5, 0, 0}, {0, -1e300, 1e300}, {0.01, 0.02, 0}});
  auto directions = compute(with.positions, with.triangles, {}, host);
  REQUIRE(directions.size() == with.positions.size());
  for (std::size_t v = 0; v < s.positions.size(); ++v)
    CHECK(directions[v] == plain[v]);
  for (std::size_t v = s.positions.size(); v < directions.size(); ++v)
    CHECK(directions[v].norm() == doctest::Approx(1).epsilon(1e-12));
  directions.back() = Vector3::Zero();  // as other programs leave them
  directions[s.positions.size()] *= 7;
  const Measurement m = measure(with.positions, with.triangles, directions, 0.1, 1, host);
  CHECK(m.energy == expected.energy);
  CHECK(m.mean_quasi_conformal == expected.mean_quasi_conformal);
  CHECK(m.radius_error == expected.radius_error);
}

TEST_CASE("Shapes scaled by powers of two have maps and figures of the same bits") {
  const base::Host host;
  test::Surface s = test::creature(3);
  add_sliver(s, 5, 0.5, 1e-12);
  for (Vector3& p : s.positions)
    p += Vector3(3, -2, 5);
  const auto directions = compute(s.positions, s.triangles, {}, host);
  const Measurement expected = measure(s.positions, s.triangles, directions, 0.1, 1, host);
  for (const int exponent : {-990, -300, -1, 1, 300, 990}) {
    CAPTURE(exponent);
    test::Surface scaled = s;
    for (Vector3& p : scaled.positions)
      p *= std::ldexp(1.0, exponent);
    CHECK(compute(scaled.positions, scaled.triangles, {}, host) == directions);
    const Measurement m = measure(scaled.positions, scaled.triangles, directions, 0.1, 1, host);
    CHECK(m.energy == expected.energy);
    CHECK(m.mean_quasi_conformal == expected.mean_quasi_conformal);
    CHECK(m.isometric_mean == expected.isometric_mean);
    CHECK(m.zero_area_faces == expected.zero_area_faces);
  }
}
