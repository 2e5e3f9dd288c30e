// Polycubes with integer planes.
#include "hexmesh/grid/integer_domain.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "polycube/outputs/patch_graph.h"
#include "tests/volume_map/block_solid.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using volume_map::test::BlockSolid;

TEST_CASE("Planes of a polycube get integers near to their positions, and cells of the given number") {
  const BlockSolid block({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}}, 2, 0, 0);
  const base::Host host;
  const auto graph = polycube::make_patch_graph(block.map, host);
  const IntegerDomain domain(graph, 0.25, host);
  CHECK(domain.size(0) == 12);
  CHECK(domain.size(1) == 8);
  CHECK(domain.size(2) == 4);
  CHECK(domain.cells() == 4 * 64);
  CHECK(domain.faces() == 18 * 16);
  CHECK(domain.inside({11, 7, 0}));
  CHECK(!domain.inside({7, 4, 0}));
  CHECK(!domain.inside({12, 0, 0}));
  CHECK(domain.place(Vector3(2, 1, 0.5)) == Vector3(8, 4, 2));
  const IntegerDomain coarse(graph, 100, host);
  CHECK(coarse.cells() == 3);  // one between neighboring planes
  for (const std::size_t wanted : {100U, 1000U, 20000U}) {
    const auto cells = static_cast<double>(domain_of_cells(graph, wanted, false, host).cells());
    CHECK(cells > 0.6 * static_cast<double>(wanted));
    CHECK(cells < 1.6 * static_cast<double>(wanted));
    const IntegerDomain padded = domain_of_cells(graph, wanted, true, host);
    CHECK(static_cast<double>(padded.cells() + padded.faces()) < 1.6 * static_cast<double>(wanted));
  }
  CHECK_THROWS_AS(IntegerDomain(graph, 0, host), base::Error);
  CHECK_THROWS_AS(IntegerDomain(graph, 1e-4, host), base::Error);
}
