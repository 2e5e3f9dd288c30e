// Patches, graph cuts and repairs of labels.
#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "blocks.h"
#include "mesh/shapes/make_shape.h"
#include "polycube/labels/label_repair.h"
#include "polycube/map/certificate.h"
#include "polycube/surface/refinement.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::blocks;
using test::box_without;
using test::host;

TEST_CASE("Patches of a plate with a hole: two with a hole each, no faults") {
  const mesh::Mesh m = blocks(box_without({3, 3, 1}, {{1, 1, 0}}));
  const Certificate certificate = certify(m.positions, m.triangles, host);
  const Surface surface = test::surface_of(m, host);
  const Patches patches = find_patches(surface, certificate.labels, host);
  CHECK(patches.count() == 10);
  CHECK(patches.loop_count() == 12);
  for (std::size_t c = 0; c < patches.count(); ++c) {
    CHECK(!patches.has_handles(c));
    CHECK(patches.loops_of(c) == (axis_of(patches.labels[c]) == 2 ? 2 : 1));
    if (axis_of(patches.labels[c]) == 2) CHECK(patches.areas[c] == doctest::Approx(8));
  }
  const LabelFaults faults = find_faults(surface, patches);
  CHECK(faults.total() == 0);
  CHECK(faults.corners == 16);
}

TEST_CASE("Faults are counted") {
  const mesh::Mesh m = blocks(box_without({3, 3, 3}));
  const Surface surface = test::surface_of(m, host);
  Array<AxisLabel> labels = certify(m.positions, m.triangles, host).labels;
  labels[0] = opposite(labels[0]);
  LabelFaults faults = find_faults(surface, find_patches(surface, labels, host));
  CHECK(faults.opposite_edges > 0);
  CHECK(faults.short_loops > 0);
  std::fill(labels.begin(), labels.end(), AxisLabel{2});
  faults = find_faults(surface, find_patches(surface, labels, host));
  CHECK(faults.missing == 1);
  const mesh::Mesh ring = blocks(box_without({3, 3, 1}, {{1, 1, 0}}));
  const Surface torus = test::surface_of(ring, host);
  labels.assign(ring.triangles.size(), AxisLabel{0});
  labels[0] = 2;
  faults = find_faults(torus, find_patches(torus, labels, host));
  CHECK(faults.handles == 1);
}

TEST_CASE("No expansion of a label improves the labels that expansion ends with") {
  const mesh::Mesh m = blocks({{0, 0, 0}});
  const Surface surface = test::surface_of(m, host);
  const std::size_t count = m.triangles.size();
  base::Random random(3);
  for (int round = 0; round < 20; ++round) {
    LabelCosts costs = label_costs(surface, surface.normals, 0, host);
    for (auto& data : costs.data) {
      for (double& d : data)
        d = random.unit();
    }
    for (Index h = 0; h < 3 * count; ++h) {
      if (h < surface.opposite(h)) costs.boundary[h] = costs.boundary[surface.opposite(h)] = 0.6 * random.unit();
    }
    Array<AxisLabel> labels(count, AxisLabel{0}, host.memory);
    expand_labels(surface, costs, {}, 100, labels, host);
    const double reached = label_energy(surface, costs, labels);
    double best = reached;
    for (AxisLabel alpha = 0; alpha < label_count; ++alpha) {
      for (std::size_t mask = 0; mask < std::size_t{1} << count; ++mask) {
        Array<AxisLabel> other(labels, host.memory);
        for (std::size_t i = 0; i < count; ++i)
          other[i] = mask >> i & 1 ? alpha : labels[i];
        best = std::min(best, label_energy(surface, costs, other));
      }
    }
    CHECK(reached <= best + 1e-12);
  }
}

TEST_CASE("Triangles that are not free keep their labels") {
  const mesh::Mesh m = blocks(box_without({2, 2, 2}));
  const Surface surface = test::surface_of(m, host);
  const LabelCosts costs = label_costs(surface, surface.normals, 0.01, host);
  Array<AxisLabel> labels(m.triangles.size(), AxisLabel{0}, host.memory);
  Array<std::uint8_t> free(m.triangles.size(), 0, host.memory);
  for (std::size_t i = 0; i < free.size(); i += 2)
    free[i] = 1;
  expand_labels(surface, costs, free, 5, labels, host);
  bool changed = false;
  for (std::size_t i = 0; i < free.size(); ++i) {
    CHECK((free[i] || labels[i] == 0));
    changed = changed || labels[i] != 0;
  }
  CHECK(changed);
}

TEST_CASE("Labels of made shapes are without faults after repair") {
  for (const char* name : {"sphere", "bracket", "torus", "creature"}) {
    const mesh::Mesh m = mesh::make_shape(name, {.triangles = 2000, .seed = 1}, host);
    const Surface surface = test::surface_of(m, host);
    for (const double compactness : {0.005, 0.04}) {
      LabelCosts costs = label_costs(surface, surface.normals, compactness, host);
      Array<AxisLabel> labels(host.memory);
      for (Index i = 0; i < m.triangles.size(); ++i)
        labels.push_back(best_label(costs, i));
      expand_labels(surface, costs, {}, 5, labels, host);
      const LabelFaults faults = repair_labels(surface, costs, 60, labels, host);
      INFO(name, " ", compactness);
      CHECK(faults.total() == 0);
      CHECK(find_faults(surface, find_patches(surface, labels, host)).total() == 0);
    }
  }
}

TEST_CASE("Split chords leave no chord, new vertices lie where their sources say, and the surface is the same") {
  const mesh::Mesh m = blocks(box_without({2, 2, 1}, {{1, 1, 0}}));
  const Array<AxisLabel> labels = certify(m.positions, m.triangles, host).labels;
  SurfaceMap map = unrefined(m.positions, m.triangles, labels, host);
  split_chords(map, host);
  CHECK(std::equal(m.positions.begin(), m.positions.end(), map.positions.begin()));
  CHECK(map.positions.size() > m.positions.size());
  for (std::size_t v = 0; v < map.positions.size(); ++v) {
    Vector3 p = Vector3::Zero();
    double sum = 0;
    for (std::size_t k = 0; k < 3 && map.vertex_sources[v].corner[k] != no_index; ++k) {
      p += map.vertex_sources[v].weight[k] * m.positions[map.vertex_sources[v].corner[k]];
      sum += map.vertex_sources[v].weight[k];
      CHECK(map.vertex_sources[v].weight[k] > 0);
    }
    CHECK(sum == 1);  // halves of halves: exact
    CHECK(p == map.positions[v]);
  }
  const Surface surface(Array<Vector3>(map.positions), Array<Triangle>(map.triangles), host);
  CHECK(surface.area == doctest::Approx(14));
  const Patches patches = find_patches(surface, map.labels, host);
  for (Index h = 0; h < 3 * map.triangles.size(); ++h) {
    if (map.labels[h / 3] != map.labels[surface.neighbor(h)]) continue;
    CHECK((patches.valence[surface.start(h)] == 0 || patches.valence[surface.end(h)] == 0));
  }
  for (std::size_t i = 0; i < map.triangles.size(); ++i)
    CHECK(map.labels[i] == labels[map.triangle_sources[i]]);
  SurfaceMap identity = map;
  identity.polycube = map.positions;
  CHECK(certify(identity, host).valid());
}
