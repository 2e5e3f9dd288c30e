// Handles and tunnels cut along the shortest loops that do not separate the surface.
#include "repair/handles/handles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "damage.h"
#include "repair/handles/homology.h"
#include "repair/handles/shortest_loop.h"

using namespace orbicube;
using namespace orbicube::test;

namespace {

// A torus of n by m quads, around z.
Mesh torus(Index n, Index m, double radius, double tube) {
  Mesh t;
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < m; ++k) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * k / m;
      const double r = radius + tube * std::cos(b);
      t.positions.push_back(Vector3(r * std::cos(a), r * std::sin(a), tube * std::sin(b)));
    }
  }
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < m; ++k) {
      const Index a = i * m + k, b = (i + 1) % n * m + k, c = (i + 1) % n * m + (k + 1) % m, d = i * m + (k + 1) % m;
      t.triangles.push_back({a, b, c});
      t.triangles.push_back({a, c, d});
    }
  }
  return t;
}

repair::EdgeLoop shortest_of(const Mesh& m, double limit = 1e300) {
  const base::Host host;
  const repair::Soup soup = repair::soup_of(m.positions, m.triangles, host);
  const mesh::Connectivity connectivity(soup.positions.size(), soup.triangles, host);
  const repair::Homology homology = repair::homology_codes(soup, connectivity, host);
  return repair::shortest_loop(soup, connectivity, homology.codes, limit, host);
}

}  // namespace

TEST_CASE("The shortest loop of a torus is its tube's, or the one through its hole if that is shorter") {
  // The circle of the tube is a polygon of 12, that of the hole one of 40.
  const repair::EdgeLoop around = shortest_of(torus(40, 12, 3, 0.5));
  CHECK(around.vertices.size() == 12);
  CHECK(around.length == doctest::Approx(12 * 2 * 0.5 * std::sin(std::numbers::pi / 12)).epsilon(1e-12));
  const repair::EdgeLoop through = shortest_of(torus(20, 24, 1, 0.8));
  CHECK(through.vertices.size() == 20);
  CHECK(through.length == doctest::Approx(20 * 2 * 0.2 * std::sin(std::numbers::pi / 20)).epsilon(1e-12));
  CHECK(shortest_of(torus(40, 12, 3, 0.5), 3.0).vertices.empty());
  CHECK(shortest_of(mesh::make_shape("sphere", {.triangles = 1000}, base::Host())).vertices.empty());
}

TEST_CASE("The genus is what the codes say, for any number of handles") {
  Mesh m = torus(12, 8, 3, 1);
  for (int i = 1; i < 40; ++i) {
    Mesh other = torus(12, 8, 3, 1);
    for (Vector3& p : other.positions)
      p.x() += 10 * i;
    m = together(m, other);
  }
  const base::Host host;
  const repair::Soup soup = repair::soup_of(m.positions, m.triangles, host);
  const mesh::Connectivity connectivity(soup.positions.size(), soup.triangles, host);
  const repair::Homology homology = repair::homology_codes(soup, connectivity, host);
  CHECK(homology.genus == 40);
  // Around each triangle the codes cancel, so that loops can be moved over it.
  for (Index t = 0; t < soup.triangles.size(); ++t)
    CHECK((homology.codes[3 * t] ^ homology.codes[3 * t + 1] ^ homology.codes[3 * t + 2]) == 0);
}

TEST_CASE("A cut handle and a closed tunnel make a sphere, without self-intersection") {
  for (const Mesh& m : {torus(40, 12, 3, 0.5), torus(20, 24, 1, 0.8)}) {
    const repair::Repaired r = repaired(m, {.handles = {.max_genus = 0}});
    CHECK(r.report.handles.cut == 1);
    CHECK(r.report.certificate.is_solid());
    CHECK(r.report.certificate.genus == 0);
    CHECK(r.report.certificate.parts == 1);
    CHECK(r.report.certificate.self_intersections == 0);
    CHECK(r.report.certificate.volume > 0);
    REQUIRE(r.events.size() == 1);
    CHECK(r.events[0].action == repair::Action::cut_handle);
    CHECK(r.events[0].size == doctest::Approx(r.report.handles.longest));
    CHECK(r.report.handles.largest_move < 0.2);
  }
  // Around the tube the place is on its axis.
  const repair::Repaired r = repaired(torus(40, 12, 3, 0.5), {.handles = {.max_genus = 0}});
  CHECK(r.events[0].place.norm() == doctest::Approx(3).epsilon(0.05));
}

TEST_CASE("Only handles of loops up to the limit are cut, the shortest first, down to the genus") {
  Mesh m = mesh::make_shape("bracket", {.triangles = 4000}, base::Host());
  const std::int64_t genus = repaired(m).report.certificate.genus;
  REQUIRE(genus > 1);
  const double shortest = shortest_of(m).length;
  CHECK(!repaired(m, {.handles = {.max_length = 0.9 * shortest}}).report.changed);
  const repair::Repaired one = repaired(m, {.handles = {.max_genus = genus - 1}});
  CHECK(one.report.handles.cut == 1);
  CHECK(one.report.handles.longest == doctest::Approx(shortest));
  CHECK(one.report.certificate.genus == genus - 1);
  const repair::Repaired none = repaired(m, {.handles = {.max_genus = 0}});
  CHECK(none.report.certificate.is_solid());
  CHECK(none.report.certificate.genus == 0);
  CHECK(none.report.certificate.self_intersections == 0);
  CHECK(static_cast<std::int64_t>(none.report.handles.cut) == genus);
  for (std::size_t i = 1; i < none.events.size(); ++i)
    CHECK(none.events[i].size > 0);
}

TEST_CASE("Topological noise on a sphere is cut, and the rest of the surface stays") {
  // Thin bridges: tubes of three sides between pairs of triangles of a sphere and a second one within it.
  Mesh m = mesh::make_shape("sphere", {.triangles = 1200}, base::Host());
  const std::size_t triangles = m.triangles.size();
  std::vector<std::array<std::size_t, 2>> pairs;
  const auto centroid_of = [&](const Triangle& t) {
    return Vector3((m.positions[t[0]] + m.positions[t[1]] + m.positions[t[2]]) / 3);
  };
  for (const std::size_t from : {10U, 300U, 700U}) {
    std::size_t best = from;
    for (std::size_t t = 0; t < triangles; ++t) {
      const double distance = (centroid_of(m.triangles[t]) - centroid_of(m.triangles[from])).norm();
      const double target = 0.5 * m.positions[0].norm();
      if (std::abs(distance - target) <
          std::abs((centroid_of(m.triangles[best]) - centroid_of(m.triangles[from])).norm() - target))
        best = t;
    }
    pairs.push_back({from, best});
  }
  std::vector<std::uint8_t> gone(triangles, 0);
  for (const auto& [s, t] : pairs) {
    gone[s] = gone[t] = 1;
    const Triangle a = m.triangles[s], b = m.triangles[t];
    // The rotation of b for which the tube is least twisted.
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t shift = 0; shift < 3; ++shift) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += (m.positions[a[k]] - m.positions[b[(shift + 3 - k) % 3]]).squaredNorm();
      if (sum < least) least = sum, best = shift;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Index p = a[k], q = a[(k + 1) % 3], r = b[(best + 3 - k) % 3], s2 = b[(best + 2 - k) % 3];
      m.triangles.push_back({p, q, s2});
      m.triangles.push_back({p, s2, r});
    }
  }
  std::size_t t = 0;
  std::erase_if(m.triangles, [&](const Triangle&) { return t < gone.size() && gone[t++] != 0; });
  const repair::Repaired noisy = repaired(m);
  REQUIRE(noisy.report.certificate.genus == 3);
  const repair::Repaired r = repaired(m, {.handles = {.max_length = 1}});
  CHECK(r.report.certificate.is_solid());
  CHECK(r.report.certificate.genus == 0);
  CHECK(r.report.handles.cut == 3);
}
