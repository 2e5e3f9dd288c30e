// Figures of maps that are known.
#include "sphere_map/optimization/measure.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "shapes.h"

using namespace orbicube;
using namespace orbicube::sphere_map;
using test::measured;

TEST_CASE("The identity of a fine sphere has no distortion") {
  test::Surface s = test::sphere(5);
  const std::vector<Vector3> directions = s.positions;
  for (Vector3& p : s.positions)
    p = 7 * p + Vector3(100, 200, -300);
  FaceDistortion faces(std::pmr::get_default_resource());
  const Measurement m = measured(s, directions, &faces);
  CHECK(m.bijective);
  CHECK(m.degree == doctest::Approx(1).epsilon(1e-12));
  CHECK(m.energy_angle == doctest::Approx(16 * std::numbers::pi).epsilon(2e-3));
  CHECK(m.energy_area == doctest::Approx(4 * std::numbers::pi).epsilon(2e-3));
  CHECK(m.energy == doctest::Approx(0.1 * m.energy_angle + m.energy_area));
  CHECK(m.max_quasi_conformal == doctest::Approx(1).epsilon(1e-9));
  CHECK(m.mean_quasi_conformal == doctest::Approx(1).epsilon(1e-9));
  CHECK(m.stretch_efficiency == doctest::Approx(1).epsilon(2e-3));
  CHECK(m.isometric_mean == doctest::Approx(1).epsilon(1e-3));
  CHECK(m.min_area_ratio == doctest::Approx(1).epsilon(3e-3));
  CHECK(m.max_area_ratio == doctest::Approx(1).epsilon(3e-3));
  CHECK(faces.quasi_conformal.size() == s.triangles.size());
}

TEST_CASE("Eq. 3.1 to 3.4 of maps small enough to compute by hand") {
  // A tetrahedron on itself: D = 8 / sqrt 3, area(t) = 2 / sqrt 3, area(T) = pi, d = 1/3.
  const double pi = std::numbers::pi;
  const test::Surface tetrahedron = test::tetrahedron();
  Measurement m = measured(tetrahedron, tetrahedron.positions);
  CHECK(m.equation_3_1 == doctest::Approx(64.0 / 3).epsilon(1e-14));
  CHECK(m.equation_3_2 == doctest::Approx(16 / (3 * pi)).epsilon(1e-14));
  CHECK(m.equation_3_3 == doctest::Approx(192).epsilon(1e-14));
  CHECK(m.equation_3_4 == doctest::Approx(48 / pi).epsilon(1e-14));
  CHECK(m.energy_angle == doctest::Approx(288 / std::sqrt(3)).epsilon(1e-14));

  // An octahedron of twice the height: cot = 4/3, 1/3, 1/3, so D = 4; area(t) = sqrt 3 / 2, area(T) = pi / 2, d^2 =
  // 1/3.
  test::Surface high = test::sphere(0);
  const std::vector<Vector3> directions = high.positions;
  for (Vector3& p : high.positions)
    p.z() *= 2;
  m = measured(high, directions);
  CHECK(m.equation_3_1 == doctest::Approx(16 * std::sqrt(3)).epsilon(1e-14));
  CHECK(m.equation_3_2 == doctest::Approx(12 / pi).epsilon(1e-14));
  CHECK(m.equation_3_3 == doctest::Approx(48 * std::sqrt(3)).epsilon(1e-14));
  CHECK(m.equation_3_4 == doctest::Approx(36 / pi).epsilon(1e-14));
  CHECK(m.equation_3_4 == m.energy_area);
  CHECK(m.energy_angle == doctest::Approx(96).epsilon(1e-14));
}

TEST_CASE("Eq. 3.1 and 3.3 vanish under refinement as printed, and 3.2 and 3.4 do not") {
  double last = std::numeric_limits<double>::infinity();
  for (int levels = 2; levels < 5; ++levels) {
    const test::Surface s = test::sphere(levels);
    const Measurement m = measured(s, s.positions);
    CHECK(m.equation_3_1 <= m.equation_3_3);
    CHECK(m.equation_3_3 < 0.3 * last);
    CHECK(m.equation_3_2 == doctest::Approx(4 * std::numbers::pi).epsilon(0.2));
    CHECK(m.equation_3_4 == doctest::Approx(4 * std::numbers::pi).epsilon(0.02));
    last = m.equation_3_3;
  }
}

TEST_CASE("The normalized positions of an ellipsoid have the quasi-conformal distortion that its axes say") {
  // Seen from the poles, the ellipsoid x^2 + y^2 + (z / 2)^2 = 1 is round; at the equator z is stretched by 2.
  test::Surface s = test::sphere(5);
  const std::vector<Vector3> directions = s.positions;
  for (Vector3& p : s.positions)
    p.z() *= 2;
  const Measurement m = measured(s, directions);
  CHECK(m.max_quasi_conformal == doctest::Approx(2).epsilon(2e-2));
  CHECK(m.mean_quasi_conformal > 1.2);
  CHECK(m.mean_quasi_conformal < 2);
}

TEST_CASE("Turned, flattened and doubled maps are no bijections") {
  const test::Surface s = test::sphere(2);
  std::vector<Vector3> directions = s.positions;
  const Index v = s.triangles[0][0];
  directions[v] = -directions[v];  // across the sphere
  const Measurement across = measured(s, directions);
  CHECK(across.flipped > 0);
  CHECK_FALSE(across.bijective);

  directions = s.positions;
  directions[s.triangles[0][0]] = directions[s.triangles[0][1]];
  const Measurement flat = measured(s, directions);
  CHECK(flat.degenerate >= 1);
  CHECK_FALSE(flat.bijective);
  CHECK(count_not_positive(s.triangles, directions) >= 1);

  // z -> z^2 on the Riemann sphere covers it twice; coarse triangles that do not flip would still have degree 2.
  const test::Surface fine = test::sphere(5);
  directions.clear();
  for (const Vector3& p : fine.positions) {
    const double angle = 2 * std::atan2(p.y(), p.x());
    directions.emplace_back(std::hypot(p.x(), p.y()) * std::cos(angle), std::hypot(p.x(), p.y()) * std::sin(angle),
                            p.z());
  }
  const Measurement twice = measured(fine, directions);
  CHECK(twice.degree == doctest::Approx(2).epsilon(1e-3));
  CHECK_FALSE(twice.bijective);
}

TEST_CASE("A mirrored map is a bijection and is said to be mirrored") {
  const test::Surface s = test::sphere(3);
  std::vector<Vector3> directions = s.positions;
  for (Vector3& p : directions)
    p.x() = -p.x();
  const Measurement m = measured(s, directions);
  CHECK(m.mirrored);
  CHECK(m.bijective);
  CHECK(m.degree == doctest::Approx(1).epsilon(1e-12));
  CHECK(m.energy_angle == doctest::Approx(measured(s, s.positions).energy_angle));
}

TEST_CASE(
    "Figures do not change with the length of directions nor, from 1e-150 to 1e150, with the size of the surface") {
  test::Surface s = test::creature(3);
  std::vector<Vector3> directions;
  for (const Vector3& p : test::sphere(3).positions)
    directions.push_back(p);
  const Measurement expected = measured(s, directions);
  for (const double scale : {1e-150, 1e150}) {
    test::Surface scaled = s;
    for (Vector3& p : scaled.positions)
      p *= scale;
    std::vector<Vector3> longer = directions;
    for (Vector3& p : longer)
      p *= scale;
    const Measurement m = measured(scaled, longer);
    CHECK(m.energy == doctest::Approx(expected.energy).epsilon(1e-10));
    CHECK(m.max_quasi_conformal == doctest::Approx(expected.max_quasi_conformal).epsilon(1e-10));
    CHECK(m.flipped == expected.flipped);
  }
}

TEST_CASE("Faces without area are counted and left out of the figures") {
  test::Surface s = test::sphere(2);
  const std::vector<Vector3> directions = s.positions;
  s.positions[s.triangles[0][0]] = s.positions[s.triangles[0][1]];
  FaceDistortion faces(std::pmr::get_default_resource());
  const Measurement m = measured(s, directions, &faces);
  CHECK(m.zero_area_faces >= 1);
  CHECK(std::isfinite(m.energy));
  CHECK(std::isinf(faces.quasi_conformal[0]));
  CHECK(m.bijective);
}

TEST_CASE("Wrong sizes and numbers that are not finite are refused") {
  const test::Surface s = test::sphere(1);
  std::vector<Vector3> directions = s.positions;
  directions.pop_back();
  CHECK_THROWS_AS(measured(s, directions), base::Error);
  directions = s.positions;
  directions[3] = Vector3::Zero();
  CHECK_THROWS_AS(measured(s, directions), base::Error);
  directions[3].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(measured(s, directions), base::Error);
}
