// What is made of a certified map: corners, edges and patches with their dual graph, and quadrilateral meshes.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "blocks.h"
#include "mesh/search/predicates.h"
#include "polycube/map/certificate.h"
#include "polycube/map/construction.h"
#include "polycube/outputs/quad_mesh.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::host;

namespace {

// The map of a polycube to itself.
SurfaceMap identity(const mesh::Mesh& m) {
  SurfaceMap map;
  map.positions = map.polycube = m.positions;
  map.triangles = m.triangles;
  set_unrefined(map);
  REQUIRE(certify(map, host).valid());
  return map;
}

// A plate with a tunnel.
SurfaceMap plate() {
  return identity(test::blocks(test::box_without({3, 3, 1}, {{1, 1, 0}})));
}

SurfaceMap stairs() {
  return identity(
      test::blocks({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {1, 0, 1}, {0, 0, 2}, {0, 1, 0}, {2, 1, 0}}));
}

void check_graph(const SurfaceMap& map, const PatchGraph& graph, std::int64_t genus) {
  // Each dart is in one loop, whose darts go on from each other around one patch.
  std::vector<int> times(2 * graph.edges(), 0);
  std::size_t holes = 0;
  for (Index p = 0; p < graph.patches(); ++p) {
    REQUIRE(graph.loops_of_patch[p] < graph.loops_of_patch[p + 1]);
    holes += graph.loops_of_patch[p + 1] - graph.loops_of_patch[p] - 1;
    for (Index l = graph.loops_of_patch[p]; l < graph.loops_of_patch[p + 1]; ++l) {
      const auto loop = graph.loop(l);
      CHECK(loop.size() >= 4);
      double area = 0;
      const int axis = axis_of(graph.labels[p]), u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        ++times[loop[i]];
        CHECK(graph.dart_left[loop[i]] == p);
        CHECK(graph.target(loop[i]) == graph.origin(loop[(i + 1) % loop.size()]));
        const Vector3 &a = graph.corners[graph.origin(loop[i])], &b = graph.corners[graph.target(loop[i])];
        CHECK(a[axis] == graph.coordinates[p]);
        area += sign_of(graph.labels[p]) * (a[u] * b[v] - a[v] * b[u]);
      }
      // The first loop goes around, the others are holes.
      CHECK((area > 0) == (l == graph.loops_of_patch[p]));
    }
  }
  CHECK(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
  // Euler's formula with patches that have holes.
  const auto count = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  CHECK(count(graph.corners.size()) - count(graph.edges()) + count(graph.patches()) - count(holes) == 2 - 2 * genus);
  for (Index e = 0; e < graph.edges(); ++e) {
    const auto path = graph.path(e);
    CHECK(path.front() == graph.corner_vertices[graph.origin(2 * e)]);
    CHECK(path.back() == graph.corner_vertices[graph.target(2 * e)]);
    CHECK(std::find(graph.neighbors_of(graph.dart_left[2 * e]).begin(),
                    graph.neighbors_of(graph.dart_left[2 * e]).end(),
                    graph.dart_left[2 * e + 1]) != graph.neighbors_of(graph.dart_left[2 * e]).end());
  }
  for (Index p = 0; p < graph.patches(); ++p) {
    const auto around = graph.neighbors_of(p);
    CHECK(std::is_sorted(around.begin(), around.end()));
    for (const Index q : around) {
      const auto back = graph.neighbors_of(q);
      CHECK(q != p);
      CHECK(std::find(back.begin(), back.end(), p) != back.end());
    }
  }
  for (std::size_t c = 0; c < graph.corners.size(); ++c)
    CHECK(graph.corners[c] == map.polycube[graph.corner_vertices[c]]);
}

// Quads on the polycube tile it, and each vertex is where its triangle and weights say.
void check_quads(const SurfaceMap& map, const QuadMesh& mesh) {
  double area = 0, wanted = 0;
  std::map<std::pair<Index, Index>, int> edges;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    const Quad& c = mesh.quads[q];
    const auto p = [&](std::size_t k) { return mesh.polycube[c[k]]; };
    const Vector3 normal = 0.5 * (p(2) - p(0)).cross(p(3) - p(1));
    area += normal.norm();
    for (std::size_t k = 0; k < 4; ++k)
      ++edges[{c[k], c[(k + 1) % 4]}];
    // In its patch, and looking as it does.
    const Index t = mesh.triangles[c[0]];
    const auto label = std::find(map.patches.begin(), map.patches.end(), mesh.patches[q]) - map.patches.begin();
    CHECK(normal.normalized() == direction_of(map.labels[static_cast<std::size_t>(label)]));
    CHECK(t < map.triangles.size());
  }
  for (const Triangle& t : map.triangles) {
    const Vector3 &a = map.polycube[t[0]], &b = map.polycube[t[1]], &c = map.polycube[t[2]];
    wanted += 0.5 * (b - a).cross(c - a).norm();
  }
  CHECK(area == doctest::Approx(wanted).epsilon(1e-12));
  for (const auto& edge : edges) {
    CHECK(edge.second == 1);
    CHECK(edges.count({edge.first.second, edge.first.first}) == 1);
  }
  double size = 0;
  for (const Vector3& p : map.polycube)
    size = std::max(size, p.cwiseAbs().maxCoeff());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Triangle& t = map.triangles[mesh.triangles[v]];
    const Vector3& w = mesh.weights[v];
    CHECK(w.minCoeff() >= 0);
    CHECK(w.sum() == doctest::Approx(1).epsilon(1e-15));
    const Vector3 on_polycube = w[0] * map.polycube[t[0]] + w[1] * map.polycube[t[1]] + w[2] * map.polycube[t[2]];
    // Weights of thin triangles have errors that their positions have not.
    CHECK((on_polycube - mesh.polycube[v]).norm() <= 1e-9 * size);
    const Vector3 in_space = w[0] * map.positions[t[0]] + w[1] * map.positions[t[1]] + w[2] * map.positions[t[2]];
    CHECK((in_space - mesh.positions[v]).norm() <= 1e-14 * size);
  }
}

}  // namespace

TEST_CASE("A box has eight corners, twelve convex edges and six patches with four neighbors each") {
  const SurfaceMap map = identity(test::blocks(test::box_without({2, 3, 4})));
  const PatchGraph graph = make_patch_graph(map, host);
  CHECK(graph.corners.size() == 8);
  CHECK(graph.edges() == 12);
  CHECK(graph.patches() == 6);
  CHECK(std::count(graph.convex.begin(), graph.convex.end(), 1) == 12);
  for (Index p = 0; p < 6; ++p)
    CHECK(graph.neighbors_of(p).size() == 4);
  check_graph(map, graph, 0);
}

TEST_CASE("A tunnel has concave edges along it and makes holes in the patches at its ends") {
  const SurfaceMap map = plate();
  const PatchGraph graph = make_patch_graph(map, host);
  CHECK(graph.corners.size() == 16);
  CHECK(graph.edges() == 24);
  CHECK(graph.patches() == 10);
  CHECK(std::count(graph.convex.begin(), graph.convex.end(), 0) == 4);
  for (Index e = 0; e < graph.edges(); ++e) {
    const Vector3 along = graph.corners[graph.target(2 * e)] - graph.corners[graph.origin(2 * e)];
    const bool inner = (graph.corners[graph.origin(2 * e)] - Vector3(1.5, 1.5, 0.5)).cwiseAbs().maxCoeff() < 1;
    CHECK(graph.convex[e] == !(inner && along[2] != 0));
  }
  check_graph(map, graph, 1);
  const PatchGraph steps = make_patch_graph(stairs(), host);
  check_graph(stairs(), steps, 0);
  // Three below the blocks on top, two where the gap between the blocks in front begins.
  CHECK(std::count(steps.convex.begin(), steps.convex.end(), 0) == 5);
}

TEST_CASE("Grids have integer cells between layers, at least one, near to the number that is requested") {
  const PatchGraph box = make_patch_graph(identity(test::blocks(test::box_without({2, 3, 4}))), host);
  const PolycubeGrid grid = make_grid(box, {.edge_length = 0.5}, host);
  CHECK(grid.cells[0] == Array<Index>{4});
  CHECK(grid.cells[1] == Array<Index>{6});
  CHECK(grid.cells[2] == Array<Index>{8});
  CHECK(make_grid(box, {.edge_length = 100}, host).cells[2] == Array<Index>{1});
  // 52 unit squares, each cut in 10 by 10.
  CHECK(mesh_grid(box, make_grid(box, {.quads = 5200}, host), host).quads.size() == 5200);
  const SurfaceMap map = stairs();
  const PatchGraph graph = make_patch_graph(map, host);
  std::size_t last = 0;
  for (const std::size_t wanted : {1U, 30U, 500U, 7000U, 40000U}) {
    const std::size_t quads = mesh_grid(graph, make_grid(graph, {.quads = wanted}, host), host).quads.size();
    CHECK(quads >= last);
    if (wanted >= 500) CHECK(static_cast<double>(quads) == doctest::Approx(static_cast<double>(wanted)).epsilon(0.2));
    last = quads;
  }
  for (const double length : {-1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e-9})
    CHECK_THROWS(make_grid(graph, {.edge_length = length}, host));
  CHECK_THROWS(make_grid(graph, {.quads = 0}, host));
}

TEST_CASE("Quads tile a polycube, are regular inside patches, and the map to itself leaves them in place") {
  for (const SurfaceMap& map : {plate(), stairs()}) {
    const PatchGraph graph = make_patch_graph(map, host);
    QuadMesh mesh = mesh_grid(graph, make_grid(graph, {.edge_length = 0.3}, host), host);
    sample_grid(map, mesh, host);
    check_quads(map, mesh);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      CHECK((mesh.positions[v] - mesh.polycube[v]).norm() < 1e-14);
    // Around a vertex inside a patch or along an edge are four quads; around a corner as many as it has right angles.
    std::map<Index, std::size_t> valence;
    for (const Quad& q : mesh.quads)
      for (const Index v : q)
        ++valence[v];
    std::set<std::array<double, 3>> corners;
    for (const Vector3& c : graph.corners)
      corners.insert({c[0], c[1], c[2]});
    std::size_t irregular = 0;
    for (const auto& vertex : valence) {
      const Vector3& p = mesh.polycube[vertex.first];
      if (corners.count({p[0], p[1], p[2]}) == 0) CHECK(vertex.second == 4);
      irregular += vertex.second != 4;
    }
    const QuadQuality quality = measure_quads(mesh.positions, mesh.quads, host);
    CHECK(quality.irregular == irregular);
    CHECK(quality.not_convex == 0);
    CHECK(quality.min_scaled_jacobian == doctest::Approx(1).epsilon(1e-12));
    CHECK(quality.mean_scaled_jacobian == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("Maps that were found are sampled where the certificate says that they are one to one" *
          doctest::test_suite("long")) {
  for (const char* name : {"bracket", "creature"}) {
    const mesh::Mesh m = test::shape(name, 1200);
    const Construction made = construct(m.positions, m.triangles, {.method = Method::voxels, .corners = 60}, host).made;
    const PatchGraph graph = make_patch_graph(made.map, host);
    CHECK(graph.corners.size() == made.certificate.corners);
    CHECK(graph.patches() == made.certificate.patch_count);
    check_graph(made.map, graph, made.certificate.genus);
    QuadMesh mesh = mesh_grid(graph, make_grid(graph, {.quads = 3000}, host), host);
    sample_grid(made.map, mesh, host);
    check_quads(made.map, mesh);
    CHECK(static_cast<double>(mesh.quads.size()) == doctest::Approx(3000).epsilon(0.4));
    // Corners go to the vertices that they come from, exactly.
    std::map<std::array<double, 3>, Vector3> at;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      at[{mesh.polycube[v][0], mesh.polycube[v][1], mesh.polycube[v][2]}] = mesh.positions[v];
    for (std::size_t c = 0; c < graph.corners.size(); ++c) {
      const Vector3& p = graph.corners[c];
      CHECK(at.at({p[0], p[1], p[2]}) == made.map.positions[graph.corner_vertices[c]]);
    }
    // Another map to the same polycube has the same quads; here one with its triangles in another order.
    SurfaceMap turned = made.map;
    std::reverse(turned.triangles.begin(), turned.triangles.end());
    REQUIRE(certify(turned, host).valid());
    const PatchGraph same = make_patch_graph(turned, host);
    QuadMesh again = mesh_grid(same, make_grid(same, {.quads = 3000}, host), host);
    CHECK(again.quads == mesh.quads);
    CHECK(again.polycube == mesh.polycube);
    sample_grid(turned, again, host);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      CHECK((again.positions[v] - mesh.positions[v]).norm() < 1e-9);
  }
}
