// Polycubes that are given: read from meshes and loops, refused when they are none, drawn on surfaces.
#include "polycube/layout/given_polycube.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <string>

#include "base/error.h"
#include "blocks.h"
#include "polycube/layout/drawn_construction.h"
#include "polycube/layout/layout.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::host;
using test::shape;

namespace {

TargetPolycube target_of(const std::vector<test::Cell>& cells) {
  const mesh::Mesh m = test::blocks(cells);
  return target_of_mesh(m.positions, m.triangles, 0, host);
}

std::string kind_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const base::Error& error) {
    return error.kind();
  }
  return "";
}

// Loops of a graph as a user would give them.
struct Loops {
  explicit Loops(const PatchGraph& graph) {
    begins.resize(graph.patches());
    corners.resize(graph.patches());
    for (Index p = 0; p < graph.patches(); ++p) {
      begins[p].push_back(0);
      for (Index l = graph.loops_of_patch[p]; l < graph.loops_of_patch[p + 1]; ++l) {
        for (const Index dart : graph.loop(l))
          corners[p].push_back(graph.origin(dart));
        begins[p].push_back(static_cast<Index>(corners[p].size()));
      }
      patches.push_back({graph.labels[p], begins[p], corners[p]});
    }
  }

  std::vector<std::vector<Index>> begins, corners;
  std::vector<GivenPatch> patches;
};

std::set<std::array<double, 3>> set_of(std::span<const Vector3> points) {
  std::set<std::array<double, 3>> result;
  for (const Vector3& p : points)
    result.insert({p[0], p[1], p[2]});
  return result;
}

const std::vector<test::Cell> ring = test::box_without({3, 3, 1}, {{1, 1, 0}});
const std::vector<test::Cell> corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

}  // namespace

TEST_CASE("A polycube is the same from its triangles, its loops, and its cells") {
  for (const auto& cells : {test::box_without({2, 1, 3}), ring, corner}) {
    const TargetPolycube target = target_of(cells);
    CHECK(target.genus == (cells == ring ? 1 : 0));
    const Loops loops(target.graph);
    const TargetPolycube again = target_of_patches(target.graph.corners, loops.patches, host);
    CHECK(again.genus == target.genus);
    CHECK(again.graph.patches() == target.graph.patches());
    CHECK(again.graph.edges() == target.graph.edges());
    CHECK(set_of(again.graph.corners) == set_of(target.graph.corners));
    const VoxelSolid solid = solid_of(target.graph, host);
    const VoxelTopology topology = solid.topology(host);
    CHECK(topology.bad_vertices == 0);
    CHECK(topology.genus == target.genus);
    CHECK(topology.inside_components == 1);
    CHECK(solid.corners() == target.graph.corners.size());
    // Each cell of a polycube of unit cells between unit planes.
    double volume = 0;
    for (std::size_t i = 0; i < solid.size(); ++i) {
      if (!solid.inside(i)) continue;
      const Cell c = solid.cell(i);
      const Vector3 size = solid.position({c[0] + 1, c[1] + 1, c[2] + 1}) - solid.position(c);
      volume += size.prod();
    }
    CHECK(volume == doctest::Approx(static_cast<double>(cells.size())).epsilon(1e-14));
    const Layout layout = make_layout(solid, host);
    CHECK(layout.corners() == target.graph.corners.size());
  }
}

TEST_CASE("What is no polycube is refused with a reason") {
  mesh::Mesh bent = test::blocks(ring);
  bent.positions[3][0] += 0.01;
  CHECK(kind_of([&] { target_of_mesh(bent.positions, bent.triangles, 0, host); }) == "unsupported");
  mesh::Mesh open = test::blocks(ring);
  open.triangles.pop_back();
  CHECK(kind_of([&] { target_of_mesh(open.positions, open.triangles, 0, host); }) == "unsupported");
  open.triangles.back()[0] = 1000;
  CHECK(kind_of([&] { target_of_mesh(open.positions, open.triangles, 0, host); }) == "index-range");
  bent.positions[3][0] = std::nan("");
  CHECK(kind_of([&] { target_of_mesh(bent.positions, bent.triangles, 0, host); }) == "non-finite");
  // Two cells that touch along an edge.
  const mesh::Mesh touching = test::blocks({{0, 0, 0}, {1, 1, 0}});
  CHECK(kind_of([&] { target_of_mesh(touching.positions, touching.triangles, 0, host); }) == "unsupported");

  const TargetPolycube box = target_of(test::box_without({1, 1, 1}));
  const auto refused = [&](const auto& change) {
    Loops loops(box.graph);
    std::vector<Vector3> corners(box.graph.corners.begin(), box.graph.corners.end());
    change(loops, corners);
    return kind_of([&] { target_of_patches(corners, loops.patches, host); });
  };
  CHECK(refused([](Loops&, std::vector<Vector3>&) {}) == "");
  CHECK(refused([](Loops& l, std::vector<Vector3>&) { l.patches.pop_back(); }) == "unsupported");
  CHECK(refused([](Loops& l, std::vector<Vector3>&) { l.patches.clear(); }) == "unsupported");
  CHECK(refused([](Loops& l, std::vector<Vector3>&) { std::swap(l.corners[0][1], l.corners[0][2]); }) == "unsupported");
  CHECK(refused([](Loops& l, std::vector<Vector3>&) { std::reverse(l.corners[0].begin(), l.corners[0].end()); }) ==
        "unsupported");
  CHECK(refused([](Loops& l, std::vector<Vector3>&) { l.corners[2][1] = 8; }) == "index-range");
  CHECK(refused([](Loops& l, std::vector<Vector3>&) { l.patches[1].label = 6; }) == "unsupported");
  CHECK(refused([](Loops& l, std::vector<Vector3>&) { l.patches[1].label = opposite(l.patches[1].label); }) ==
        "unsupported");
  CHECK(refused([](Loops&, std::vector<Vector3>& c) { c[5][1] += 0.5; }) == "unsupported");
  CHECK(refused([](Loops&, std::vector<Vector3>& c) { c[5][1] = INFINITY; }) == "non-finite");
}

TEST_CASE("Coordinates that a file has rounded are joined") {
  mesh::Mesh rough = test::blocks(corner);
  std::mt19937_64 random(3);
  for (Vector3& p : rough.positions)
    for (double& x : p)
      x += 1e-9 * (static_cast<double>(random() % 1000) / 500 - 1);
  CHECK(kind_of([&] { target_of_mesh(rough.positions, rough.triangles, 0, host); }) == "unsupported");
  const TargetPolycube joined = target_of_mesh(rough.positions, rough.triangles, 1e-6, host);
  CHECK(joined.graph.corners.size() == target_of(corner).graph.corners.size());
  for (std::size_t i = 0; i < rough.positions.size(); ++i)
    CHECK((joined.map.polycube[i] - rough.positions[i]).cwiseAbs().maxCoeff() < 3e-9);
}

TEST_CASE("A surface is mapped to the very polycube that is given") {
  struct Case {
    const char* shape;
    std::vector<test::Cell> cells;
  };
  for (const Case& c : {Case{"sphere", corner}, Case{"torus", ring}}) {
    const mesh::Mesh m = shape(c.shape, 1200);
    const TargetPolycube target = target_of(c.cells);
    const Construction made = construct_on(m.positions, m.triangles, target.graph, target.genus, {}, host);
    CHECK(made.certificate.valid());
    CHECK(made.certificate.genus == target.genus);
    CHECK(made.certificate.corners == target.graph.corners.size());
    CHECK(made.certificate.patch_count == target.graph.patches());
    const PatchGraph graph = make_patch_graph(made.map, host);
    CHECK(set_of(graph.corners) == set_of(target.graph.corners));
    for (std::size_t v = 0; v < m.positions.size(); ++v)
      CHECK(made.map.positions[v] == m.positions[v]);
  }
}

TEST_CASE("Corners go to their targets") {
  const mesh::Mesh m = shape("sphere", 1500);
  const TargetPolycube target = target_of(test::box_without({2, 2, 2}));
  // A box on its corner, as it were: turned by 45 degrees about z, and one corner at a point within a triangle.
  std::vector<CornerPlace> places;
  const double turn = std::atan(1.0);
  for (Index c = 0; c < 8; ++c) {
    const Vector3 p = target.graph.corners[c] - Vector3::Ones();
    const Vector3 wanted =
        Vector3(std::cos(turn) * p[0] - std::sin(turn) * p[1], std::sin(turn) * p[0] + std::cos(turn) * p[1], p[2])
            .normalized();
    CornerPlace place{c, wanted};
    if (c < 4) {
      Index nearest = 0;
      for (Index v = 0; v < m.positions.size(); ++v)
        if ((m.positions[v] - wanted).norm() < (m.positions[nearest] - wanted).norm()) nearest = v;
      place.vertex = nearest;
    }
    places.push_back(place);
  }
  const Construction made =
      construct_on(m.positions, m.triangles, target.graph, target.genus, {.places = places}, host);
  CHECK(made.certificate.valid());
  const PatchGraph graph = make_patch_graph(made.map, host);
  for (const CornerPlace& place : places) {
    const auto at = std::find(graph.corners.begin(), graph.corners.end(), target.graph.corners[place.corner]);
    REQUIRE(at != graph.corners.end());
    const Index v = graph.corner_vertices[static_cast<std::size_t>(at - graph.corners.begin())];
    if (place.vertex != no_index) {
      CHECK(v == place.vertex);
    } else {
      // On the sphere's triangles, below the sphere itself by the square of their size.
      CHECK((made.map.positions[v] - place.point).norm() < 0.02);
    }
  }
  CHECK(made.distortion.angle_mean < 1.5);
  const auto with = [&](const CornerPlace& place) {
    const std::vector<CornerPlace> wrong = {places[0], place};
    return kind_of([&] { construct_on(m.positions, m.triangles, target.graph, 0, {.places = wrong}, host); });
  };
  CHECK(with({8, Vector3::Zero()}) == "invalid-argument");
  CHECK(with({0, Vector3::Zero()}) == "invalid-argument");
  CHECK(with({1, Vector3::Zero(), 1'000'000}) == "invalid-argument");
  CHECK(with({1, Vector3::Zero(), places[0].vertex}) == "invalid-argument");
  CHECK(with({1, Vector3(INFINITY, 0, 0)}) == "invalid-argument");
}

TEST_CASE("A polycube of another genus is refused, and one in another pose is drawn by its own points") {
  const mesh::Mesh m = shape("sphere", 800);
  const TargetPolycube target = target_of(ring);
  CHECK(kind_of([&] { construct_on(m.positions, m.triangles, target.graph, target.genus, {}, host); }) ==
        "wrong-genus");
  // A bar that is long along x for a shape that is long along z.
  mesh::Mesh bar = m;
  for (Vector3& p : bar.positions)
    p[2] *= 3;
  const TargetPolycube box = target_of(test::box_without({3, 1, 1}));
  std::vector<Vector3> pose;
  for (const Vector3& c : box.graph.corners)
    pose.emplace_back(c[1] - 0.5, c[2] - 0.5, 2 * c[0] - 3);
  const Construction turned = construct_on(bar.positions, bar.triangles, box.graph, 0, {.pose = pose}, host);
  CHECK(turned.certificate.valid());
  // Unlike without the pose, where boxes are all that is known.
  const Construction plain = construct_on(bar.positions, bar.triangles, box.graph, 0, {}, host);
  CHECK(turned.distortion.area_mean + turned.distortion.angle_mean <
        plain.distortion.area_mean + plain.distortion.angle_mean);
}
