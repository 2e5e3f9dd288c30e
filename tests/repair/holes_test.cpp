// Holes and their patches.
#include "repair/holes/fill.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "damage.h"
#include "repair/holes/loops.h"
#include "repair/holes/triangulation.h"
#include "repair/soup/soup.h"

using namespace orbicube;
using namespace orbicube::test;

TEST_CASE("The triangulation of a convex planar polygon has its area, in any size") {
  const Vector3 none = Vector3::Constant(std::nan(""));
  for (const std::size_t n : {3U, 4U, 17U, 150U, 151U, 1000U}) {
    std::vector<Vector3> points, apexes(n, none);
    for (std::size_t i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      points.emplace_back(std::cos(a), std::sin(a), 1);
    }
    const auto triangles = repair::triangulate({.points = points, .apexes = apexes, .connected = {}}, base::Host());
    REQUIRE(triangles.size() == n - 2);
    double area = 0;
    for (const Triangle& t : triangles) {
      const double twice = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]])[2];
      CHECK(twice > 0);
      area += twice / 2;
    }
    const auto m = static_cast<double>(n);
    CHECK(area == doctest::Approx(m / 2 * std::sin(2 * std::numbers::pi / m)).epsilon(1e-12));
  }
}

TEST_CASE("A concave planar polygon is not folded, and edges that are there are not made") {
  const std::vector<Vector3> points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}};
  // Across the edges lie triangles outside, in the same plane.
  std::vector<Vector3> apexes;
  for (std::size_t i = 0; i < 5; ++i) {
    const Vector3 along = points[(i + 1) % 5] - points[i];
    apexes.push_back(0.5 * (points[i] + points[(i + 1) % 5]) + 0.1 * Vector3(along.y(), -along.x(), 0));
  }
  const auto triangles = repair::triangulate({.points = points, .apexes = apexes, .connected = {}}, base::Host());
  REQUIRE(triangles.size() == 3);
  for (const Triangle& t : triangles)
    CHECK((points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]])[2] > 0);
  // Without its diagonals no triangulation is left.
  const std::vector<std::array<Index, 2>> connected = {{0, 2}, {0, 3}, {1, 3}, {1, 4}, {2, 4}};
  CHECK(repair::triangulate({.points = points, .apexes = apexes, .connected = connected}, base::Host()).empty());
}

TEST_CASE("Triangles to avoid are not made where there is a way without them, and else the fewest") {
  std::vector<Vector3> points, apexes(6, Vector3::Constant(std::nan("")));
  for (int i = 0; i < 6; ++i)
    points.emplace_back(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), 0.1 * (i % 2));
  const auto with = [](Index a, Index b) {
    return [=](const Triangle& t) { return std::ranges::count(t, a) > 0 && std::ranges::count(t, b) > 0; };
  };
  for (Index a = 0; a < 6; ++a) {
    for (Index b = a + 2; b < 6 && b - a < 5; ++b) {
      const auto avoids = with(a, b);
      const auto triangles =
          repair::triangulate({.points = points, .apexes = apexes, .connected = {}, .avoids = avoids}, base::Host());
      CHECK(triangles.size() == 4);
      CHECK(std::ranges::none_of(triangles, avoids));
    }
  }
  // One triangle has edge 0, 1 in any case.
  const auto avoids = with(0, 1);
  const auto triangles =
      repair::triangulate({.points = points, .apexes = apexes, .connected = {}, .avoids = avoids}, base::Host());
  CHECK(std::ranges::count_if(triangles, avoids) == 1);
}

TEST_CASE("A patch goes around what stands in its way") {
  // The top of a block is open; its four corners are closed by a ridge from the first to the third or by a valley.
  Mesh block;
  for (const double low : {0.0, 1.0}) {
    for (const auto& [x, y, z] : {std::array{-1.0, 0.0, 0.5}, {0.0, -1.0, 0.0}, {1.0, 0.0, 0.5}, {0.0, 1.0, 0.0}})
      block.positions.push_back(low > 0 ? Vector3(x, y, -2) : Vector3(x, y, z));
  }
  for (Index i = 0; i < 4; ++i) {
    const Index k = (i + 1) % 4;
    block.triangles.push_back({i + 4, k + 4, k});
    block.triangles.push_back({i + 4, k, i});
  }
  block.triangles.push_back({4, 6, 5});
  block.triangles.push_back({4, 7, 6});
  const repair::PartOptions all{.keep = 0, .cavities = true};
  for (const bool fair : {true, false}) {
    for (const double height : {0.0, 0.5}) {
      const Mesh m = together(block, cube({-0.1, -0.1, height - 0.1}, 0.2));
      const repair::Repaired r = repaired(m, {.parts = all, .holes = {.fair = fair}});
      CHECK(r.report.certificate.is_solid());
      CHECK(r.report.certificate.parts == 2);
      CHECK(r.report.certificate.self_intersections == 0);
    }
  }
}

TEST_CASE("No two patches have an edge in common, in whatever way they are laid") {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    base::Random random(seed);
    Mesh m = mesh::make_shape("sphere", {.triangles = 300}, base::Host());
    for (Vector3& p : m.positions)
      p += 0.6 * Vector3(random.unit(), random.unit(), random.unit());
    // Half of the triangles are missing, so that loops share vertices and patches have to go around each other.
    std::erase_if(m.triangles, [&](const Triangle&) { return random.below(2) == 0; });
    repair::Soup soup = repair::soup_of(m.positions, m.triangles, base::Host());
    const base::Host host;
    base::Array<repair::Event> events;
    base::Array<std::uint8_t> counted(m.triangles.size(), 1);
    repair::fill_holes(soup, {}, {host, events, counted});
    const mesh::EdgeTable edges(soup.positions.size(), soup.triangles, host);
    std::size_t max_faces = 0;
    for (std::size_t e = 0; e < edges.size(); ++e)
      max_faces = std::max(max_faces, edges.half_edges(e).size());
    CHECK(max_faces == 2);
  }
}

TEST_CASE("A patch on a sphere continues it, as dense as its surroundings") {
  Mesh m = mesh::make_shape("sphere", {.triangles = 8000}, base::Host());
  const double radius = m.positions[0].norm();
  const std::size_t before = m.triangles.size();
  std::erase_if(m.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) { return m.positions[v].z() > 0.8 * radius; });
  });
  const std::size_t removed = before - m.triangles.size();
  const repair::Repaired r = repaired(m);
  REQUIRE(r.report.certificate.is_solid());
  CHECK(r.report.certificate.genus == 0);
  CHECK(r.report.certificate.self_intersections == 0);
  CHECK(r.report.holes.filled == 1);
  CHECK(r.report.move.from_input == 0);
  CHECK(r.report.move.from_result == 0);
  const auto patch = static_cast<double>(r.report.holes.triangles), missing = static_cast<double>(removed);
  CHECK(patch > 0.5 * missing);
  CHECK(patch < 2 * missing);
  double worst = 0;
  for (const Vector3& p : r.surface.positions)
    worst = std::max(worst, std::abs(p.norm() - radius));
  CHECK(worst < 0.04 * radius);  // a plane across is off by 0.2
  // Flat patches have no vertices inside.
  const repair::Repaired flat = repaired(m, {.holes = {.fair = false}});
  CHECK(flat.report.certificate.is_solid());
  CHECK(flat.report.holes.vertices == 0);
}

TEST_CASE("A patch in a plane stays in it, and closes the volume exactly") {
  Mesh m = mesh::make_shape("cube", {.triangles = 3000}, base::Host());
  const double volume = repaired(m).report.certificate.volume;
  std::erase_if(m.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](Index v) {
      const Vector3& p = m.positions[v];
      return p.z() > 0 && std::abs(p.x()) < 0.5 && std::abs(p.y()) < 0.4;
    });
  });
  const repair::Repaired r = repaired(m);
  CHECK(r.report.holes.filled == 1);
  CHECK(r.report.certificate.is_solid());
  CHECK(r.report.certificate.volume == doctest::Approx(volume).epsilon(1e-12));
  CHECK(r.report.move.patches < 1.0);
}

TEST_CASE("Holes of more edges than the limit stay open") {
  Mesh m = mesh::make_shape("sphere", {.triangles = 2000}, base::Host());
  m.triangles.pop_back();
  base::Random random(3);
  add_holes(m, 1, random);
  const repair::Repaired r = repaired(m, {.holes = {.max_edges = 3}});
  CHECK(r.report.holes.found == 2);
  CHECK(r.report.holes.filled == 1);
  CHECK(r.report.certificate.boundary_loops == 1);
  CHECK(r.report.certificate.manifold);
  CHECK(std::count_if(r.events.begin(), r.events.end(),
                      [](const repair::Event& e) { return e.action == repair::Action::left_hole; }) == 1);
}

TEST_CASE("Holes that touch at a vertex are filled one by one") {
  Mesh m = mesh::make_shape("sphere", {.triangles = 2000}, base::Host());
  // Opposite triangles of the fan at a vertex.
  const Index v = m.triangles[100][0];
  std::vector<std::size_t> fan;
  for (std::size_t t = 0; t < m.triangles.size(); ++t) {
    const Triangle& c = m.triangles[t];
    if (c[0] == v || c[1] == v || c[2] == v) fan.push_back(t);
  }
  // Two that share no other vertex.
  std::size_t first = fan[0], second = fan[0];
  for (const std::size_t t : fan) {
    std::size_t shared = 0;
    for (const Index a : m.triangles[first])
      shared += static_cast<std::size_t>(std::count(m.triangles[t].begin(), m.triangles[t].end(), a));
    if (shared == 1) second = t;
  }
  REQUIRE(first != second);
  const std::size_t count = m.triangles.size();
  m.triangles.erase(m.triangles.begin() + static_cast<std::ptrdiff_t>(std::max(first, second)));
  m.triangles.erase(m.triangles.begin() + static_cast<std::ptrdiff_t>(std::min(first, second)));
  const repair::Repaired r = repaired(m);
  CHECK(r.report.holes.filled == 2);
  CHECK(r.report.certificate.is_solid());
  CHECK(r.report.certificate.self_intersections == 0);
  CHECK(r.surface.positions == m.positions);
  CHECK(r.surface.triangles.size() == count);
  // Left open, the vertex is split.
  const repair::Repaired open = repaired(m, {.fill_holes = false});
  CHECK(open.report.certificate.manifold);
}

TEST_CASE("A tube is closed at both ends, a single triangle becomes closed") {
  Mesh tube;
  const Index n = 20;
  for (Index i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    tube.positions.push_back(Vector3(std::cos(a), std::sin(a), 0));
    tube.positions.push_back(Vector3(std::cos(a), std::sin(a), 3));
  }
  for (Index i = 0; i < n; ++i) {
    const Index a = 2 * i, b = a + 1, c = 2 * ((i + 1) % n), d = c + 1;
    tube.triangles.push_back({a, c, b});
    tube.triangles.push_back({b, c, d});
  }
  const repair::Repaired r = repaired(tube);
  CHECK(r.report.certificate.is_solid());
  CHECK(r.report.holes.filled == 2);
  CHECK(r.report.certificate.genus == 0);
  CHECK(r.report.certificate.self_intersections == 0);

  Mesh one;
  one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  const repair::Repaired closed = repaired(one);
  CHECK(closed.report.certificate.closed);
  CHECK(closed.report.certificate.manifold);
  CHECK(closed.report.certificate.self_intersections > 0);  // it has no inside
}
