// Orientation, contacts and parts.
#include <doctest/doctest.h>

#include <algorithm>

#include "damage.h"

using namespace orbicube;
using namespace orbicube::test;

TEST_CASE("Cubes that share an edge or a vertex are separated") {
  for (const Vector3& at : {Vector3(1, 1, 0), Vector3(1, 1, 1)}) {
    Mesh m = together(cube(), cube(at));
    weld_all(m);
    repair::Options options;
    options.parts.keep = 0;
    const repair::Repaired r = repaired(m, options);
    CHECK(r.report.certificate.is_solid());
    CHECK(r.report.certificate.parts == 2);
    CHECK(r.report.certificate.volume == doctest::Approx(2).epsilon(1e-15));
    CHECK(r.report.contacts.edges == (at[2] > 0 ? 0 : 1));
    CHECK(r.report.contacts.added_vertices == (at[2] > 0 ? 1 : 2));
    CHECK(r.report.certificate.self_intersections > 0);  // they touch
    options.contact_gap = 1e-6;
    const repair::Repaired apart = repaired(m, options);
    CHECK(apart.report.certificate.is_solid());
    CHECK(apart.report.certificate.self_intersections == 0);
    CHECK(apart.report.certificate.volume == doctest::Approx(2).epsilon(1e-5));
    CHECK(std::max(apart.report.move.from_input, apart.report.move.from_result) <= 1e-6 * (1 + 1e-9));
    // One part alone.
    const repair::Repaired one = repaired(m);
    CHECK(one.report.certificate.parts == 1);
    CHECK(one.surface.triangles.size() == 12);
    CHECK(one.report.parts.dropped_area_percent == doctest::Approx(50));
  }
}

TEST_CASE("A ring of voxels that touches itself along an edge is manifold afterwards, in one part") {
  // Cells of a grid with one diagonal contact that other cells connect.
  Mesh m;
  const std::vector<std::array<int, 3>> cells = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                                 {0, 1, 1}, {0, 0, 1}, {1, 1, 1}, {2, 1, 1}};
  const auto has = [&](int x, int y, int z) {
    return std::find(cells.begin(), cells.end(), std::array{x, y, z}) != cells.end();
  };
  for (const auto& c : cells) {
    const Mesh one = cube(Vector3(c[0], c[1], c[2]));
    // The sides by axis: -z, +z, -y, +y, -x, +x.
    const std::array<std::array<int, 3>, 6> sides = {
        {{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}}};
    for (std::size_t s = 0; s < 6; ++s) {
      if (has(c[0] + sides[s][0], c[1] + sides[s][1], c[2] + sides[s][2])) continue;
      Mesh side = one;
      side.triangles = {one.triangles[2 * s], one.triangles[2 * s + 1]};
      m = together(m, side);
    }
  }
  weld_all(m);
  const repair::Repaired r = repaired(m);
  CHECK(r.report.contacts.edges > 0);
  CHECK(r.report.certificate.is_solid());
  CHECK(r.report.certificate.parts == 1);
  CHECK(r.report.certificate.volume == doctest::Approx(static_cast<double>(cells.size())).epsilon(1e-14));
  repair::Options options;
  options.contact_gap = 1e-3;
  CHECK(repaired(m, options).report.certificate.self_intersections == 0);
}

TEST_CASE("A face that stands on an edge of a closed surface is separated and dropped") {
  Mesh m = cube();
  m.positions.push_back(Vector3(2, 2, 2));
  m.triangles.push_back({1, 3, 8});
  const repair::Repaired r = repaired(m);
  CHECK(r.report.certificate.is_solid());
  CHECK(r.surface.triangles == cube().triangles);
  CHECK(r.surface.positions == cube().positions);
  CHECK(r.report.parts.dropped_triangles == 1);
}

TEST_CASE("Faces are turned to agree with the most, and outward") {
  Mesh m = mesh::make_shape("torus", {.triangles = 1000}, base::Host());
  const Mesh clean = m;
  base::Random random(2);
  flip_some(m, 100, random);
  const repair::Repaired r = repaired(m);
  CHECK(r.report.certificate.is_solid());
  CHECK(r.report.certificate.volume > 0);
  CHECK(r.report.reversed_triangles <= 100);
  CHECK(r.report.reversed_triangles > 50);
  CHECK(r.report.move.from_input == 0);
  CHECK(r.report.move.from_result == 0);
  for (Triangle& t : m.triangles)
    std::swap(t[1], t[2]);
  const repair::Repaired all = repaired(m);
  CHECK(all.report.certificate.volume == doctest::Approx(r.report.certificate.volume).epsilon(1e-14));
}

TEST_CASE("A Moebius strip is reported as one-sided and stays") {
  Mesh m;
  const Index n = 12;
  for (Index i = 0; i < n; ++i) {
    const double a = 2 * 3.14159265358979 * i / n;
    for (const double side : {-0.3, 0.3}) {
      const double r = 1 + side * std::cos(a / 2);
      m.positions.push_back(Vector3(r * std::cos(a), r * std::sin(a), side * std::sin(a / 2)));
    }
  }
  for (Index i = 0; i < n; ++i) {
    Index a = 2 * i, b = 2 * i + 1, c = 2 * ((i + 1) % n), d = c + 1;
    if (i + 1 == n) std::swap(c, d);
    m.triangles.push_back({a, c, b});
    m.triangles.push_back({b, c, d});
  }
  const repair::Repaired r = repaired(m);
  CHECK(!r.report.orientable);
  CHECK(!r.report.certificate.oriented);
  CHECK(!repair::shortcomings(r.report.certificate).empty());
}

TEST_CASE("Parts that cross are not inside each other, those that touch can be") {
  const repair::PartOptions all{.keep = 0}, with_cavities{.keep = 0, .cavities = true};
  const Mesh sphere = mesh::make_shape("sphere", {.triangles = 1000}, base::Host());
  Mesh moved = sphere;
  // Any triangle may be the first of its part, in the other part or not.
  for (const double shift : {-0.5, 0.5}) {
    for (std::size_t v = 0; v < moved.positions.size(); ++v)
      moved.positions[v] = sphere.positions[v] + shift * Vector3(1, 0.1, 0.2);
    const Mesh two = together(sphere, moved);
    for (const repair::PartOptions& parts : {all, with_cavities}) {
      const repair::Repaired r = repaired(two, {.parts = parts});
      CHECK(r.report.certificate.parts == 2);
      CHECK(r.report.certificate.self_intersections > 0);
      CHECK(r.report.parts.cavities == 0);
      CHECK(!r.report.changed);
    }
  }
  // Cubes with sides in common planes, one through the other, and one in a corner of the other.
  const Mesh through = together(cube(), cube({0.5, 0, 0}));
  CHECK(!repaired(through, {.parts = all}).report.changed);
  const Mesh corner = together(cube(Vector3::Zero(), 4), cube(Vector3::Zero(), 2));
  CHECK(repaired(corner, {.parts = all}).report.certificate.volume == doctest::Approx(64));
  CHECK(repaired(corner, {.parts = with_cavities}).report.parts.cavities == 1);
  // A part and its copy, of vertices of its own.
  CHECK(repaired(together(sphere, sphere), {.parts = all}).report.certificate.parts == 2);
}

TEST_CASE("The largest parts are kept, cavities where requested") {
  Mesh m = together(together(cube(Vector3::Zero(), 4), cube({1, 1, 1}, 2)), cube({6, 0, 0}, 1));
  m = together(m, cube({1.5, 1.5, 1.5}, 1));  // inside of the cavity
  const repair::Repaired one = repaired(m);
  CHECK(one.report.parts.found == 4);
  CHECK(one.report.certificate.volume == doctest::Approx(64));
  const repair::Repaired outer = repaired(m, {.parts = {.keep = 0}});
  CHECK(outer.report.certificate.parts == 2);
  CHECK(outer.report.certificate.volume == doctest::Approx(65));
  const repair::Repaired all = repaired(m, {.parts = {.keep = 0, .cavities = true}});
  CHECK(all.report.certificate.parts == 4);
  CHECK(all.report.parts.cavities == 1);
  CHECK(all.report.certificate.volume == doctest::Approx(64 - 8 + 1 + 1));
  // With the cavity's walls inward already, nothing changes.
  Mesh oriented = m;
  for (std::size_t t = 12; t < 24; ++t)
    std::swap(oriented.triangles[t][1], oriented.triangles[t][2]);
  CHECK(!repaired(oriented, {.parts = {.keep = 0, .cavities = true}}).report.changed);
  const repair::Repaired large = repaired(m, {.parts = {.keep = 0, .min_area_percent = 10, .cavities = true}});
  CHECK(large.report.certificate.parts == 2);
  CHECK(repaired(m, {.parts = {.keep = 2, .cavities = true}}).report.certificate.parts == 2);
}
