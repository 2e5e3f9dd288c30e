// Maps refined for an expansion: nearer to the shape, and still one to one.
#include "harmonics/fitting/map_refinement.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "base/error.h"

using namespace orbicube;
using namespace orbicube::harmonics;

namespace {

struct Shape {
  std::vector<Vector3> positions, directions;
  std::vector<Triangle> triangles;
};

// An octahedron, each triangle split in four; two horns, and a map that is dense at the wrong places.
Shape horned(int levels) {
  Shape s;
  s.directions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  s.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto next = static_cast<std::uint32_t>(s.directions.size());
      const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), next);
      if (is_new) s.directions.push_back((s.directions[a] + s.directions[b]).normalized());
      return entry->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    s.triangles = std::move(finer);
  }
  for (Vector3& u : s.directions) {
    const double horns = std::exp(-20 * (1 - u.x())) + std::exp(-20 * (1 - u.z()));
    s.positions.push_back((1 + horns) * u);
    u = Vector3(u.x(), u.y(), u.z() + 0.3).normalized();
  }
  return s;
}

// A third of the area of its triangles for each vertex.
std::vector<double> vertex_areas(const Shape& s) {
  std::vector<double> areas(s.positions.size(), 0.0);
  for (const Triangle& t : s.triangles) {
    const Vector3 a = s.positions[t[1]] - s.positions[t[0]], b = s.positions[t[2]] - s.positions[t[0]];
    for (const std::uint32_t v : t)
      areas[v] += a.cross(b).norm() / 6;
  }
  return areas;
}

double smallest_determinant(const Shape& s, std::span<const Vector3> directions) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : s.triangles)
    least = std::min(least, directions[t[0]].dot(directions[t[1]].cross(directions[t[2]])));
  return least;
}

FitReport fitted(const Shape& s, std::span<const Vector3> directions, std::span<const double> weights) {
  FitReport report;
  fit(directions, weights, {s.positions.front().data(), 3 * s.positions.size()}, 3, {.degree = 6}, base::Host(),
      report);
  return report;
}

}  // namespace

TEST_CASE("A refined map fits better, by what the report says, and stays one to one") {
  const Shape s = horned(4);
  const base::Host host;
  const std::vector<double> weights = vertex_areas(s);
  REQUIRE(smallest_determinant(s, s.directions) > 0);
  double last = fitted(s, s.directions, weights).residual;
  const double before = last;
  for (const std::uint32_t rounds : {1U, 3U, 10U}) {
    std::vector<Vector3> directions = s.directions;
    const RefinementReport report =
        refine_map(s.positions, s.triangles, weights, {.fit = {.degree = 6}, .rounds = rounds}, directions, host);
    CHECK(report.residual_before == doctest::Approx(before).epsilon(1e-12));
    CHECK(report.residual == doctest::Approx(fitted(s, directions, weights).residual).epsilon(1e-9));
    CHECK(report.residual < last);
    CHECK(report.rounds <= rounds);
    CHECK(smallest_determinant(s, directions) > 0);
    for (const Vector3& u : directions)
      REQUIRE(u.norm() == doctest::Approx(1).epsilon(1e-14));
    last = report.residual;
  }
  CHECK(last < 0.7 * before);
}

TEST_CASE("No round leaves a map as it is, but for its lengths; a shape that is fitted exactly needs none") {
  const Shape s = horned(3);
  std::vector<Vector3> directions = s.directions;
  for (Vector3& u : directions)
    u *= 4;
  refine_map(s.positions, s.triangles, {}, {.fit = {.degree = 4}, .rounds = 0}, directions, base::Host());
  for (std::size_t v = 0; v < directions.size(); ++v)
    CHECK((directions[v] - s.directions[v]).norm() < 1e-15);

  const std::vector<Vector3> ball = s.directions;
  const RefinementReport report =
      refine_map(ball, s.triangles, {}, {.fit = {.degree = 4}, .rounds = 5}, directions, base::Host());
  CHECK(report.residual < 1e-12);
  for (std::size_t v = 0; v < directions.size(); ++v)
    CHECK((directions[v] - s.directions[v]).norm() < 1e-9);
}

TEST_CASE("A mirrored map stays mirrored, and what is wrong is refused") {
  Shape s = horned(3);
  for (Triangle& t : s.triangles)
    std::swap(t[1], t[2]);
  std::vector<Vector3> directions = s.directions;
  refine_map(s.positions, s.triangles, {}, {.fit = {.degree = 4}, .rounds = 3}, directions, base::Host());
  CHECK(directions != s.directions);
  double greatest = -1;
  for (const Triangle& t : s.triangles)
    greatest = std::max(greatest, directions[t[0]].dot(directions[t[1]].cross(directions[t[2]])));
  CHECK(greatest < 0);

  const auto refused = [](const Shape& shape, std::vector<Vector3> at, const base::Host& host = {}) {
    try {
      refine_map(shape.positions, shape.triangles, {}, {.fit = {.degree = 4}, .rounds = 2}, at, host);
    } catch (const base::Error& e) {
      return std::string(e.kind());
    }
    return std::string("nothing");
  };
  CHECK(refused(s, {}) == "invalid-argument");
  CHECK(refused({}, {}) == "invalid-argument");
  directions[5] = Vector3::Zero();
  CHECK(refused(s, directions) == "invalid-argument");
  base::Host cancelling;
  cancelling.on_progress = [](const base::Progress&) { return false; };
  CHECK(refused(s, s.directions, cancelling) == "cancelled");
  s.triangles[2][1] = static_cast<std::uint32_t>(s.positions.size());
  CHECK(refused(s, s.directions) == "index-range");
}
