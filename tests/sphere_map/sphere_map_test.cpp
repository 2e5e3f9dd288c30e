// Maps as a whole: always bijections, near what is known to be best, and independent of what should not matter.
#include "sphere_map/sphere_map.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "base/error.h"
#include "shapes.h"
#include "sphere_map/optimization/measure.h"

using namespace orbicube;
using namespace orbicube::sphere_map;
using test::measured;
using test::Surface;

namespace {

constexpr double lowest_energy = 0.1 * 16 * std::numbers::pi + 4 * std::numbers::pi;

Array<Vector3> map_of(const Surface& s, const Options& options = {}) {
  return compute(s.positions, s.triangles, options, base::Host());
}

void check_valid(const Surface& s, std::span<const Vector3> directions) {
  const Measurement m = measured(s, directions);
  CHECK(m.flipped == 0);
  CHECK(m.degenerate == 0);
  CHECK(m.degree == doctest::Approx(1).epsilon(1e-9));
  CHECK(m.bijective);
  CHECK(m.radius_error < 4e-16);
}

std::string refusal(const Surface& s, const Options& options = {}) {
  try {
    map_of(s, options);
  } catch (const base::Error& e) {
    return e.kind();
  }
  return "";
}

}  // namespace

TEST_CASE("Every method maps every shape to a bijection, from a tetrahedron on") {
  for (const Method method : {Method::balanced, Method::angle_area, Method::isometric, Method::stretch,
                              Method::conformal, Method::dissertation}) {
    Options options;
    options.method = method;
    check_valid(test::tetrahedron(), map_of(test::tetrahedron(), options));
    for (int levels = 0; levels < 4; ++levels) {
      const Surface s = test::creature(levels);
      check_valid(s, map_of(s, options));
    }
  }
}

TEST_CASE("A sphere is mapped nearly onto itself: its energy is close to the least there is") {
  const Surface s = test::sphere(4);
  const Measurement m = measured(s, map_of(s));
  CHECK(m.energy < 1.01 * lowest_energy);
  CHECK(m.energy > 0.98 * lowest_energy);  // flat triangles lie a little below the bound for smooth maps
  CHECK(m.max_quasi_conformal < 1.25);
  CHECK(m.stretch_efficiency > 0.95);
}

TEST_CASE("Every method wins in what it minimizes") {
  const Surface s = test::creature(4);
  const auto with = [&](Method method) {
    Options options;
    options.method = method;
    return measured(s, map_of(s, options));
  };
  const Measurement balanced = with(Method::balanced);
  const Measurement angle_area = with(Method::angle_area);
  const Measurement isometric = with(Method::isometric);
  const Measurement stretch = with(Method::stretch);
  const Measurement conformal = with(Method::conformal);
  for (const Measurement* other : {&balanced, &angle_area, &stretch, &conformal})
    CHECK(isometric.isometric_mean < other->isometric_mean);
  for (const Measurement* other : {&balanced, &angle_area, &isometric, &conformal})
    CHECK(stretch.stretch_efficiency > other->stretch_efficiency);
  for (const Measurement* other : {&balanced, &isometric, &stretch, &conformal})
    CHECK(angle_area.energy < other->energy);
  for (const Measurement* other : {&balanced, &angle_area, &isometric, &stretch})
    CHECK(conformal.energy_angle < other->energy_angle);
  // The bound is that of smooth maps: triangles as large as those at the ends of the protrusions stay above it.
  CHECK(conformal.energy_angle < 1.02 * 16 * std::numbers::pi);
}

TEST_CASE("More weight on angles gives a smaller angle energy, more on areas a smaller area energy") {
  const Surface s = test::creature(4);
  Options angles;
  angles.angle_weight = 1;
  angles.area_weight = 0.1;
  Options areas;
  areas.angle_weight = 0.1;
  areas.area_weight = 10;
  const Measurement by_angle = measured(s, map_of(s, angles));
  const Measurement by_area = measured(s, map_of(s, areas));
  CHECK(by_angle.energy_angle < 0.9 * by_area.energy_angle);
  CHECK(by_area.energy_area < 0.98 * by_angle.energy_area);
}

TEST_CASE("Quality does not depend on the order of vertices, nor on where a surface is, how large and how turned") {
  std::mt19937 random(2);
  const Surface original = test::creature(4);
  const double energy = measured(original, map_of(original)).energy;
  std::vector<Index> place(original.positions.size());
  std::iota(place.begin(), place.end(), Index{0});
  for (const double scale : {1e-150, 1.0, 1e150}) {
    std::shuffle(place.begin(), place.end(), random);
    const Eigen::Quaterniond rotation = Eigen::Quaterniond(1, 0.3, -0.7, 0.2).normalized();
    Surface s = original;
    for (Index v = 0; v < place.size(); ++v) {
      s.positions[place[v]] = scale * (rotation * original.positions[v] + Vector3(5, -3, 2));
    }
    for (Triangle& t : s.triangles)
      t = {place[t[1]], place[t[2]], place[t[0]]};
    std::shuffle(s.triangles.begin(), s.triangles.end(), random);
    const auto map = map_of(s);
    check_valid(s, map);
    // The hierarchy is the same; the figures are rounded differently.
    CHECK(measured(s, map).energy == doctest::Approx(energy).epsilon(1e-4));
  }
}

TEST_CASE("A surface that is inward-oriented is mapped as it looks from outside: all triangles are clockwise") {
  Surface s = test::creature(3);
  for (Triangle& t : s.triangles)
    std::swap(t[0], t[1]);
  const Measurement m = measured(s, map_of(s));
  CHECK(m.mirrored);
  CHECK(m.bijective);
}

TEST_CASE("Vertices in no triangle get a direction and change nothing else") {
  const Surface s = test::creature(3);
  Surface more = s;
  more.positions.emplace_back(0.1, 0.2, 0.3);
  more.positions.emplace_back(0, 0, 0);
  const auto map = map_of(s);
  const auto with_more = map_of(more);
  CHECK(std::equal(map.begin(), map.end(), with_more.begin()));
  for (std::size_t v = map.size(); v < with_more.size(); ++v) {
    CHECK(with_more[v].norm() == doctest::Approx(1).epsilon(1e-15));
  }
}

TEST_CASE("Surfaces with triangles that have no area, or that are flat, are mapped or refused, never wrongly") {
  Surface flat = test::creature(3);
  for (Vector3& p : flat.positions)
    p.z() = 0;
  check_valid(flat, map_of(flat));
  Surface pinched = test::creature(3);
  for (std::size_t v = 0; v < pinched.positions.size(); v += 3)
    pinched.positions[v] = Vector3(0.5, 0.5, 0.5);
  check_valid(pinched, map_of(pinched));
  Surface point = test::creature(2);
  for (Vector3& p : point.positions)
    p = Vector3(1, 2, 3);
  CHECK(refusal(point) == "degenerate-geometry");
}

TEST_CASE("A vertex of very high valence is no obstacle") {
  // A double cone over a circle of 3000 vertices.
  Surface s;
  const Index n = 3000;
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    s.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  s.positions.emplace_back(0, 0, 1);
  s.positions.emplace_back(0, 0, -1);
  for (Index i = 0; i < n; ++i) {
    s.triangles.push_back({i, (i + 1) % n, n});
    s.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  check_valid(s, map_of(s));
}

TEST_CASE("The same bits come out again, and another seed gives another map") {
  const Surface s = test::creature(4);
  const auto map = map_of(s);
  CHECK(map == map_of(s));
  Options options;
  options.seed = 1;
  const auto other = map_of(s, options);
  CHECK(map != other);
  check_valid(s, other);
}

TEST_CASE("What is no closed surface of genus 0, and options without a meaning, are refused") {
  Surface open = test::creature(2);
  open.triangles.pop_back();
  CHECK(refusal(open) == "not-closed");
  Surface wrong_index = test::creature(2);
  wrong_index.triangles[3][0] = static_cast<Index>(wrong_index.positions.size());
  CHECK(refusal(wrong_index) == "invalid-argument");
  Surface not_finite = test::creature(2);
  not_finite.positions[5].x() = std::nan("");
  CHECK(refusal(not_finite) == "invalid-argument");
  CHECK(refusal(Surface{}) == "empty-mesh");
  for (const auto& [angle, area] :
       {std::pair{0.0, 0.0}, {-1.0, 1.0}, {0.1, -1.0}, {std::nan(""), 1.0}, {1e200, 1.0}, {1e-300, 0.0}}) {
    Options options;
    options.angle_weight = angle;
    options.area_weight = area;
    CHECK(refusal(test::creature(2), options) == "invalid-argument");
  }
}

TEST_CASE("Maps follow from the ratio of the weights, up to the largest and down to the smallest that are allowed") {
  const Surface s = test::creature(2);
  const auto energy = [&](double weight) {
    Options options;
    options.angle_weight = options.area_weight = weight;
    const Array<Vector3> map = compute(s.positions, s.triangles, options, base::Host());
    return measure(s.positions, s.triangles, map, 1, 1, base::Host()).energy;
  };
  // Iterations end at another step of rounding.
  for (const double weight : {1e-100, 1e100})
    CHECK(energy(weight) == doctest::Approx(energy(1)).epsilon(1e-3));
}

TEST_CASE("Angles may have no weight: areas are preserved better, by a map that is still a bijection") {
  const Surface s = test::creature(4);
  for (const Method method : {Method::balanced, Method::angle_area}) {
    Options options;
    options.method = method;
    const auto measured = [&] {
      return measure(s.positions, s.triangles, compute(s.positions, s.triangles, options, base::Host()), 0, 1,
                     base::Host());
    };
    const Measurement both = measured();
    options.angle_weight = 0;
    const Measurement areas = measured();
    CHECK(areas.bijective);
    CHECK(areas.energy_area < both.energy_area);
    CHECK(areas.energy == areas.energy_area);
  }
}
