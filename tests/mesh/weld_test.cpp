// Welding vertices at identical positions.
#include "mesh/topology/weld.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>

#include "mesh/topology/topology.h"

using namespace orbicube;
using namespace orbicube::mesh;

TEST_CASE("The first vertex at a position is found as by comparing with all") {
  std::mt19937_64 engine(3);
  std::vector<Vector3> positions;
  for (int i = 0; i < 5000; ++i) {
    const auto number = [&] { return static_cast<double>(engine() % 12) - 6.0; };
    positions.emplace_back(number() * 0.0, number(), number());  // zeros of both signs
  }
  const auto first = first_at_same_position(positions, base::Host());
  std::map<std::array<double, 3>, Index> seen;
  for (Index v = 0; v < positions.size(); ++v) {
    const auto known = seen.emplace(std::array{positions[v].x() + 0.0, positions[v].y(), positions[v].z()}, v).first;
    REQUIRE(first[v] == known->second);
  }
}

TEST_CASE("A cube of loose triangles becomes closed, and the others keep their order") {
  Mesh mesh;
  const std::array<Triangle, 12> corners = {{{0, 2, 1},
                                             {1, 2, 3},
                                             {4, 5, 6},
                                             {5, 7, 6},
                                             {0, 1, 4},
                                             {1, 5, 4},
                                             {2, 6, 3},
                                             {3, 6, 7},
                                             {0, 4, 2},
                                             {2, 4, 6},
                                             {1, 3, 5},
                                             {3, 7, 5}}};
  for (const Triangle& t : corners) {
    const auto n = static_cast<Index>(mesh.positions.size());
    for (const Index v : t)
      mesh.positions.emplace_back(v & 1, v >> 1 & 1, v >> 2 & 1);
    mesh.triangles.push_back({n, n + 1, n + 2});
  }
  mesh.positions.emplace_back(7, 7, 7);
  mesh.triangles.push_back({0, 36, 8});   // collapses? no: vertex 8 is at another place than vertex 0
  mesh.triangles.push_back({0, 36, 12});  // vertices 0 and 12 are at the same place
  mesh.triangles.push_back({5, 5, 5});    // had repeated corners before
  const WeldReport report = weld(mesh, base::Host());
  CHECK(report.vertices == 28);
  CHECK(report.triangles == 1);
  REQUIRE(mesh.triangles.size() == 14);
  CHECK(mesh.triangles[13][0] == mesh.triangles[13][2]);
  REQUIRE(mesh.positions.size() == 9);
  CHECK(mesh.positions[8] == Vector3(7, 7, 7));
  CHECK(mesh.positions[1] == Vector3(0, 1, 0));
  mesh.triangles.resize(12);
  const Topology facts = topology(mesh.positions, mesh.triangles, base::Host());
  CHECK(facts.genus == 0);
  CHECK(facts.volume == doctest::Approx(1));
  CHECK(weld(mesh, base::Host()).vertices == 0);
}
