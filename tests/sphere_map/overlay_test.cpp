// One triangulation with the vertices of several maps.
#include "sphere_map/correspondence/overlay.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <vector>

#include "base/error.h"
#include "mesh/search/bounding_volume_tree.h"
#include "mesh/search/distances.h"
#include "mesh/topology/topology.h"
#include "shapes.h"
#include "sphere_map/correspondence/correspondence.h"
#include "uneven_maps.h"

using namespace orbicube;
using mesh::Index;
using mesh::Vector3;
using sphere_map::Overlay;
using sphere_map::PlacedMap;

namespace {

void check_valid(const Overlay& o) {
  const mesh::Topology facts = mesh::topology(o.directions, o.triangles, base::Host());
  CHECK_NOTHROW(mesh::require_closed_genus_zero(facts));
  CHECK(sphere_map::count_not_positive(o.triangles, o.directions) == 0);
  CHECK_NOTHROW(sphere_map::Locator(o.triangles, o.directions, base::Host()));  // covers the sphere once
}

std::set<std::pair<Index, Index>> edges_of(std::span<const mesh::Triangle> triangles) {
  std::set<std::pair<Index, Index>> edges;
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  return edges;
}

}  // namespace

TEST_CASE("An overlay has the vertices of all maps, is a positive sphere, and keeps the first surface as it is") {
  const test::MappedShape a = test::mapped("creature", 2500);
  const test::MappedShape b = test::mapped("star", 3500);
  const test::MappedShape c = test::mapped("blob", 1500);
  const std::vector<PlacedMap> others{{b.directions, b.surface.triangles}, {c.directions, c.surface.triangles}};
  const Overlay o = sphere_map::overlay({a.directions, a.surface.triangles}, others, base::Host());
  check_valid(o);
  CHECK(o.directions.size() == a.directions.size() + b.directions.size() + c.directions.size());
  for (std::size_t v = 0; v < a.directions.size(); ++v)
    CHECK(o.directions[v] == a.directions[v]);
  for (std::size_t i = 0; i < 2; ++i) {
    REQUIRE(o.vertex_of[i].size() == others[i].directions.size());
    for (std::size_t v = 0; v < o.vertex_of[i].size(); ++v)
      CHECK(o.directions[o.vertex_of[i][v]] == others[i].directions[v]);
  }
  // Edges of the others that lie inside of one triangle of the first are there, by flips; many are not.
  CHECK(o.edges_present > 0);
  CHECK(o.edges_present <= o.edges_of_others);

  const sphere_map::Locator locator(a.surface.triangles, a.directions, base::Host());
  const auto carried = sphere_map::carry_over(locator, a.surface.positions, sphere_map::Alignment(), o.directions,
                                              o.triangles, {}, base::Host());
  CHECK(carried.flipped == 0);
  const auto d =
      mesh::surface_distance(a.surface.positions, a.surface.triangles, carried.positions, o.triangles, base::Host());
  CHECK(d.from_first.largest < 1e-12);
  CHECK(d.from_second.largest < 1e-12);
}

TEST_CASE("Refinement brings the other shape as near as is requested and leaves the first as it is") {
  const test::MappedShape a = test::mapped("blob", 1000);
  const test::MappedShape b = test::mapped("star", 2500);
  const sphere_map::Locator locator_a(a.surface.triangles, a.directions, base::Host());
  const sphere_map::Locator locator_b(b.surface.triangles, b.directions, base::Host());
  const sphere_map::Alignment still;
  const std::vector<sphere_map::EdgeError::Shape> shapes{{&locator_b, b.surface.positions, &still}};
  const std::vector<PlacedMap> others{{b.directions, b.surface.triangles}};
  const auto distances = [&](double tolerance, std::size_t most) {
    const sphere_map::EdgeError error(shapes, tolerance);
    const sphere_map::Refinement refinement{error, most};
    const Overlay o = sphere_map::overlay({a.directions, a.surface.triangles}, others, base::Host(), &refinement);
    check_valid(o);
    CHECK(o.directions.size() <= most);
    const auto of_a =
        sphere_map::carry_over(locator_a, a.surface.positions, still, o.directions, o.triangles, {}, base::Host());
    const auto of_b =
        sphere_map::carry_over(locator_b, b.surface.positions, still, o.directions, o.triangles, {}, base::Host());
    const auto d =
        mesh::surface_distance(a.surface.positions, a.surface.triangles, of_a.positions, o.triangles, base::Host());
    CHECK(d.from_first.largest < 1e-12);
    CHECK(d.from_second.largest < 1e-12);
    return mesh::surface_distance(b.surface.positions, b.surface.triangles, of_b.positions, o.triangles, base::Host());
  };
  const std::size_t vertices = a.directions.size() + b.directions.size();
  mesh::Box box;
  for (const Vector3& p : b.surface.positions)
    box.add(p);
  const double diagonal = (box.high - box.low).norm();
  const auto none = distances(1, vertices);
  const auto fine = distances(0.002, 10 * vertices);
  CHECK(fine.from_first.root_mean_square < 0.3 * none.from_first.root_mean_square);
  // Edges are looked at in three points, so that a little more may be missed between them.
  CHECK(fine.from_first.root_mean_square < 0.002 * diagonal);
  CHECK(fine.from_first.largest < 0.01 * diagonal);
}

TEST_CASE("A map over itself is itself") {
  const test::MappedShape a = test::mapped("blob", 1200);
  const std::vector<PlacedMap> others{{a.directions, a.surface.triangles}};
  const Overlay o = sphere_map::overlay(others[0], others, base::Host());
  CHECK(o.directions.size() == a.directions.size());
  CHECK(std::equal(o.triangles.begin(), o.triangles.end(), a.surface.triangles.begin(), a.surface.triangles.end()));
  CHECK(o.edges_present == o.edges_of_others);
}

TEST_CASE("Vertices exactly on edges cut them, and a finer map of the same triangles is found again edge by edge") {
  // On the planes of coordinates signs are exactly 0: the octahedron's edges are cut in the middle.
  const test::Surface coarse = test::sphere(0), fine = test::sphere(1);
  const std::vector<PlacedMap> others{{fine.positions, fine.triangles}};
  const Overlay o = sphere_map::overlay({coarse.positions, coarse.triangles}, others, base::Host());
  check_valid(o);
  CHECK(o.directions.size() == fine.positions.size());
  CHECK(o.edges_present == o.edges_of_others);
  auto renamed = fine.triangles;
  for (auto& t : renamed) {
    for (Index& v : t)
      v = o.vertex_of[0][v];
  }
  CHECK(edges_of(renamed) == edges_of(o.triangles));
}

TEST_CASE("Vertices very near to each other, to edges and to vertices are inserted all the same") {
  const test::Surface coarse = test::sphere(1);
  std::mt19937_64 random(8);
  std::uniform_int_distribution<int> exponent(-52, -2);
  std::vector<Vector3> directions;
  std::vector<mesh::Triangle> triangles;
  for (Index i = 0; i < 300; ++i) {
    const mesh::Triangle& t = coarse.triangles[random() % coarse.triangles.size()];
    const double weight = std::ldexp(1, exponent(random));
    const Vector3 &p = coarse.positions[t[0]], &q = coarse.positions[t[1]], &r = coarse.positions[t[2]];
    directions.push_back((p + (i % 3 == 0 ? weight : 0.4) * (q - p) + weight * (r - p)).normalized());
    if (i % 3 == 2) triangles.push_back({i - 2, i - 1, i});
  }
  const std::vector<PlacedMap> others{{directions, triangles}};
  const Overlay o = sphere_map::overlay({coarse.positions, coarse.triangles}, others, base::Host());
  check_valid(o);
  for (std::size_t v = 0; v < directions.size(); ++v)
    CHECK((o.directions[o.vertex_of[0][v]] - directions[v]).norm() == 0);
}

TEST_CASE("Maps that are none are refused") {
  const test::Surface good = test::sphere(1);
  std::vector<mesh::Triangle> mirrored = good.triangles;
  for (auto& t : mirrored)
    std::swap(t[0], t[1]);
  const auto with = [&](std::span<const Vector3> directions, std::span<const mesh::Triangle> triangles) {
    const std::vector<PlacedMap> others{{directions, triangles}};
    return sphere_map::overlay({good.positions, good.triangles}, others, base::Host());
  };
  CHECK_THROWS_AS(sphere_map::overlay({good.positions, mirrored}, {}, base::Host()), base::Error);
  CHECK_NOTHROW(with(good.positions, good.triangles));
  const std::vector<mesh::Triangle> beyond{{0, 1, 1000}};
  CHECK_THROWS_AS(with(good.positions, beyond), base::Error);
  auto bad = good.positions;
  bad[3] = {0, NAN, 0};
  CHECK_THROWS_AS(with(bad, good.triangles), base::Error);
}
