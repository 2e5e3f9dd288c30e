// The certificate against polycubes with known corners and faces, and against maps that are wrong in one way each.
#include "polycube/map/certificate.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/error.h"
#include "blocks.h"
#include "mesh/search/intersections.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::blocks;
using test::box_without;
using test::host;

namespace {

Certificate certificate_of(const mesh::Mesh& m) {
  return certify(m.positions, m.triangles, host);
}

bool mentions(const Certificate& c, const char* words) {
  return c.reason.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("Polycubes made of cells have the corners, faces and genus that they must have") {
  struct Expected {
    std::vector<test::Cell> cells;
    std::size_t corners, patches;
    std::int64_t genus;
  };
  const std::vector<Expected> all = {
      {box_without({1, 1, 1}), 8, 6, 0},
      {box_without({3, 2, 4}), 8, 6, 0},
      {box_without({2, 2, 1}, {{1, 1, 0}}), 12, 8, 0},              // an L
      {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 1}}, 16, 10, 0},    // a T: the bump spans the bar's width
      {box_without({3, 3, 1}, {{1, 1, 0}}), 16, 10, 1},             // a hole
      {box_without({5, 3, 1}, {{1, 1, 0}, {3, 1, 0}}), 24, 14, 2},  // two holes
      {box_without({2, 2, 2}, {{1, 1, 1}}), 14, 9, 0},              // a notch in a corner
      {box_without({3, 3, 2}, {{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {0, 1, 1}, {2, 1, 1}, {0, 2, 1}, {1, 2, 1}, {2, 2, 1}}),
       16, 11, 0},  // a bump in the middle of a face
  };
  for (const Expected& e : all) {
    const Certificate c = certificate_of(blocks(e.cells));
    INFO(c.reason);
    CHECK(c.valid());
    CHECK(c.corners == e.corners);
    CHECK(c.patch_count == e.patches);
    CHECK(c.genus == e.genus);
  }
}

TEST_CASE("Labels are the directions that triangles look in, and patches are connected in one plane") {
  const mesh::Mesh m = blocks(box_without({3, 3, 1}, {{1, 1, 0}}));
  const Certificate c = certificate_of(m);
  REQUIRE(c.valid());
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const auto& [a, b, d] = m.triangles[i];
    const Vector3 normal = (m.positions[b] - m.positions[a]).cross(m.positions[d] - m.positions[a]);
    CHECK(normal == direction_of(c.labels[i]) * normal.norm());
    for (std::size_t j = 0; j < i; ++j) {
      if (c.patches[i] != c.patches[j]) continue;
      CHECK(c.labels[i] == c.labels[j]);
      const int axis = axis_of(c.labels[i]);
      CHECK(m.positions[a][axis] == m.positions[m.triangles[j][0]][axis]);
    }
  }
}

TEST_CASE("A vertex that is off by the last bit is refused") {
  mesh::Mesh m = blocks(box_without({2, 2, 2}));
  for (Vector3& p : m.positions) {
    if (p == Vector3(1, 1, 2)) p.z() = std::nextafter(2.0, 3.0);
  }
  CHECK(mentions(certificate_of(m), "axis-aligned"));
}

TEST_CASE("A triangle that is flipped within its plane, or has no area, is refused") {
  for (const double x : {2.5, 2.0}) {
    mesh::Mesh m = blocks(box_without({2, 2, 2}));
    for (Vector3& p : m.positions) {
      if (p == Vector3(1, 1, 2)) p.x() = x;
    }
    CHECK(!certificate_of(m).valid());
  }
}

TEST_CASE("A polycube that touches or crosses itself is refused") {
  // A C whose upper arm has a prong at its end, which reaches towards the lower arm.
  const std::vector<test::Cell> cells = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3},
                                         {0, 0, 4}, {1, 0, 4}, {2, 0, 4}, {2, 0, 3}, {2, 0, 2}};
  for (const double shift : {0.5, 1.0, 1.5}) {  // apart, touching, crossing
    mesh::Mesh m = blocks(cells);
    for (Vector3& p : m.positions) {
      if (p.x() >= 2 && p.z() == 2) p.z() -= shift;  // the end of the prong
    }
    const Certificate c = certificate_of(m);
    INFO(shift, " ", c.reason);
    CHECK(c.valid() == (shift < 1));
  }
}

TEST_CASE("Polycubes meet themselves just when two of their triangles do") {
  std::mt19937_64 random(5);
  const auto number = [&](std::uint64_t count) { return static_cast<std::size_t>(random() % count); };
  int apart = 0, meeting = 0;
  for (int i = 0; i < 400; ++i) {
    // Cells that have grown at random; then one face, with what hangs on it, goes to another plane.
    std::vector<test::Cell> cells = {{0, 0, 0}};
    while (cells.size() < 14) {
      test::Cell next = cells[number(cells.size())];
      next[number(3)] += number(2) == 0 ? 1 : -1;
      if (std::find(cells.begin(), cells.end(), next) == cells.end()) cells.push_back(next);
    }
    mesh::Mesh m = blocks(cells);
    const Certificate before = certificate_of(m);
    if (!before.valid()) continue;
    CHECK(mesh::intersecting_triangles(m.positions, m.triangles, host, 1).empty());
    const auto patch = static_cast<Index>(number(before.patch_count));
    const double shift = 0.5 * static_cast<double>(1 + number(6)) * (number(2) == 0 ? 1 : -1);
    std::vector<std::uint8_t> moves(m.positions.size(), 0);
    int axis = 0;
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
      if (before.patches[t] != patch) continue;
      axis = axis_of(before.labels[t]);
      for (const Index v : m.triangles[t])
        moves[v] = 1;
    }
    for (std::size_t v = 0; v < moves.size(); ++v)
      if (moves[v] != 0) m.positions[v][axis] += shift;
    const Certificate after = certificate_of(m);
    if (!after.valid() && !mentions(after, "meets itself")) continue;  // a triangle is flipped
    CHECK(after.valid() == mesh::intersecting_triangles(m.positions, m.triangles, host, 1).empty());
    (after.valid() ? apart : meeting) += 1;
  }
  CHECK(apart > 20);
  CHECK(meeting > 20);
}

TEST_CASE("An inside-out polycube is refused") {
  mesh::Mesh m = blocks(box_without({2, 1, 1}));
  for (Triangle& t : m.triangles)
    std::swap(t[1], t[2]);
  CHECK(mentions(certificate_of(m), "inward-oriented"));
}

TEST_CASE("Surfaces that are open, in parts or not manifold are refused") {
  mesh::Mesh open = blocks(box_without({1, 1, 1}));
  open.triangles.pop_back();
  CHECK(mentions(certificate_of(open), "not-closed"));
  CHECK(mentions(certificate_of(blocks({{0, 0, 0}, {5, 0, 0}})), "components"));
  CHECK(!certificate_of(blocks({{0, 0, 0}, {1, 1, 0}})).valid());  // cubes that share an edge
  mesh::Mesh wild = blocks(box_without({1, 1, 1}));
  wild.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(certificate_of(wild), base::Error);
}

TEST_CASE("Cavities are parts that are inward-oriented within the one that is outward-oriented, and touch nothing") {
  // Cubes of length `size` from `low` on, each outward-oriented or into itself.
  struct Cube {
    double low, size;
    bool inward;
  };
  const auto cubes = [](const std::vector<Cube>& all) {
    mesh::Mesh m;
    for (const Cube& cube : all) {
      const mesh::Mesh one = blocks(box_without({1, 1, 1}));
      const auto first = static_cast<Index>(m.positions.size());
      for (const Vector3& p : one.positions)
        m.positions.push_back(Vector3::Constant(cube.low) + cube.size * p);
      for (Triangle t : one.triangles) {
        for (Index& v : t)
          v += first;
        if (cube.inward) std::swap(t[1], t[2]);
        m.triangles.push_back(t);
      }
    }
    return certificate_of(m);
  };
  const Certificate hollow = cubes({{0, 9, false}, {1, 2, true}, {4, 3, true}});
  INFO(hollow.reason);
  CHECK(hollow.valid());
  CHECK(hollow.cavities == 2);
  CHECK(hollow.genus == 0);
  CHECK(hollow.corners == 24);
  CHECK(hollow.patch_count == 18);
  CHECK(certificate_of(blocks(box_without({3, 3, 3}, {{1, 1, 1}}))).cavities == 1);
  CHECK(mentions(cubes({{0, 9, false}, {1, 2, false}}), "2 components are outward-oriented"));
  CHECK(mentions(cubes({{0, 9, true}, {1, 2, true}}), "inward-oriented"));
  CHECK(mentions(cubes({{0, 9, false}, {10, 2, true}}), "inside or outside already"));
  CHECK(mentions(cubes({{0, 9, false}, {1, 6, true}, {2, 1, true}}), "inside or outside already"));
  CHECK(mentions(cubes({{0, 9, true}, {1, 2, false}}), "inside or outside already"));
  CHECK(mentions(cubes({{0, 9, false}, {7, 2, true}}), "meets itself"));
  CHECK(mentions(cubes({{0, 9, false}, {8, 2, true}}), "meets itself"));
}

TEST_CASE("A double cover of a cube's surface is refused") {
  // A branched cover: a square tube around twice, closed by caps whose centers the triangles go around twice.
  mesh::Mesh m;
  const std::array<std::array<double, 2>, 4> square = {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
  for (const double z : {0.0, 2.0}) {
    for (std::size_t i = 0; i < 8; ++i)
      m.positions.emplace_back(square[i % 4][0], square[i % 4][1], z);
  }
  m.positions.emplace_back(1, 1, 0);
  m.positions.emplace_back(1, 1, 2);
  for (Index i = 0; i < 8; ++i) {
    const Index j = (i + 1) % 8;
    m.triangles.push_back({i, j, j + 8});
    m.triangles.push_back({i, j + 8, i + 8});
    m.triangles.push_back({j, i, 16});
    m.triangles.push_back({i + 8, j + 8, 17});
  }
  CHECK(mentions(certificate_of(m), "turn by 16 eighths"));
}
