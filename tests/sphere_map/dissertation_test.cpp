// The dissertation's own method: its search against finite differences, and its maps as a whole.
#include "sphere_map/dissertation/method.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "base/error.h"
#include "shapes.h"
#include "sphere_map/dissertation/step.h"
#include "sphere_map/hierarchy/normalize.h"
#include "sphere_map/optimization/measure.h"

using namespace orbicube;
using namespace orbicube::sphere_map;
using test::measured;
using test::Surface;

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

Array<Vector3> dissertation_map(const Surface& s, const dissertation::DissertationOptions& options = {}) {
  const base::Host host;
  return dissertation::compute(normalized(s.positions, s.triangles, host.memory), s.triangles, options, host);
}

// A vertex 0 amid a ring of five on the sphere, which belongs to a bumpy surface.
struct Star {
  std::vector<Vector3> directions;
  std::vector<StarTriangle> triangles;
};

Star star(std::mt19937& random, double radius) {
  std::uniform_real_distribution<double> part(-1, 1);
  const Vector3 centre = Vector3(part(random), part(random), part(random)).normalized();
  const TangentBasis basis(centre);
  Star result;
  std::vector<Vector3> surface;
  result.directions.push_back(
      (centre + 0.2 * radius * (part(random) * basis.first + part(random) * basis.second)).normalized());
  surface.push_back(Vector3(0.2 * part(random), 0.2 * part(random), 0.3 * part(random)));
  for (Index i = 0; i < 5; ++i) {
    const double angle = 1.2566 * i + 0.3 * part(random);
    const double reach = radius * (1 + 0.2 * part(random));
    result.directions.push_back(
        (centre + reach * (std::cos(angle) * basis.first + std::sin(angle) * basis.second)).normalized());
    surface.push_back(Vector3(std::cos(angle), std::sin(angle), 0.3 * part(random)));
  }
  for (Index i = 0; i < 5; ++i) {
    const Index q = i + 1;
    const Index r = (i + 1) % 5 + 1;
    result.triangles.push_back({q, r, triangle_shape(surface[0], surface[q], surface[r])});
  }
  return result;
}

}  // namespace

TEST_CASE(
    "The dissertation's priority is the length of the energy's tangent gradient times the mean distance to the ring") {
  std::mt19937 random(7);
  for (const double radius : {0.02, 0.5, 1.2}) {
    for (int trial = 0; trial < 20; ++trial) {
      const Star s = star(random, radius);
      const Vector3 p = s.directions[0];
      const double angle_weight = trial == 4 ? 0.0 : 0.1 + 0.1 * trial;
      const dissertation::PrintedEnergy energy{angle_weight, trial == 3 ? 0.0 : 1.0, 1.0, unbounded};
      const TangentBasis basis(p);
      const double h = 1e-5 * radius;
      const auto slope = [&](const Vector3& along) {
        const auto at = [&](double step) {
          return dissertation::star_energy(energy, s.triangles, (p + step * along).normalized(), s.directions);
        };
        return (at(h) - at(-h)) / (2 * h);
      };
      double distance = 0;
      for (std::size_t i = 1; i < s.directions.size(); ++i)
        distance += (s.directions[i] - p).norm() / 5;
      const double expected = std::hypot(slope(basis.first), slope(basis.second)) * distance;
      // Beside the rounding of the differences: an obtuse triangle's energy has a kink, which h may cross.
      CHECK(dissertation::priority(energy, 0, s.triangles, s.directions) == doctest::Approx(expected).epsilon(1e-4));
    }
  }
}

TEST_CASE("The great-circle search lowers the energy by what it says, stays on the sphere and inside the kernel") {
  std::mt19937 random(11);
  int moved = 0;
  for (const double radius : {1e-6, 0.02, 0.5, 1.2}) {
    for (int trial = 0; trial < 50; ++trial) {
      Star s = star(random, radius);
      const dissertation::PrintedEnergy energy{0.1, 1, 4 * radius * radius, unbounded};
      for (int step = 0; step < 20; ++step) {
        const double before = dissertation::star_energy(energy, s.triangles, s.directions[0], s.directions);
        const double gain = dissertation::great_circle_search(energy, 0, s.triangles, s.directions);
        const double after = dissertation::star_energy(energy, s.triangles, s.directions[0], s.directions);
        REQUIRE(gain >= 0);
        REQUIRE(before - after == doctest::Approx(gain).epsilon(1e-6));
        REQUIRE(std::abs(s.directions[0].norm() - 1) < 4e-16);
        for (const StarTriangle& t : s.triangles)
          REQUIRE(safely_positive(s.directions[0], s.directions[t.q], s.directions[t.r]));
        moved += gain > 0;
      }
      // Where it ends, the gradient has all but vanished beside that of the first place.
      CHECK(dissertation::priority(energy, 0, s.triangles, s.directions) <
            0.05 * dissertation::star_energy(energy, s.triangles, s.directions[0], s.directions));
    }
  }
  CHECK(moved > 500);
}

TEST_CASE("The great-circle search does not raise a quasi-conformal distortion above its bound") {
  std::mt19937 random(13);
  for (int trial = 0; trial < 50; ++trial) {
    Star s = star(random, 0.3);
    const auto worst = [&] {
      double largest = 0;
      for (const StarTriangle& t : s.triangles) {
        const SphericalTriangle image(s.directions[0], s.directions[t.q], s.directions[t.r]);
        largest = std::max(largest, 0.5 * image.D(t.shape) / image.determinant);
      }
      return largest;
    };
    const double bound = std::max(1.2, worst());
    // With next to no weight on angles, areas alone would pull the vertex further.
    dissertation::great_circle_search({1e-6, 1, 0.09, 1.2}, 0, s.triangles, s.directions);
    CHECK(worst() <= bound);
  }
}

TEST_CASE("The seed maps every shape to a bijection, from a tetrahedron on") {
  const auto check = [](const Surface& s) {
    const Measurement m = measured(s, dissertation_map(s));
    CHECK(m.bijective);
    CHECK(m.radius_error < 4e-16);
  };
  check(test::tetrahedron());
  for (int levels = 0; levels < 6; ++levels)
    check(test::creature(levels));
}

TEST_CASE("The seed maps a sphere nearly to itself") {
  const Surface s = test::sphere(4);
  const Measurement m = measured(s, dissertation_map(s));
  CHECK(m.bijective);
  CHECK(m.energy < 1.002 * measured(s, Array<Vector3>(s.positions.begin(), s.positions.end())).energy);
}

TEST_CASE("Surfaces with triangles without area get a map from the seed too") {
  Surface s = test::sphere(3);
  for (Vector3& p : s.positions) {
    if (p.z() > 0) p.z() = 0;  // flat, with vertices on edges
    if (p.x() > 0.5) p = Vector3(0.5, 0, 0);
  }
  CHECK(measured(s, dissertation_map(s)).bijective);
}

TEST_CASE(
    "The dissertation's trace is the energy of the map that it ends with, and falls while the mesh stays the same") {
  const Surface s = test::creature(4);
  std::vector<dissertation::TracePoint> points;
  dissertation::DissertationOptions options;
  options.trace = [&](const dissertation::TracePoint& point) { points.push_back(point); };
  const Measurement m = measured(s, dissertation_map(s, options));
  REQUIRE(points.size() > 10);
  CHECK(points.front().vertices < 100);
  CHECK(points.back().vertices == s.positions.size());
  CHECK(points.back().energy == doctest::Approx(m.energy).epsilon(1e-9));
  for (std::size_t i = 1; i < points.size(); ++i) {
    CHECK(points[i].iterations > points[i - 1].iterations);
    if (points[i].vertices == points[i - 1].vertices) CHECK(points[i].energy < points[i - 1].energy);
  }
}

TEST_CASE("The seed gives the same bits each time, and other maps for other numbers of splits and seeds") {
  const Surface s = test::creature(3);
  const Array<Vector3> first = dissertation_map(s);
  CHECK(dissertation_map(s) == first);
  CHECK(dissertation_map(s, {.limits = {.level_splits = 7}}) != first);
  CHECK(dissertation_map(s, {.limits = {.level_tolerance = 1}}) != first);
  CHECK(dissertation_map(s, {.limits = {.max_level_iterations = 3}}) != first);
  // What the defaults stand for.
  CHECK(dissertation_map(s, {.limits = {.level_splits = 40,
                                        .level_tolerance = 1e-4,
                                        .final_tolerance = 1e-4,
                                        .max_level_iterations = 2000,
                                        .max_final_iterations = 100 * s.positions.size()}}) == first);
  CHECK(dissertation_map(s, {.seed = 5}) != first);
}

TEST_CASE("The dissertation's weights shift its map from areas to angles") {
  const Surface s = test::creature(4);
  const Measurement areas = measured(s, dissertation_map(s, {.angle_weight = 0.01}));
  const Measurement angles = measured(s, dissertation_map(s, {.angle_weight = 1, .area_weight = 0.01}));
  CHECK(areas.bijective);
  CHECK(angles.bijective);
  CHECK(areas.energy_area < angles.energy_area);
  CHECK(angles.energy_angle < areas.energy_angle);
}

TEST_CASE("The dissertation's final phase goes on for as long as it may") {
  const Surface s = test::creature(4);
  double last = std::numeric_limits<double>::infinity();
  for (const std::uint64_t rounds : {1U, 4U, 16U}) {
    std::vector<TracePoint> trace;
    dissertation::DissertationOptions options;
    options.limits = {.final_tolerance = 0, .max_final_iterations = rounds * s.positions.size()};
    options.trace = [&](const TracePoint& point) { trace.push_back(point); };
    CHECK(measured(s, dissertation_map(s, options)).bijective);
    const auto whole = std::count_if(trace.begin(), trace.end(),
                                     [&](const TracePoint& point) { return point.vertices == s.positions.size(); });
    CHECK(whole >= static_cast<std::ptrdiff_t>(rounds));
    CHECK(trace.back().energy < last);
    last = trace.back().energy;
  }
}

TEST_CASE("The dissertation's method optimizes areas alone, to a bijection") {
  const Surface s = test::creature(4);
  const Measurement both = measured(s, dissertation_map(s));
  const Measurement areas = measured(s, dissertation_map(s, {.angle_weight = 0}));
  CHECK(areas.bijective);
  CHECK(areas.energy_area < both.energy_area);
}

TEST_CASE("The seed refuses options that mean nothing, and can be cancelled") {
  const Surface s = test::creature(3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const dissertation::DissertationOptions& options :
       {dissertation::DissertationOptions{.angle_weight = 0, .area_weight = 0},
        dissertation::DissertationOptions{.angle_weight = nan}, dissertation::DissertationOptions{.area_weight = -1},
        dissertation::DissertationOptions{.limits = {.level_splits = 0}},
        dissertation::DissertationOptions{.limits = {.level_splits = max_level_splits + 1}},
        dissertation::DissertationOptions{.limits = {.level_tolerance = -1}},
        dissertation::DissertationOptions{.limits = {.final_tolerance = nan}}}) {
    CHECK_THROWS_AS(dissertation_map(s, options), base::Error);
  }
  base::Host host;
  host.on_progress = [](const base::Progress&) { return false; };
  try {
    dissertation::compute(normalized(s.positions, s.triangles, host.memory), s.triangles, {}, host);
    FAIL("not cancelled");
  } catch (const base::Error& e) {
    CHECK(std::string(e.kind()) == "cancelled");
  }
}
