// Meshes of hexahedra that lie over themselves are found out though each hexahedron is positive.
#include "hexmesh/certificate/hex_embedding.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bent_bar.h"
#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/strategies/hex_draft.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;
using orbicube::test::host;

namespace {

// A cube of cells, with a hole of given cells in the middle.
HexMesh box(int n, int hole, double scale, const Vector3& shift) {
  std::vector<std::uint8_t> inside;
  const int begin = (n - hole) / 2, end = begin + hole;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      for (int z = 0; z < n; ++z) {
        const bool out = x >= begin && x < end && y >= begin && y < end && z >= begin && z < end;
        inside.push_back(out ? 0 : 1);
      }
    }
  }
  HexMesh mesh = hexahedra_of_cells({n, n, n}, inside, host);
  for (Vector3& p : mesh.positions)
    p = scale * p + shift;
  return mesh;
}

HexQuality together(const HexMesh& a, const HexMesh& b) {
  std::vector<Vector3> positions(a.positions.begin(), a.positions.end());
  std::vector<Hexahedron> hexahedra(a.hexahedra.begin(), a.hexahedra.end());
  std::vector<Quad> quads(a.quads.begin(), a.quads.end());
  const auto first = static_cast<Index>(positions.size());
  positions.insert(positions.end(), b.positions.begin(), b.positions.end());
  for (Hexahedron h : b.hexahedra) {
    for (Index& v : h)
      v += first;
    hexahedra.push_back(h);
  }
  for (Quad q : b.quads) {
    for (Index& v : q)
      v += first;
    quads.push_back(q);
  }
  HexQuality quality = measure_hexahedra(positions, hexahedra, host);
  measure_embedding(positions, quads, quality, host);
  return quality;
}

}  // namespace

TEST_CASE("A bar that is bent by more than a turn lies over itself though all its hexahedra are positive") {
  for (const double turns : {0.9, 0.99, 1.01, 1.2}) {
    const HexMesh mesh = hexmesh::test::bent_bar(60, 1, 2 * std::numbers::pi * turns, host);
    HexQuality quality = measure_hexahedra(mesh.positions, mesh.hexahedra, host);
    CHECK(quality.positive());
    measure_embedding(mesh.positions, mesh.quads, quality, host);
    CHECK((quality.intersections > 0) == (turns > 1));
    CHECK(quality.valid() == (turns < 1));
    if (turns > 1) CHECK(what_is_wrong(quality).find("meets itself") != std::string::npos);
  }
}

TEST_CASE("Boxes may lie in the cavities of others, but not in their solid nor with their walls through these") {
  const HexMesh hollow = box(6, 4, 1, Vector3::Zero());
  CHECK(together(hollow, box(2, 0, 1, Vector3(2, 2, 2))).valid());                         // in the cavity
  CHECK(together(hollow, box(2, 0, 1, Vector3(7, 0, 0))).valid());                         // beside it
  const HexQuality inside = together(hollow, box(2, 0, 0.25, Vector3(0.25, 0.25, 0.25)));  // within a wall
  CHECK(inside.intersections == 0);
  CHECK(inside.misplaced_parts == 1);
  CHECK_FALSE(inside.valid());
  CHECK(what_is_wrong(inside).find("wrong side") != std::string::npos);
  CHECK(together(hollow, box(2, 0, 1, Vector3(0.5, 2, 2))).intersections > 0);  // through a wall
  // The wall of a cavity outside of its own solid: the cavity of another place.
  HexMesh turned = box(6, 4, 1, Vector3::Zero());
  CHECK(together(turned, box(8, 2, 0.1, Vector3(2.5, 2.5, 2.5))).valid());
}
