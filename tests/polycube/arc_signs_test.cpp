// Signs of arcs against the convexity of edges of polycubes that are known: a cube, an L, a bump, a hole, a torus with
// a bump, a notch.
#include "polycube/labels/arc_signs.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "blocks.h"
#include "polycube/labels/patch_order.h"
#include "polycube/map/certificate.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::blocks;
using test::box_without;
using test::host;

namespace {

struct Labelled {
  explicit Labelled(const mesh::Mesh& m, bool mirrored = false)
      : certificate(certify(m.positions, m.triangles, host)),
        surface(Array<Vector3>(m.positions), Array<Triangle>(m.triangles), host),
        labels(certificate.labels) {
    for (AxisLabel& label : labels) {
      if (mirrored && axis_of(label) == 0) label = opposite(label);
    }
    patches = find_patches(surface, labels, host);
  }

  // Whether an arc is convex in space: the neighbor's triangle lies below the plane of the arc's own.
  bool is_convex(const ArcNetwork& network, const Arc& arc) const {
    const Index h = network.half_edges_of(arc).front();
    const Index apex = surface.start(mesh::Connectivity::previous(surface.opposite(h)));
    return surface.normals[h / 3].dot(surface.positions[apex] - surface.positions[surface.start(h)]) < 0;
  }

  Certificate certificate;
  Surface surface;
  Array<AxisLabel> labels;
  Patches patches{host.memory};
};

std::vector<mesh::Mesh> shapes_with_signs() {
  std::vector<test::Cell> bump = box_without({3, 3, 1});
  bump.push_back({1, 1, 1});
  std::vector<test::Cell> torus_with_bump = box_without({5, 5, 1}, {{2, 2, 0}});
  torus_with_bump.push_back({0, 2, 1});
  return {blocks(box_without({1, 1, 1})),
          blocks(box_without({2, 2, 1}, {{1, 1, 0}})),
          blocks(bump),
          blocks(box_without({3, 3, 3}, {{1, 1, 0}, {1, 1, 1}, {1, 1, 2}})),
          blocks(box_without({3, 3, 1}, {{1, 1, 0}})),
          blocks(torus_with_bump),
          blocks(box_without({2, 2, 2}, {{1, 1, 1}})),
          blocks(box_without({3, 3, 2}, {{1, 1, 1}}))};
}

}  // namespace

TEST_CASE("The signs of a polycube's own edges obey the rules, and are kept when they are the targets") {
  for (const mesh::Mesh& m : shapes_with_signs()) {
    const Labelled l(m);
    REQUIRE(l.certificate.valid());
    const ArcNetwork network(l.surface, l.patches, host);
    Array<double> wanted(host.memory);
    for (const Arc& arc : network.arcs)
      wanted.push_back(l.is_convex(network, arc) ? 1 : -1);
    const ArcSigns signs = find_arc_signs(l.patches, l.surface, network, wanted, 1, host);
    CHECK(signs.consistent());
    CHECK(signs.changed == 0);
    CHECK(signs.violation == 0);
  }
}

TEST_CASE("An arc runs in the direction that its sign says") {
  for (const mesh::Mesh& m : shapes_with_signs()) {
    const Labelled l(m);
    const ArcNetwork network(l.surface, l.patches, host);
    for (const Arc& arc : network.arcs) {
      const double way = l.surface.positions[arc.last][arc.axis] - l.surface.positions[arc.first][arc.axis];
      CHECK((way * arc.direction_if_convex > 0) == l.is_convex(network, arc));
      CHECK(arc.length == doctest::Approx(std::abs(way)));
    }
  }
}

TEST_CASE("Corners: chi, and their number for each genus") {
  for (const mesh::Mesh& m : shapes_with_signs()) {
    const Labelled l(m);
    const ArcNetwork network(l.surface, l.patches, host);
    std::int64_t sum = 0;
    for (const Corner& corner : network.corners) {
      sum += corner.chirality;
      std::size_t convex = 0;
      for (const Index arc : corner.arc)
        convex += l.is_convex(network, network.arcs[arc]);
      CHECK((corner.chirality > 0) == (convex == 0 || convex == 3));
    }
    CHECK(sum == 8 * (1 - l.certificate.genus));
  }
}

TEST_CASE("Signs are found though others are the targets") {
  for (const mesh::Mesh& m : shapes_with_signs()) {
    const Labelled l(m);
    const ArcNetwork network(l.surface, l.patches, host);
    const Array<double> wanted(network.arcs.size(), 0.01, host.memory);  // all convex
    const ArcSigns signs = find_arc_signs(l.patches, l.surface, network, wanted, 1, host);
    CHECK(signs.consistent());
    CHECK((signs.changed > 0) == !std::all_of(network.arcs.begin(), network.arcs.end(),
                                              [&](const Arc& arc) { return l.is_convex(network, arc); }));
    // At corners of chi = 1 all are the same, at others one differs.
    for (const Corner& corner : network.corners) {
      const int convex = signs.convex[corner.arc[0]] + signs.convex[corner.arc[1]] + signs.convex[corner.arc[2]];
      CHECK((corner.chirality > 0) == (convex % 3 == 0));
    }
  }
}

TEST_CASE("The labels of a cube seen in a mirror are those of no polycube") {
  const Labelled l(blocks(box_without({1, 1, 1})), true);
  CHECK(find_faults(l.surface, l.patches).total() == 0);  // though no local rule says so
  const ArcNetwork network(l.surface, l.patches, host);
  const Array<double> wanted(network.arcs.size(), 1, host.memory);
  const ArcSigns signs = find_arc_signs(l.patches, l.surface, network, wanted, 1, host);
  CHECK(!signs.consistent());
  CHECK(signs.violation > 0);
}

TEST_CASE("Patches of a polycube have an order, and none when an arc runs the other way than those beside it") {
  for (const mesh::Mesh& m : shapes_with_signs()) {
    const Labelled l(m);
    const ArcNetwork network(l.surface, l.patches, host);
    ArcSigns signs(host.memory);
    for (const Arc& arc : network.arcs)
      signs.convex.push_back(l.is_convex(network, arc));
    CHECK(arcs_without_order(l.patches, network, signs, host).empty());
  }
  const Labelled cube(blocks(box_without({1, 1, 1})));
  const ArcNetwork network(cube.surface, cube.patches, host);
  REQUIRE(network.arcs.size() == 12);
  for (Index turned = 0; turned < 12; ++turned) {
    ArcSigns signs(host.memory);
    signs.convex.assign(12, 1);
    signs.convex[turned] = 0;
    const Array<Index> left = arcs_without_order(cube.patches, network, signs, host);
    CHECK(left.size() == 4);  // those along its axis
    for (const Index a : left)
      CHECK(network.arcs[a].axis == network.arcs[turned].axis);
  }
}
