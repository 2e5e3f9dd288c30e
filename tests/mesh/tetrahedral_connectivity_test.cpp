// Faces, boundary and rings of edges of tetrahedra.
#include "mesh/topology/tetrahedral_connectivity.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "cubes.h"
#include "mesh/search/predicates.h"

using namespace orbicube;
using namespace orbicube::mesh;
using test::cubes, test::Solid;

namespace {

std::string refusal(std::size_t vertices, const std::vector<Tetrahedron>& tetrahedra) {
  try {
    TetrahedralConnectivity(vertices, tetrahedra, base::Host());
  } catch (const base::Error& e) {
    return e.kind();
  }
  return "";
}

std::set<Index> vertex_set(const Triangle& t) {
  return {t.begin(), t.end()};
}

}  // namespace

TEST_CASE("Each face has the same vertices from its other side, turned round, and the boundary is that of the box") {
  const Solid solid = cubes(3, 2, 4);
  const TetrahedralConnectivity c(solid.positions.size(), solid.tetrahedra, base::Host());
  std::size_t boundary = 0;
  for (Index f = 0; f < c.face_count(); ++f) {
    const Index t = c.tetrahedron_of(f);
    const Triangle face = c.vertices(f);
    const Index apex = solid.tetrahedra[t][c.corner_opposite(f)];
    const auto& x = solid.positions;
    CHECK(orientation_3d(x[face[0]], x[face[1]], x[face[2]], x[apex]) < 0);  // the tetrahedron is behind it
    if (c.on_boundary(f)) {
      ++boundary;
      CHECK(c.neighbor(t, c.corner_opposite(f)) == no_index);
      continue;
    }
    const Index g = c.opposite(f);
    CHECK(c.opposite(g) == f);
    CHECK(c.neighbor(t, c.corner_opposite(f)) == c.tetrahedron_of(g));
    CHECK(vertex_set(c.vertices(g)) == vertex_set(face));
  }
  CHECK(boundary == 2 * 2 * (3 * 2 + 2 * 4 + 4 * 3));
  CHECK(c.boundary_face_count() == boundary);
  const auto on_boundary = c.boundary_vertices(std::pmr::get_default_resource());
  CHECK(std::ranges::count(on_boundary, 1) == 4 * 3 * 5 - 2 * 1 * 3);
}

TEST_CASE("Rings hold every tetrahedron of their edge once, in order, right-handed about the edge") {
  Solid solid = cubes(3, 3, 3);
  std::shuffle(solid.tetrahedra.begin(), solid.tetrahedra.end(), std::mt19937(5));
  const TetrahedralConnectivity c(solid.positions.size(), solid.tetrahedra, base::Host());
  const EdgeRings rings(c, base::Host());
  std::map<std::set<Index>, std::set<Index>> expected;
  for (Index t = 0; t < solid.tetrahedra.size(); ++t) {
    for (const EdgeCorners& e : edge_corners)
      expected[{solid.tetrahedra[t][e.start], solid.tetrahedra[t][e.end]}].insert(t);
  }
  REQUIRE(rings.size() == expected.size());
  // vertices - edges + faces - tetrahedra of a ball
  const std::size_t faces = (c.face_count() + c.boundary_face_count()) / 2;
  CHECK(solid.positions.size() + faces == rings.size() + solid.tetrahedra.size() + 1);
  std::size_t open = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Edge edge = rings.vertices(r);
    const auto ring = rings.faces(r);
    std::set<Index> seen;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Index t = c.tetrahedron_of(ring[i]);
      seen.insert(t);
      const auto leaving = vertex_set(c.vertices(ring[i]));
      CHECK(leaving.contains(edge[0]));
      CHECK(leaving.contains(edge[1]));
      // Behind, start, end, ahead: turning right-handed about the edge goes from behind to ahead.
      Index ahead = no_index;
      for (const Index v : leaving)
        ahead = v != edge[0] && v != edge[1] ? v : ahead;
      const Index behind = solid.tetrahedra[t][c.corner_opposite(ring[i])];
      const auto& x = solid.positions;
      CHECK(orientation_3d(x[edge[0]], x[edge[1]], x[behind], x[ahead]) > 0);
      const bool last = i + 1 == ring.size();
      if (last && rings.on_boundary(r))
        CHECK(c.on_boundary(ring[i]));
      else
        CHECK(c.tetrahedron_of(c.opposite(ring[i])) == c.tetrahedron_of(ring[last ? 0 : i + 1]));
    }
    open += rings.on_boundary(r);
    CHECK(seen.size() == ring.size());
    CHECK(seen == expected.at({edge[0], edge[1]}));
  }
  CHECK(open == c.boundary_face_count() * 3 / 2);
}

TEST_CASE("Two tetrahedra that only touch along an edge give that edge two rings") {
  const std::vector<Tetrahedron> tetrahedra{{0, 1, 2, 3}, {0, 1, 4, 5}};
  const TetrahedralConnectivity c(6, tetrahedra, base::Host());
  CHECK(EdgeRings(c, base::Host()).size() == 12);
  CHECK(c.boundary_face_count() == 8);
}

TEST_CASE("What is no solid is refused") {
  CHECK(refusal(4, {{0, 1, 2, 2}}) == "degenerate-cell");
  CHECK(refusal(5, {{0, 1, 2, 3}, {0, 2, 1, 4}}).empty());
  CHECK(refusal(5, {{0, 1, 2, 3}, {0, 1, 2, 4}}) == "inconsistent-orientation");
  CHECK(refusal(6, {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}}) != "");
  CHECK(refusal(6, {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 2, 1, 5}}) == "non-manifold-face");
}

TEST_CASE("Joining tetrahedra can be cancelled") {
  const Solid solid = cubes(2, 2, 2);
  base::Host host;
  host.on_progress = [](const base::Progress&) { return false; };
  CHECK_THROWS_AS(TetrahedralConnectivity(solid.positions.size(), solid.tetrahedra, host), base::Error);
}
