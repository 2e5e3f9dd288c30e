// Surfaces decimated and brought back, with labels and with maps.
#include "polycube/surface/decimation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "blocks.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/topology.h"
#include "polycube/labels/label_repair.h"
#include "polycube/labels/label_smoothing.h"
#include "polycube/map/certificate.h"
#include "polycube/map/map_refinement.h"
#include "polycube/surface/distortion.h"
#include "polycube/surface/refinement.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::blocks;
using test::box_without;
using test::host;

namespace {

mesh::Mesh left_by(const Decimation& decimation, const mesh::Mesh& m) {
  mesh::Mesh result;
  result.positions = m.positions;
  for (const Index t : decimation.left)
    result.triangles.push_back(decimation.triangles[t]);
  return result;
}

Array<AxisLabel> good_labels(const Surface& surface, double compactness) {
  LabelCosts costs = label_costs(surface, surface.normals, compactness, host);
  Array<AxisLabel> labels(host.memory);
  for (Index i = 0; i < surface.triangles.size(); ++i)
    labels.push_back(best_label(costs, i));
  expand_labels(surface, costs, {}, 5, labels, host);
  REQUIRE(repair_labels(surface, costs, 60, labels, host).total() == 0);
  return labels;
}

// What must not change: patches by label, loops, corners.
struct Combinatorics {
  Combinatorics(const Surface& surface, std::span<const AxisLabel> labels)
      : patches(find_patches(surface, labels, host)), faults(find_faults(surface, patches)) {
    for (std::size_t l = 0; l < patches.loop_count(); ++l)
      corners_of_loops.push_back(corners_of_loop(surface, patches, l));
    std::sort(corners_of_loops.begin(), corners_of_loops.end());
    patch_labels.assign(patches.labels.begin(), patches.labels.end());
    std::sort(patch_labels.begin(), patch_labels.end());
  }
  bool operator==(const Combinatorics& other) const {
    return corners_of_loops == other.corners_of_loops && patch_labels == other.patch_labels &&
           faults.corners == other.faults.corners && faults.total() == other.faults.total();
  }

  Patches patches;
  LabelFaults faults;
  std::vector<std::size_t> corners_of_loops;
  std::vector<AxisLabel> patch_labels;
};

}  // namespace

TEST_CASE("Every surface on the way down is a closed manifold of the same genus, and undoing brings all back") {
  for (const char* name : {"bracket", "torus", "creature"}) {
    const mesh::Mesh m = mesh::make_shape(name, {.triangles = 3000, .seed = 2}, host);
    const Surface surface = test::surface_of(m, host);
    const auto genus = mesh::topology(m.positions, m.triangles, host).genus;
    Decimation decimation = decimate(surface, {}, 300, host);
    CHECK(decimation.left.size() <= 302);
    const mesh::Mesh small = left_by(decimation, m);
    const mesh::Topology facts = mesh::topology(small.positions, small.triangles, host);
    CHECK(facts.closed());
    CHECK(facts.manifold());
    CHECK(facts.inconsistent_edges == 0);
    CHECK(facts.genus == genus);
    for (std::size_t i = decimation.collapses.size(); i-- > 0;)
      decimation.undo(decimation.collapses[i]);
    CHECK(decimation.triangles == m.triangles);
    for (Index h = 0; h < decimation.opposite.size(); ++h)
      CHECK(decimation.opposite[h] == surface.opposite(h));
  }
}

TEST_CASE("Labels that come back with the triangles, and smoothed ones, have the patches, loops and corners they had") {
  for (const char* name : {"bracket", "torus", "creature"}) {
    const mesh::Mesh m = mesh::make_shape(name, {.triangles = 4000, .seed = 2}, host);
    const Surface surface = test::surface_of(m, host);
    const Decimation decimation = decimate(surface, {}, 1000, host);
    const Surface small = test::surface_of(left_by(decimation, m), host);
    const Array<AxisLabel> small_labels = good_labels(small, 0.02);
    const Combinatorics expected(small, small_labels);
    Array<AxisLabel> labels(m.triangles.size(), host.memory);
    for (std::size_t i = 0; i < small_labels.size(); ++i)
      labels[decimation.left[i]] = small_labels[i];
    const LabelCosts costs = label_costs(surface, surface.normals, 0.02, host);
    undo_labels(decimation, costs.data, labels);
    CHECK(Combinatorics(surface, labels) == expected);
    const double before = label_energy(surface, costs, labels);
    smooth_labels(surface, costs, 30, labels, host);
    CHECK(label_energy(surface, costs, labels) < before);
    CHECK(Combinatorics(surface, labels) == expected);
  }
}

TEST_CASE("Decimation with labels keeps patches and makes no chords") {
  const mesh::Mesh m = mesh::make_shape("bracket", {.triangles = 4000, .seed = 2}, host);
  const Surface surface = test::surface_of(m, host);
  SurfaceMap map = unrefined(m.positions, m.triangles, good_labels(surface, 0.02), host);
  split_chords(map, host);
  const Surface refined(Array<Vector3>(map.positions), Array<Triangle>(map.triangles), host);
  const Combinatorics expected(refined, map.labels);
  const Decimation decimation = decimate(refined, map.labels, 500, host);
  CHECK(decimation.left.size() < 1500);
  mesh::Mesh whole;
  whole.positions = map.positions;
  const Surface small = test::surface_of(left_by(decimation, whole), host);
  Array<AxisLabel> labels(host.memory);
  for (const Index t : decimation.left)
    labels.push_back(AxisLabel{map.labels[t]});
  const Combinatorics found(small, labels);
  CHECK(found == expected);
  for (Index h = 0; h < 3 * small.triangles.size(); ++h) {
    if (labels[h / 3] != labels[small.neighbor(h)]) continue;
    CHECK((found.patches.valence[small.start(h)] == 0 || found.patches.valence[small.end(h)] == 0));
  }
}

TEST_CASE("A polycube's map to itself stays that when it is refined") {
  // Each square in four and again, so that there is something to decimate.
  const mesh::Mesh m = blocks(box_without({8, 8, 4}, {{7, 7, 0}, {7, 7, 1}, {7, 7, 2}, {7, 7, 3}}));
  SurfaceMap map = unrefined(m.positions, m.triangles, certify(m.positions, m.triangles, host).labels, host);
  split_chords(map, host);
  constexpr double scale = 1.0 / 16;  // to about unit area
  Array<Vector3> positions(host.memory);
  for (const Vector3& p : map.positions)
    positions.push_back(scale * p);
  const Surface surface(Array<Vector3>(positions), Array<Triangle>(map.triangles), host);
  Decimation decimation = decimate(surface, map.labels, 100, host);
  REQUIRE(decimation.left.size() < map.triangles.size() / 2);
  map.polycube.assign(map.positions.size(), Vector3::Constant(std::nan("")));
  for (const Index t : decimation.left) {
    for (const Index v : decimation.triangles[t])
      map.polycube[v] = positions[v];
  }
  refine_map(surface, map.labels, decimation, 1, 10, map.polycube, host);
  CHECK(certify(map, host).valid());
  const Distortion d = measure_distortion(map, host);
  // The optimum is the identity, of distortion 1; the sweeps are relaxations, which come near it.
  CHECK(d.angle_mean < 1.02);
  CHECK(d.area_mean < 1.02);
}
