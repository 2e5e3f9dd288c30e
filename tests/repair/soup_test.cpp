// Steps on triangles alone: welding, cleaning, near-degenerate triangles, T-junctions.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "damage.h"

using namespace orbicube;
using namespace orbicube::test;

TEST_CASE("A clean surface comes back bit for bit, at any scale and place") {
  for (const char* shape : {"sphere", "torus", "bracket"}) {
    for (const double scale : {1.0, 1e-100, 1e100, 1e-200, 3e200}) {
      Mesh m = mesh::make_shape(shape, {.triangles = 2000}, base::Host());
      for (Vector3& p : m.positions)
        p = scale * (p + Vector3(5, 0, 0));
      const repair::Repaired r = repaired(m);
      CHECK(!r.report.changed);
      CHECK(r.surface.positions == m.positions);
      CHECK(r.surface.triangles == m.triangles);
      CHECK(r.events.empty());
      CHECK(r.report.certificate.is_solid());
      CHECK(r.report.certificate.self_intersections == 0);
    }
  }
}

TEST_CASE("Vertices of open edges are welded within the distance, others are not") {
  Mesh m = cube();
  base::Random random(1);
  tear(m, 10, 1e-9, random);
  const repair::Repaired r = repaired(m);
  CHECK(r.report.certificate.is_solid());
  CHECK(r.surface.positions.size() == 8);
  CHECK(r.surface.triangles.size() == 12);
  CHECK(r.report.weld.largest_move < 2e-9);
  CHECK(r.report.weld.vertices >= 5);

  // Two closed cubes whose faces touch: nothing is open.
  const Mesh two = together(cube(), cube({1, 0, 0}));
  const repair::Repaired kept = repaired(two, {.parts = {.keep = 0}});
  CHECK(!kept.report.changed);

  // A gap that is wider than what the default takes.
  Mesh wide = cube();
  wide.positions.push_back(Vector3(1e-3, 0, 0));
  wide.triangles[0][0] = 8;
  repair::Options options;
  options.fill_holes = false;
  CHECK(!repaired(wide, options).report.certificate.closed);
  options.weld_distance = 2e-3;
  const repair::Repaired closed = repaired(wide, options);
  CHECK(closed.report.certificate.is_solid());
  CHECK(closed.report.weld.largest_move == 1e-3);
  CHECK(closed.surface.positions[0] == Vector3(0, 0, 0));
}

TEST_CASE("Degenerate and repeated faces and unused vertices are removed") {
  Mesh m = cube();
  m.triangles.push_back({3, 3, 5});
  m.triangles.push_back({2, 1, 0});
  m.triangles.push_back({1, 2, 3});
  m.positions.push_back(Vector3(9, 9, 9));
  const repair::Repaired r = repaired(m);
  CHECK(r.report.clean.degenerate == 1);
  CHECK(r.report.clean.duplicate == 2);
  CHECK(r.report.unused_vertices == 1);
  CHECK(r.surface.triangles == cube().triangles);
  CHECK(r.surface.positions == cube().positions);
  CHECK(r.events.size() == 3);
}

TEST_CASE("Needles and caps are removed without moving the surface, and nothing else changes") {
  Mesh m = mesh::make_shape("bracket", {.triangles = 3000}, base::Host());
  const Mesh clean = m;
  base::Random random(5);
  add_slivers(m, 40, 1e-9, random);
  const repair::Repaired r = repaired(m);
  CHECK(r.report.slivers.found >= 40);
  CHECK(r.report.slivers.left == 0);
  CHECK(r.report.certificate.is_solid());
  CHECK(r.report.certificate.genus == repaired(clean).report.certificate.genus);
  CHECK(r.report.certificate.self_intersections == 0);
  CHECK(std::max(r.report.move.from_input, r.report.move.from_result) < 1e-8);
  CHECK(repair::count_slivers(r.surface, 1e-6) == 0);
  // Vertices of the clean surface are where they were.
  std::size_t kept = 0;
  for (std::size_t v = 0; v < r.surface.positions.size(); ++v) {
    const Index source = r.surface.vertex_source[v];
    CHECK(r.surface.positions[v] == m.positions[source]);
    kept += source < clean.positions.size();
  }
  CHECK(kept + 40 >= clean.positions.size());
}

TEST_CASE("A cap on the boundary is removed, and its neighbors meet there") {
  // A triangle whose third corner lies on its open edge.
  Mesh m = cube();
  m.positions.push_back(Vector3(0.5, 0, 0));
  m.triangles[0] = {0, 2, 8};  // the bottom with a vertex on an edge
  m.triangles.push_back({8, 2, 1});
  const repair::Repaired r = repaired(m);
  CHECK(r.report.certificate.is_solid());
  CHECK(r.report.t_junctions.splits == 1);
  CHECK(r.report.holes.filled == 0);
  CHECK(r.report.certificate.volume == doctest::Approx(1).epsilon(1e-15));
  CHECK(r.surface.triangles.size() == 14);
}

TEST_CASE("Several vertices on one edge, and on several edges of one triangle, split it") {
  Mesh m = cube();
  const Mesh whole = m;
  // Neighbors of the triangle 0, 2, 1 get vertices on the edges that they share with it.
  const auto split = [&](std::size_t triangle, Index a, Index b, double along) {
    const Triangle t = m.triangles[triangle];
    const Index c = t[0] != a && t[0] != b ? t[0] : t[1] != a && t[1] != b ? t[1] : t[2];
    const auto v = static_cast<Index>(m.positions.size());
    m.positions.push_back(m.positions[a] + along * (m.positions[b] - m.positions[a]));
    m.triangles[triangle] = {b, a, c};
    m.triangles[triangle] = {v, a, c};
    m.triangles.push_back({b, v, c});
    return m.triangles.size() - 1;
  };
  const std::size_t rest = split(4, 0, 1, 0.25);  // face 0 1 4 at edge 0-1
  CHECK(rest == 12);
  split(8, 2, 0, 0.5);  // face 0 4 2 at edge 2-0
  split(1, 1, 2, 0.75);
  const repair::Repaired r = repaired(m);
  CHECK(r.report.certificate.is_solid());
  CHECK(r.report.t_junctions.splits == 3);
  CHECK(r.report.certificate.volume == doctest::Approx(1).epsilon(1e-15));
  CHECK(r.report.certificate.area == doctest::Approx(6).epsilon(1e-15));
  CHECK(whole.triangles.size() + 6 == r.surface.triangles.size());
}

TEST_CASE("Wrong arguments are refused") {
  const Mesh m = cube();
  const auto kind_of = [](const Mesh& mesh, const repair::Options& options) -> std::string {
    try {
      repaired(mesh, options);
    } catch (const base::Error& e) {
      return e.kind();
    }
    return "";
  };
  CHECK(kind_of(m, {.weld_distance = -1}) == "invalid-argument");
  CHECK(kind_of(m, {.weld_distance = std::numeric_limits<double>::quiet_NaN()}) == "invalid-argument");
  CHECK(kind_of(m, {.contact_gap = std::numeric_limits<double>::infinity()}) == "invalid-argument");
  CHECK(kind_of(m, {.sliver_ratio = 0.5}) == "invalid-argument");
  CHECK(kind_of(Mesh(), {}) == "empty-mesh");
  Mesh wrong = m;
  wrong.positions[3][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(kind_of(wrong, {}) == "invalid-argument");
  wrong = m;
  wrong.triangles[2][0] = 8;
  CHECK(kind_of(wrong, {}) == "invalid-argument");
  Mesh point = m;
  for (Vector3& p : point.positions)
    p = Vector3(1, 2, 3);
  CHECK(kind_of(point, {}) == "degenerate-geometry");
}

TEST_CASE("However many near-degenerate triangles are removed, the surface stays within the bound") {
  // A tube of thin strips: each may be collapsed into the next one, and all of them along the circle.
  for (const double max_move : {0.004, 0.012, 0.03}) {
    Mesh m;
    constexpr Index n = 300;
    for (Index i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n;
      for (const double z : {0.0, 1.0})
        m.positions.push_back(Vector3(0.3 * std::cos(a), 0.3 * std::sin(a), z));
    }
    for (Index i = 0; i < n; ++i) {
      const Index a = 2 * i, b = a + 1, c = 2 * ((i + 1) % n), d = c + 1;
      m.triangles.push_back({a, c, b});
      m.triangles.push_back({b, c, d});
    }
    const repair::Repaired r = repaired(m, {.sliver_ratio = 0.02, .sliver_move = max_move});
    CAPTURE(max_move);
    CHECK(r.report.certificate.is_solid());
    CHECK((r.report.slivers.collapsed > 0) == (max_move > 0.0063));
    CHECK(r.report.slivers.largest_move <= max_move);
    CHECK(r.report.move.from_input <= max_move);
    CHECK(r.report.move.from_result <= max_move);
    // The figures are no larger than what was allowed, and no smaller than what is measured.
    CHECK(std::max(r.report.move.from_input, r.report.move.from_result) <= r.report.slivers.largest_move);
  }
}
