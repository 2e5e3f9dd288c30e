// Maps of labeled surfaces. A polycube is its own best map, so the optimum is known: no distortion at all.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "blocks.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/topology.h"
#include "polycube/labels/label_construction.h"
#include "polycube/labels/label_search.h"
#include "polycube/labels/normal_turning.h"
#include "polycube/map/labelled_map.h"
#include "polycube/map/labelled_target.h"
#include "polycube/map/untangling.h"
#include "polycube/surface/distortion.h"
#include "polycube/surface/refinement.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::blocks;
using test::box_without;
using test::host;

namespace {

std::vector<mesh::Mesh> shapes_to_label() {
  std::vector<test::Cell> bump = box_without({3, 3, 1});
  bump.push_back({1, 1, 1});
  return {blocks(box_without({2, 2, 2})), blocks(box_without({2, 2, 1}, {{1, 1, 0}})), blocks(bump),
          blocks(box_without({3, 3, 1}, {{1, 1, 0}})), blocks(box_without({5, 3, 1}, {{1, 1, 0}, {3, 1, 0}}))};
}

}  // namespace

TEST_CASE("A labeled polycube is mapped to itself") {
  for (const mesh::Mesh& m : shapes_to_label()) {
    const Certificate own = certify(m.positions, m.triangles, host);
    SurfaceMap map = unrefined(m.positions, m.triangles, own.labels, host);
    LabelledMapOptions options;
    options.polishing_steps = 60;
    const LabelledMapOutcome outcome = make_labelled_map(map, unit_frame(m.positions, m.triangles), options, {}, host);
    INFO(outcome.reason);
    REQUIRE(outcome.valid());
    CHECK(outcome.certificate.corners == own.corners);
    CHECK(outcome.certificate.patch_count == own.patch_count);
    CHECK(outcome.certificate.genus == own.genus);
    const Distortion d = measure_distortion(map, host);
    // The optimum is 1; polishing ends when a step gains less than 1e-5 of the energy, which is quadratic there.
    CHECK(d.angle_mean < 1.001);
    CHECK(d.area_mean < 1.001);
    CHECK(d.angle_mean >= 1 - 1e-12);
    CHECK(d.area_mean >= 1 - 1e-12);
  }
}

TEST_CASE("Scrambled positions are untangled") {
  for (const mesh::Mesh& m : shapes_to_label()) {
    SurfaceMap map = unrefined(m.positions, m.triangles, certify(m.positions, m.triangles, host).labels, host);
    split_chords(map, host);
    const Frame frame = unit_frame(m.positions, m.triangles);
    Array<Vector3> positions(host.memory);
    for (const Vector3& p : map.positions)
      positions.push_back(frame(p));
    const Surface surface(Array<Vector3>(positions), Array<Triangle>(map.triangles), host);
    const Patches patches = find_patches(surface, map.labels, host);
    TiedMap tied(surface, patches, host);
    base::Random random(5);
    for (Index v = 0; v < positions.size(); ++v) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        tied.value[tied.variable[v][axis]] = positions[v][static_cast<Eigen::Index>(axis)];
    }
    // By less than half a cell, so that patches keep their order; most triangles are flipped at first.
    for (double& x : tied.value)
      x += 0.8 * frame.scale * (random.unit() - 0.5);
    Untangling untangling(tied, host);
    CHECK(untangling.untangle({}));
    CHECK(untangling.flipped() == 0);
    untangling.polish(100, 1);
    map.polycube.resize(map.positions.size());
    for (Index v = 0; v < map.positions.size(); ++v)
      map.polycube[v] = tied.position(v);
    CHECK(certify(map, host).valid());
    CHECK(measure_distortion(map, host).area_mean < 1.001);  // see above
  }
}

TEST_CASE("A map with triangles flipped is drawn again, with its corners where they are") {
  for (const std::vector<test::Cell>& cells :
       {box_without({2, 2, 2}), box_without({3, 3, 1}, {{2, 2, 0}}), box_without({5, 5, 1}, {{2, 2, 0}})}) {
    const mesh::Mesh m = blocks(cells);
    const Certificate own = certify(m.positions, m.triangles, host);
    SurfaceMap map = unrefined(m.positions, m.triangles, own.labels, host);
    map.polycube.assign(m.positions.begin(), m.positions.end());
    const Surface surface(Array<Vector3>(map.positions), Array<Triangle>(map.triangles), host);
    const Patches patches = find_patches(surface, map.labels, host);
    // One vertex inside a face goes past its neighbors.
    Index moved = 0;
    while (patches.valence[moved] > 0)
      ++moved;
    const Index h = surface.connectivity.outgoing(moved);
    map.polycube[moved] += 3 * (map.positions[surface.end(h)] - map.positions[moved]);
    REQUIRE(!certify(map, host).valid());
    const Construction drawn = draw_labelled(m.positions, m.triangles, map, host);
    CHECK(drawn.certificate.valid());
    CHECK(drawn.certificate.corners == own.corners);
    CHECK(drawn.certificate.patch_count == own.patch_count);
    CHECK(drawn.certificate.genus == own.genus);
    CHECK(std::equal(m.positions.begin(), m.positions.end(), drawn.map.positions.begin()));
    std::size_t corners = 0;
    for (Index v = 0; v < m.positions.size(); ++v) {
      if (!patches.is_corner(v)) continue;
      CHECK(drawn.map.polycube[v] == m.positions[v]);
      ++corners;
    }
    CHECK(corners == own.corners);
  }
}

TEST_CASE("Faces that meet cannot be drawn") {
  const mesh::Mesh m = blocks(box_without({3, 3, 1}, {{1, 1, 0}}));
  SurfaceMap map = unrefined(m.positions, m.triangles, certify(m.positions, m.triangles, host).labels, host);
  map.polycube.assign(m.positions.begin(), m.positions.end());
  for (Vector3& p : map.polycube)
    if (p[2] > 0.5) p[2] = -p[2];  // the top below the bottom
  try {
    draw_labelled(m.positions, m.triangles, map, host);
    FAIL("the solid is inside out");
  } catch (const base::Error& error) {
    CHECK(error.kind() == std::string("unsupported"));
  }
}

TEST_CASE("Normals of a bent bar are turned towards the axes, those of a straight one stay") {
  const auto lean = [](const Array<Vector3>& normals, const Surface& surface) {
    double sum = 0;
    for (Index t = 0; t < normals.size(); ++t) {
      const Vector3 s = normals[t].cwiseProduct(normals[t]);
      sum += surface.areas[t] / surface.area * (s[0] * s[1] + s[1] * s[2] + s[2] * s[0]);
    }
    return sum;
  };
  const mesh::Mesh m = blocks(box_without({2, 2, 20}));
  const Frame frame = unit_frame(m.positions, m.triangles);
  Array<Vector3> straight(host.memory), bent(host.memory);
  for (const Vector3& p : m.positions) {
    straight.push_back(frame(p));
    // A quarter of a circle of radius 40 / pi, ends along z and x.
    const double radius = 40 / std::acos(-1.0), angle = p[2] / radius;
    bent.push_back(frame({radius - (radius - p[0]) * std::cos(angle), p[1], (radius - p[0]) * std::sin(angle)}));
  }
  const Surface bar(std::move(straight), Array<Triangle>(m.triangles), host);
  const Array<Vector3> same = turned_normals(bar, 0.03, host);
  for (Index t = 0; t < same.size(); ++t)
    CHECK((same[t] - bar.normals[t]).norm() < 1e-9);
  const Surface bow(std::move(bent), Array<Triangle>(m.triangles), host);
  const Array<Vector3> turned = turned_normals(bow, 0.03, host);
  CHECK(lean(bow.normals, bow) > 0.05);
  CHECK(lean(turned, bow) < 0.2 * lean(bow.normals, bow));
  for (const Vector3& n : turned)
    CHECK(n.norm() == doctest::Approx(1));
}

TEST_CASE("Labels lose their smallest patches until a budget of corners is kept") {
  std::vector<test::Cell> cells = box_without({6, 6, 2});
  cells.push_back({2, 2, 2});
  const mesh::Mesh m = blocks(cells);
  Array<Vector3> positions(host.memory);
  const Frame frame = unit_frame(m.positions, m.triangles);
  for (const Vector3& p : m.positions)
    positions.push_back(frame(p));
  const Surface surface(std::move(positions), Array<Triangle>(m.triangles), host);
  for (const std::size_t budget : {std::size_t{0}, std::size_t{8}}) {
    LabelCosts costs = label_costs(surface, surface.normals, 0.001, host);
    Array<AxisLabel> labels = certify(m.positions, m.triangles, host).labels;
    REQUIRE(find_faults(surface, find_patches(surface, labels, host)).corners == 16);
    std::size_t max_changes = 100;
    CHECK(search_labels(surface, costs, budget, 0, max_changes, labels, host) == 0);
    const LabelFaults faults = find_faults(surface, find_patches(surface, labels, host));
    CHECK(faults.total() == 0);
    CHECK(faults.corners == (budget == 0 ? 16 : 8));
    CHECK((max_changes == 100) == (budget == 0));
  }
}

TEST_CASE("Constructions by labels are certified, keep the surface and its genus") {
  for (const char* name : {"cube", "sphere", "bracket", "torus"}) {
    const mesh::Mesh m = mesh::make_shape(name, {.triangles = 1500, .seed = 1}, host);
    const Construction made = construct_by_labels(m.positions, m.triangles, {}, host);
    CHECK(made.valid > 0);
    const Certificate again = certify(made.map.polycube, made.map.triangles, host);
    CHECK(again.valid());
    CHECK(again.corners == made.certificate.corners);
    CHECK(again.genus == mesh::topology(m.positions, m.triangles, host).genus);
    CHECK(std::equal(m.positions.begin(), m.positions.end(), made.map.positions.begin()));
    CHECK(made.distortion.angle_mean < 1.5);
    CHECK(made.distortion.area_mean < 1.5);
  }
}

TEST_CASE("A budget of corners is kept, and one that no polycube can keep is an error") {
  const mesh::Mesh m = mesh::make_shape("sphere", {.triangles = 800}, host);
  CHECK(construct_by_labels(m.positions, m.triangles, {.corners = 8}, host).certificate.corners == 8);
  try {
    construct_by_labels(m.positions, m.triangles, {.corners = 7}, host);
    FAIL("no polycube has fewer than eight corners");
  } catch (const base::Error& error) {
    CHECK(error.kind() == std::string("no-valid-result"));
  }
}

TEST_CASE("Results are the same bits in each run") {
  const mesh::Mesh m = mesh::make_shape("bracket", {.triangles = 800}, host);
  const Construction a = construct_by_labels(m.positions, m.triangles, {.corners = 50}, host);
  const Construction b = construct_by_labels(m.positions, m.triangles, {.corners = 50}, host);
  CHECK(a.map.polycube == b.map.polycube);
  CHECK(a.map.triangles == b.map.triangles);
}
