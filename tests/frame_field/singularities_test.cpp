// Matchings, singular edges and curves of fields that are known, and what every field has in common.
#include "frame_field/singularities/singularities.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "frame_field/graph/boundary_indices.h"
#include "frame_field/graph/constraints.h"
#include "frame_field/singularities/measurement.h"
#include "frame_field/singularities/meshability.h"
#include "solids.h"

using namespace orbicube;
using namespace orbicube::frame_field;
using quaternion::cube_group;
using test::bar;

namespace {

struct Analysis {
  Analysis(const test::Solid& solid, const std::vector<Quaternion>& field)
      : connectivity(solid.positions.size(), solid.tetrahedra, host),
        matching(matchings(connectivity, field, host)),
        graph(singular_graph(solid.positions, connectivity, field, matching, host)),
        figures(measure(solid.positions, connectivity, field, host)),
        indices(boundary_indices(solid.positions, connectivity, field, host)) {}
  base::Host host;
  mesh::TetrahedralConnectivity connectivity;
  Array<std::uint8_t> matching;
  SingularGraph graph;
  Measurement figures;
  BoundaryIndices indices;
};

Vector3 centre(const test::Solid& solid, const Tetrahedron& t) {
  return 0.25 * (solid.positions[t[0]] + solid.positions[t[1]] + solid.positions[t[2]] + solid.positions[t[3]]);
}

// Frames that turn about the z axis by `quarters` / 4 as often as one goes round the line x = y = 0.
std::vector<Quaternion> field_about_z(const test::Solid& solid, int quarters) {
  std::vector<Quaternion> field;
  for (const Tetrahedron& t : solid.tetrahedra) {
    const Vector3 p = centre(solid, t);
    field.push_back(turned({1, 0, 0, 0}, {0, 0, 1}, quarters * std::atan2(p[1], p[0]) / 4));
  }
  return field;
}

std::vector<Quaternion> random_field(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Quaternion> field(count);
  for (Quaternion& q : field)
    q = test::random_rotation(random);
  return field;
}

}  // namespace

TEST_CASE("A field that turns by a quarter about a line has that line as its one curve, of the right sign") {
  const test::Solid solid = bar();
  for (const int quarters : {1, -1, 2}) {
    const Analysis a(solid, field_about_z(solid, quarters));
    CHECK(a.graph.edges.size() == 5);
    CHECK(a.graph.curves() == 1);
    CHECK(a.graph.nodes.empty());
    CHECK(a.graph.dead_ends.empty());
    CHECK(a.graph.boundary_ends == 2);
    CHECK(a.graph.singular_length == doctest::Approx(5));
    for (const SingularEdge& edge : a.graph.edges) {
      CHECK(solid.positions[edge.vertices[0]].head<2>().norm() < 1e-12);
      CHECK(solid.positions[edge.vertices[1]].head<2>().norm() < 1e-12);
      // A field that turns forward by a quarter is that of three cells around an edge.
      CHECK(edge.turn == (quarters == 2 ? 2 : quarters));
      CHECK(edge.kind() == (quarters == 2 ? quaternion::CubeClass::face_half : quaternion::CubeClass::face_quarter));
    }
  }
  const Analysis regular(solid, field_about_z(solid, 0));
  CHECK(regular.graph.edges.empty());
  CHECK(regular.figures.energy == 0);
}

TEST_CASE("Matchings are inverse on both sides and bring frames within 62.8 degrees") {
  const test::Solid solid = test::ball(6);
  const auto field = random_field(solid.tetrahedra.size(), 8);
  const Analysis a(solid, field);
  for (Index f = 0; f < a.connectivity.face_count(); ++f) {
    if (a.connectivity.on_boundary(f)) {
      CHECK(a.matching[f] == 0);
      continue;
    }
    const Index t = a.connectivity.tetrahedron_of(f), u = a.connectivity.neighbor(t, f % 4);
    CHECK(a.matching[a.connectivity.opposite(f)] == cube_group.inverse[a.matching[f]]);
    const Quaternion moved = quaternion::multiply(field[t], cube_group.element[a.matching[f]]);
    CHECK(std::abs(quaternion::dot(moved, field[u])) >= std::cos(0.5 * 62.8 / 180 * std::numbers::pi));
  }
  CHECK(a.figures.symmetric.largest <= 62.80);
  CHECK(a.figures.plain.largest <= 180);
}

TEST_CASE("No field has a curve that ends inside, and boundary indices add up to the Euler characteristic") {
  struct Case {
    test::Solid solid;
    int euler_characteristic;
  };
  const std::vector<Case> cases = {
      {test::shaken(test::cubes(4, 5, 4), 0.1), 2}, {test::ball(6), 2}, {test::ring(16, 3), 0}};
  for (const Case& c : cases) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Analysis a(c.solid, random_field(c.solid.tetrahedra.size(), seed));
      CHECK(a.graph.edges.size() > 100);  // a random field is singular everywhere
      CHECK(a.graph.dead_ends.empty());
      CHECK(a.indices.euler_characteristic == c.euler_characteristic);
      CHECK(a.indices.sum_of_quarters == 4 * c.euler_characteristic);
    }
  }
}

TEST_CASE("Every singular edge lies on one curve, whose edges follow each other") {
  const test::Solid solid = test::ball(5);
  const Analysis a(solid, random_field(solid.tetrahedra.size(), 4));
  std::vector<int> times(a.graph.edges.size());
  for (std::size_t c = 0; c < a.graph.curves(); ++c) {
    const auto curve = a.graph.curve(c);
    REQUIRE(!curve.empty());
    for (std::size_t i = 0; i < curve.size(); ++i) {
      ++times[curve[i]];
      if (i == 0) continue;
      const auto &e = a.graph.edges[curve[i - 1]].vertices, &f = a.graph.edges[curve[i]].vertices;
      CHECK((e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]));
    }
  }
  CHECK(std::ranges::all_of(times, [](int n) { return n == 1; }));
}

TEST_CASE("Rotations of the cube on any frame, renumbering and rigid motion change no figure") {
  const test::Solid solid = test::ball(5);
  const std::vector<Quaternion> field = field_about_z(solid, 1);
  const Analysis a(solid, field);
  std::mt19937_64 random(9);

  std::vector<Quaternion> other = field;
  for (Quaternion& q : other)
    q = quaternion::multiply(q, cube_group.element[random() % 24]);
  const Quaternion turn = test::random_rotation(random);
  test::Solid moved = solid;
  std::vector<Quaternion> turned_field = field;
  for (Vector3& p : moved.positions)
    p = test::rotated(turn, p) + Vector3(3, -2, 1);
  for (Quaternion& q : turned_field)
    q = quaternion::multiply(turn, q);
  test::Solid renumbered = solid;
  std::vector<Quaternion> permuted(field.size());
  std::vector<Index> order(field.size());
  for (Index t = 0; t < order.size(); ++t)
    order[t] = t;
  std::ranges::shuffle(order, random);
  for (Index t = 0; t < order.size(); ++t) {
    renumbered.tetrahedra[t] = solid.tetrahedra[order[t]];
    // Another even permutation of the corners.
    std::rotate(renumbered.tetrahedra[t].begin(), renumbered.tetrahedra[t].begin() + 1,
                renumbered.tetrahedra[t].begin() + 3);
    permuted[t] = field[order[t]];
  }
  for (const Analysis& b : {Analysis(solid, other), Analysis(moved, turned_field), Analysis(renumbered, permuted)}) {
    CHECK(b.figures.energy == doctest::Approx(a.figures.energy).epsilon(1e-12));
    CHECK(b.figures.symmetric.mean == doctest::Approx(a.figures.symmetric.mean).epsilon(1e-9));
    CHECK(b.figures.one_face_max == doctest::Approx(a.figures.one_face_max).epsilon(1e-9));
    CHECK(b.graph.by_class == a.graph.by_class);
    CHECK(b.graph.curves() == a.graph.curves());
    CHECK(b.graph.nodes.size() == a.graph.nodes.size());
    CHECK(b.graph.boundary_ends == a.graph.boundary_ends);
    CHECK(b.graph.singular_length == doctest::Approx(a.graph.singular_length));
    CHECK(b.indices.sum_of_quarters == a.indices.sum_of_quarters);
  }
}

TEST_CASE("Which edges are of three and of five cells does not depend on the numbers of vertices and tetrahedra") {
  const test::Solid solid = test::ball(5);
  // Frames at random, so that turns lie askew to their edges.
  std::mt19937_64 random(4);
  std::vector<Quaternion> field(solid.tetrahedra.size());
  for (Quaternion& q : field)
    q = test::random_rotation(random);
  const auto figures = [](const test::Solid& s, const std::vector<Quaternion>& f) {
    const Analysis a(s, f);
    const base::Host host;
    const mesh::TetrahedralConnectivity connectivity(s.positions.size(), s.tetrahedra, host);
    const Meshability m = meshability(a.graph, connectivity.boundary_vertices(host.memory), host.memory);
    const auto of_three = std::ranges::count(a.graph.edges, std::int8_t{1}, &SingularEdge::turn);
    const auto of_five = std::ranges::count(a.graph.edges, std::int8_t{-1}, &SingularEdge::turn);
    return std::vector<std::size_t>{static_cast<std::size_t>(of_three), static_cast<std::size_t>(of_five),
                                    m.edges.size(), m.vertices.size(), m.turning_points};
  };
  const std::vector<std::size_t> expected = figures(solid, field);
  REQUIRE(expected[0] > 100);
  REQUIRE(expected[1] > 100);
  std::vector<Index> vertex(solid.positions.size()), order(solid.tetrahedra.size());
  std::iota(vertex.begin(), vertex.end(), Index{0});
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::shuffle(vertex, random);
  std::ranges::shuffle(order, random);
  test::Solid other = solid;
  std::vector<Quaternion> permuted(field.size());
  for (std::size_t v = 0; v < vertex.size(); ++v)
    other.positions[vertex[v]] = solid.positions[v];
  for (std::size_t t = 0; t < order.size(); ++t) {
    const Tetrahedron& from = solid.tetrahedra[order[t]];
    other.tetrahedra[t] = {vertex[from[1]], vertex[from[2]], vertex[from[0]], vertex[from[3]]};
    permuted[t] = field[order[t]];
  }
  CHECK(figures(other, permuted) == expected);
}

TEST_CASE("Plain angles know no symmetry, symmetric ones do") {
  const test::Solid solid = test::cubes(2, 2, 2);
  std::vector<Quaternion> field(solid.tetrahedra.size(), Quaternion{1, 0, 0, 0});
  field[7] = cube_group.element[4];
  const Analysis a(solid, field);
  CHECK(a.figures.symmetric.largest < 1e-12);
  CHECK(a.figures.plain.largest == doctest::Approx(90));
  CHECK(a.figures.energy < 1e-24);
}

TEST_CASE("Vertices of hexahedra are those whose edges are the corners of a triangulated sphere") {
  // With degrees 3, 4 and 5 at n3, n4 and n5 corners, Euler's formula requires 3 n3 + 2 n4 + n5 = 12.
  std::size_t accepted = 0;
  for (std::size_t three = 0; three <= 12; ++three) {
    for (std::size_t five = 0; five <= 12; ++five) {
      if (!is_vertex_of_hexahedra(three, five)) continue;
      ++accepted;
      CHECK(3 * three + five <= 12);
      CHECK((12 - 3 * three - five) % 2 == 0);
    }
  }
  CHECK(accepted == 11);
  CHECK(!is_vertex_of_hexahedra(1, 1));  // a turning point
  CHECK(!is_vertex_of_hexahedra(3, 1));
}

TEST_CASE("A straight curve is locally meshable, a half turn is not, and a random field is not at all") {
  const test::Solid solid = bar();
  for (const int quarters : {0, 1, -1, 2}) {
    const Analysis a(solid, field_about_z(solid, quarters));
    const Meshability m = meshability(a.graph, a.connectivity.boundary_vertices(a.host.memory), a.host.memory);
    CHECK(m.locally_meshable() == (quarters != 2));
    CHECK(m.edges.size() == (quarters == 2 ? 5 : 0));
    CHECK(m.vertices.empty());
  }
  // A curve of threes that becomes one of fives at the vertex 1.
  SingularGraph turning(std::pmr::get_default_resource());
  turning.edges.push_back({{0, 1}, 0, 4, 1, 1.0});
  turning.edges.push_back({{1, 2}, 0, 5, -1, 1.0});
  const std::vector<std::uint8_t> outer = {1, 0, 1};
  const Meshability m = meshability(turning, outer, std::pmr::get_default_resource());
  CHECK(!m.locally_meshable());
  CHECK(m.edges.empty());
  CHECK(m.turning_points == 1);
  CHECK((m.vertices.size() == 1 && m.vertices[0] == 1));

  const Analysis wild(solid, random_field(solid.tetrahedra.size(), 3));
  const Meshability w =
      meshability(wild.graph, wild.connectivity.boundary_vertices(wild.host.memory), wild.host.memory);
  CHECK(w.edges.size() + w.vertices.size() > 100);
  CHECK(w.turning_points + w.improper_nodes == w.vertices.size());
}
