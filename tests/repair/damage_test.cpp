// Damaged surfaces come out closed, oriented and manifold, and are as they were where nothing was damaged.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "damage.h"

using namespace orbicube;
using namespace orbicube::test;

namespace {

void check_solid(const repair::Repaired& r, std::int64_t genus) {
  const repair::Certificate& c = r.report.certificate;
  CHECK(repair::shortcomings(c) == "");
  CHECK(c.is_solid());
  CHECK(c.parts == 1);
  CHECK(c.genus == genus);
  CHECK(c.volume > 0);
}

}  // namespace

TEST_CASE("Random damage of all kinds is repaired, and nothing moves") {
  for (const char* shape : {"sphere", "torus"}) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      CAPTURE(shape);
      CAPTURE(seed);
      Mesh m = mesh::make_shape(shape, {.triangles = 1500}, base::Host());
      base::Random random(seed);
      add_slivers(m, 10, 1e-9, random);
      add_holes(m, 5, random);
      flip_some(m, 30, random);
      add_t_junctions(m, 5, random);
      tear(m, 30, 0, random);
      tear(m, 30, 1e-8, random);
      add_specks(m, 4, random);
      m.triangles.push_back(m.triangles[7]);
      m.triangles.push_back({3, 3, 9});
      const repair::Repaired r = repaired(m);
      check_solid(r, shape[0] == 't' ? 1 : 0);
      CHECK(r.report.parts.dropped_triangles >= 48);
      CHECK(std::max(r.report.move.from_input, r.report.move.from_result) < 1e-7);
      // Vertices keep their bits, but for those of patches.
      for (std::size_t v = 0; v < r.surface.positions.size(); ++v) {
        if (r.surface.vertex_source[v] != mesh::no_index)
          CHECK(r.surface.positions[v] == m.positions[r.surface.vertex_source[v]]);
      }
    }
  }
}

TEST_CASE("Away from the damage the triangles are those of the input") {
  Mesh m = mesh::make_shape("torus", {.triangles = 4000}, base::Host());
  base::Random random(11);
  const Mesh clean = m;
  add_holes(m, 3, random);
  const repair::Repaired r = repaired(m);
  check_solid(r, 1);
  CHECK(r.report.move.from_input == 0);
  CHECK(r.report.move.from_result == 0);
  std::set<std::array<double, 3>> before;
  for (const Triangle& t : m.triangles) {
    const Vector3 sum = m.positions[t[0]] + m.positions[t[1]] + m.positions[t[2]];
    before.insert({sum[0], sum[1], sum[2]});
  }
  std::size_t same = 0;
  for (const Triangle& t : r.surface.triangles) {
    const Vector3 sum = r.surface.positions[t[0]] + r.surface.positions[t[1]] + r.surface.positions[t[2]];
    same += before.count({sum[0], sum[1], sum[2]});
  }
  CHECK(same == m.triangles.size());
}

TEST_CASE("A repaired surface is clean: a second repair changes nothing") {
  Mesh m = mesh::make_shape("sphere", {.triangles = 1500}, base::Host());
  base::Random random(4);
  add_slivers(m, 10, 1e-9, random);
  add_holes(m, 5, random);
  add_t_junctions(m, 5, random);
  const repair::Repaired r = repaired(m);
  const repair::Repaired again = repair::repair(r.surface.positions, r.surface.triangles, {}, base::Host());
  CHECK(!again.report.changed);
}

TEST_CASE("The result is the same bits for any number of threads") {
  Mesh m = mesh::make_shape("creature", {.triangles = 3000}, base::Host());
  base::Random random(6);
  add_holes(m, 20, random);
  tear(m, 50, 1e-9, random);
  base::Host one, three;
  one.thread_count = 1;
  three.thread_count = 3;
  const repair::Repaired a = repair::repair(m.positions, m.triangles, {}, one);
  const repair::Repaired b = repair::repair(m.positions, m.triangles, {}, three);
  CHECK(a.surface.positions == b.surface.positions);
  CHECK(a.surface.triangles == b.surface.triangles);
}
