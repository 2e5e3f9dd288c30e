// Meshes with a boundary that allows positive elements end positive, where needed with splits that keep each element
// and vertex within those of the mesh before.
#include "untangle/refine/refined.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "feasible_flat.h"
#include "feasible_solid.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/conforming_tetrahedra.h"
#include "untangle/refine/star_disk.h"

using namespace orbicube;
using namespace orbicube::untangle;

namespace {

double content(const Triangle& t, std::span<const Vector3> p) {
  return 0.5 * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).z();
}
double content(const Tetrahedron& t, std::span<const Vector3> p) {
  return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).dot(p[t[3]] - p[t[0]]) / 6;
}

bool is_positive(const Triangle& t, std::span<const Vector2d> p) {
  return mesh::orientation_2d(p[t[0]], p[t[1]], p[t[2]]) > 0;
}
bool is_positive(const Tetrahedron& t, std::span<const Vector3> p) {
  return mesh::orientation_3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) > 0;
}

template <std::size_t corners, class Vector, class Case>
void check(const Refined<corners, Vector>& refined, const Case& c,
           const std::vector<std::array<Index, corners>>& elements) {
  CAPTURE(c.name);
  CHECK(refined.inverted == 0);
  CHECK(refined.first_inverted == no_index);
  CHECK(refined.min_determinant > 0);
  REQUIRE(refined.parents.size() == refined.elements.size());
  REQUIRE(refined.origins.size() == refined.positions.size());
  std::vector<Vector3> rest;
  for (std::size_t v = 0; v < refined.origins.size(); ++v) {
    const Origin<corners>& o = refined.origins[v];
    double sum = 0;
    for (std::size_t k = 0; k < corners; ++k) {
      CHECK((o.weights[k] > 0) == (o.vertices[k] != no_index));
      sum += o.weights[k];
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-15));
    rest.push_back(o.mean(std::span<const Vector3>(c.rest)));
    if (v >= c.start.size()) continue;
    CHECK(o.vertices[0] == v);
    if (c.fixed[(corners - 1) * v] != 0) CHECK(refined.positions[v] == c.start[v]);
  }
  // The parts of an element fill it: their vertices are means of its own, they are positive, and their contents add up.
  std::vector<double> sum(elements.size(), 0);
  for (std::size_t i = 0; i < refined.elements.size(); ++i) {
    CHECK(is_positive(refined.elements[i], refined.positions));
    const double part = content(refined.elements[i], rest);
    CHECK(part > 0);
    sum[refined.parents[i]] += part;
    const auto& parent = elements[refined.parents[i]];
    for (const Index v : refined.elements[i]) {
      for (const Index w : refined.origins[v].vertices)
        CHECK((w == no_index || std::find(parent.begin(), parent.end(), w) != parent.end()));
    }
  }
  for (std::size_t i = 0; i < elements.size(); ++i)
    CHECK(sum[i] == doctest::Approx(content(elements[i], c.rest)).epsilon(1e-10));  // of rounded coordinates
}

// The number of edges of one triangle alone.
std::size_t boundary_size(std::span<const Triangle> triangles) {
  std::map<std::pair<Index, Index>, int> count;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      ++count[std::minmax(t[k], t[(k + 1) % 3])];
  }
  return static_cast<std::size_t>(
      std::count_if(count.begin(), count.end(), [](const auto& entry) { return entry.second == 1; }));
}

}  // namespace

TEST_CASE("Flat meshes whose boundary allows it end positive as they are") {
  for (std::size_t family = 0; family + 1 < test::flat_family_count; ++family) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const test::FeasibleFlat c = test::feasible_flat(family, seed);
      CHECK(count_inverted(c.triangles, c.known, base::Host()).count == 0);
      const RefinedTriangles refined = untangle_refined(c.mesh(), {}, base::Host());
      check(refined, c, c.triangles);
      CHECK(refined.rounds == 0);
      const UntangledTriangles plain = untangle_triangles(c.mesh(), {}, base::Host());
      CHECK(plain.positions == refined.positions);
      CHECK(plain.steps == refined.steps);
    }
  }
}

TEST_CASE("Tetrahedra whose boundary allows it end positive as they are") {
  for (std::size_t family = 0; family + 1 < test::solid_family_count; ++family) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const test::FeasibleSolid c = test::feasible_solid(family, seed);
      CHECK(test::count_not_positive(c.tetrahedra, c.known) == 0);
      const RefinedTetrahedra refined = untangle_refined(c.mesh(), {}, base::Host());
      check(refined, c, c.tetrahedra);
      CHECK(refined.rounds == 0);
    }
  }
}

TEST_CASE("A disk onto a star-shaped polygon is split where its triangles have no room") {
  std::size_t split = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const test::FeasibleFlat c = test::feasible_flat(4, seed);
    const RefinedTriangles refined = untangle_refined(c.mesh(), {}, base::Host());
    check(refined, c, c.triangles);
    split += refined.rounds > 0;
    CHECK(boundary_size(refined.elements) == boundary_size(c.triangles));
  }
  CHECK(split > 0);
}

TEST_CASE("A ball onto a star-shaped polyhedron is split where its tetrahedra have no room") {
  std::size_t split = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const test::FeasibleSolid c = test::feasible_solid(4, seed);
    const RefinedTetrahedra refined = untangle_refined(c.mesh(), {}, base::Host());
    check(refined, c, c.tetrahedra);
    split += refined.rounds > 0;
    CHECK_NOTHROW(mesh::require_conforming(refined.elements, refined.positions, base::Host()));
  }
  CHECK(split > 0);
}

TEST_CASE("Splits are the same for any number of threads") {
  const test::FeasibleSolid c = test::feasible_solid(4, 3);
  base::Host one, four;
  one.thread_count = 1;
  four.thread_count = 4;
  const RefinedTetrahedra a = untangle_refined(c.mesh(), {}, one), b = untangle_refined(c.mesh(), {}, four);
  CHECK(a.rounds > 0);
  CHECK(a.positions == b.positions);
  CHECK(a.elements == b.elements);
}

TEST_CASE("A disk is mapped to any star-shaped polygon by construction, however sharp") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    test::FeasibleFlat c = test::feasible_flat(3 + seed % 2, seed);
    // Boundary vertices at unlike parts of their distances from the kernel, down to a thousandth.
    base::Random random(seed);
    for (const Index v : test::boundary_loop(c.triangles, c.start.size()))
      c.start[v] *= std::pow(1e-3, random.unit());
    StarDisk disk(std::pmr::get_default_resource());
    REQUIRE(map_star_disk(c.mesh(), disk, base::Host()));
    CHECK(count_inverted(disk.mesh.elements(), disk.positions, base::Host()).count == 0);
    for (std::size_t v = 0; v < c.start.size(); ++v)
      if (c.is_fixed(v)) CHECK(disk.positions[v] == c.start[v]);
  }
}

TEST_CASE("A star-shaped polygon is reached without a step of the method") {
  std::size_t constructed = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const test::FeasibleFlat c = test::feasible_flat(4, seed);
    const RefinedTriangles refined = untangle_refined(c.mesh(), {.steps = 0}, base::Host());
    check(refined, c, c.triangles);
    constructed += refined.constructed;
  }
  CHECK(constructed > 0);
}

TEST_CASE("A triangle and a fan without inner vertices are mapped by construction too") {
  const std::vector<Triangle> one = {{0, 1, 2}}, fan = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  // In the fan vertices 1, 2, 3 are on one side of the polygon, and vertex 4 is a reflex corner.
  const std::vector<Vector2d> corners = {{0, 0}, {4, 0}, {4, 2}, {4, 4}, {1, 1.5}};
  const std::vector<std::uint8_t> fixed(10, 1);
  StarDisk disk(std::pmr::get_default_resource());
  CHECK(map_star_disk({.triangles = one, .start = std::span(corners).first(3), .fixed = std::span(fixed).first(6)},
                      disk, base::Host()));
  CHECK(map_star_disk({.triangles = fan, .start = corners, .fixed = fixed}, disk, base::Host()));
  CHECK(count_inverted(disk.mesh.elements(), disk.positions, base::Host()).count == 0);
}

TEST_CASE("Nothing is constructed for what is no disk, no star, or not free inside") {
  StarDisk disk(std::pmr::get_default_resource());
  const test::FeasibleFlat ring = test::feasible_flat(0, 1), bent = test::feasible_flat(1, 3);
  CHECK_FALSE(map_star_disk(ring.mesh(), disk, base::Host()));
  CHECK_FALSE(map_star_disk(bent.mesh(), disk, base::Host()));  // by more than half a turn
  test::FeasibleFlat star = test::feasible_flat(4, 1);
  CHECK(map_star_disk(star.mesh(), disk, base::Host()));
  for (std::size_t v = 0; v < star.start.size(); ++v) {
    if (star.is_fixed(v)) continue;
    star.fixed[2 * v] = 1;
    break;
  }
  CHECK_FALSE(map_star_disk(star.mesh(), disk, base::Host()));
  star.fixed.clear();
  CHECK_FALSE(map_star_disk(star.mesh(), disk, base::Host()));
  Vector2d point;
  // Twice around.
  const std::vector<Vector2d> twice = {{1, 0}, {-0.5, 0.8}, {-0.5, -0.8}, {1.1, 0}, {-0.6, 0.9}, {-0.6, -0.9}};
  CHECK_FALSE(kernel_point(twice, point, base::Host()));
}

TEST_CASE("A mesh that is positive is only polished, however flat") {
  // A triangle of fixed vertices, positive by less than rounding.
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<Vector2d> start = {{0, 0}, {0.5, 0.5}, {1, 1 + 0x1p-52}, {0, 1}};
  const std::vector<std::uint8_t> fixed(8, 1);
  const RefinedTriangles refined =
      untangle_refined(TriangleProblem{.triangles = triangles, .start = start, .fixed = fixed}, {}, base::Host());
  CHECK(refined.inverted_before == 0);
  CHECK(refined.inverted == 0);
  CHECK(refined.positions.size() == 4);
}

TEST_CASE("What has no solution with splits either is returned as it is best") {
  // A square whose boundary crosses itself: the sum of areas is 0.
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<Vector2d> start = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  const std::vector<std::uint8_t> fixed(8, 1);
  const RefinedTriangles refined =
      untangle_refined(TriangleProblem{.triangles = triangles, .start = start, .fixed = fixed}, {}, base::Host());
  CHECK(refined.inverted > 0);
  CHECK(refined.first_inverted < refined.elements.size());
  for (std::size_t v = 0; v < 4; ++v)
    CHECK(refined.positions[v] == start[v]);
}
