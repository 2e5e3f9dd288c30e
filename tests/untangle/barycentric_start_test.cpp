// Meshes that a scrambled start leaves inverted are untangled from the means of neighbors.
#include "untangle/barycentric_start.h"

#include <doctest/doctest.h>

#include <set>

#include "feasible_flat.h"
#include "feasible_solid.h"

using namespace orbicube;
using namespace orbicube::untangle;

TEST_CASE("Scrambled stars are untangled from the means of neighbors") {
  for (std::uint64_t seed = 20; seed < 45; ++seed) {
    const test::FeasibleFlat flat = test::feasible_flat(3, seed);
    CHECK(untangle_triangles(flat.mesh(), {}, base::Host()).inverted == 0);
    const test::FeasibleSolid solid = test::feasible_solid(3, seed);
    CHECK(untangle_tetrahedra(solid.mesh(), {}, base::Host()).inverted == 0);
  }
}

TEST_CASE("Free coordinates become the means of their neighbors, and fixed ones stay") {
  const test::FeasibleSolid c = test::feasible_solid(3, 2);
  const Variables variables(c.start, c.fixed, {}, std::pmr::get_default_resource());
  std::vector<double> values(variables.start().begin(), variables.start().end());
  REQUIRE(start_barycentric(c.tetrahedra, variables, values, base::Host()));
  std::vector<std::set<Index>> neighbors(c.start.size());
  for (const Tetrahedron& t : c.tetrahedra) {
    for (const Index v : t)
      neighbors[v].insert(t.begin(), t.end());
  }
  for (std::size_t v = 0; v < c.start.size(); ++v) {
    for (std::size_t a = 0; a < 3; ++a) {
      const double value = values[variables.of(v, a)];
      if (c.fixed[3 * v + a] != 0) {
        CHECK(value == c.start[v][static_cast<Eigen::Index>(a)]);
        continue;
      }
      double sum = 0;
      for (const Index w : neighbors[v])
        sum += w != v ? values[variables.of(w, a)] : 0;
      // The system is solved to 1e-10, and anchored by 1e-8 of the start.
      CHECK(value == doctest::Approx(sum / static_cast<double>(neighbors[v].size() - 1)).epsilon(1e-6));
    }
  }
}

TEST_CASE("Where nothing is fixed there are no means to start from") {
  const test::FeasibleSolid c = test::feasible_solid(3, 2);
  const Variables variables(c.start, {}, {}, std::pmr::get_default_resource());
  std::vector<double> values(variables.start().begin(), variables.start().end());
  const std::vector<double> before = values;
  CHECK_FALSE(start_barycentric(c.tetrahedra, variables, values, base::Host()));
  CHECK(values == before);
}
