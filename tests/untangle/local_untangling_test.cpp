// Inverted elements untangled in their neighborhoods: positive by exact signs, and nothing elsewhere has moved.
#include "untangle/tetrahedra/local_untangling.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "tangled_cases.h"

using namespace orbicube;
using namespace orbicube::untangle;

namespace {

// A bar of cubes whose boundary stays, with vertices inside pushed through what is around them.
struct Case {
  test::BlockMesh mesh{test::bar(6), 6};
  std::vector<Vector3> start = mesh.positions;
  std::vector<std::uint8_t> fixed;
  std::vector<std::size_t> pushed;

  explicit Case(std::initializer_list<double> where) {
    for (std::size_t v = 0; v < start.size(); ++v)
      fixed.insert(fixed.end(), 3, mesh.on_boundary(v) ? 1 : 0);
    for (const double x : where) {
      const auto v = static_cast<std::size_t>(
          std::find_if(start.begin(), start.end(),
                       [&](const Vector3& p) { return (p - Vector3(x, 0.5, 0.5)).norm() < 1e-9; }) -
          start.begin());
      REQUIRE(v < start.size());
      pushed.push_back(v);
      start[v] += Vector3(0.3, 0.1, -0.05);
    }
  }
  Array<Element> elements(const base::Host& host) const {
    return elements_of(mesh.tetrahedra, mesh.positions, 1, host);
  }
  std::size_t inverted(std::span<const Vector3> p) const {
    std::size_t count = 0;
    for (const Tetrahedron& t : mesh.tetrahedra)
      count += mesh::orientation_3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) > 0 ? 0 : 1;
    return count;
  }
};

}  // namespace

TEST_CASE("Neighborhoods are untangled and the rest stays to the bit, with any number of threads") {
  const Case c({1.0, 4.0});
  REQUIRE(c.inverted(c.start) > 0);
  std::vector<Vector3> first;
  for (const unsigned threads : {1U, 3U}) {
    base::Host host;
    host.thread_count = threads;
    std::vector<Vector3> positions = c.start;
    const LocalUntangling result = untangle_locally(c.elements(host), c.fixed, 1, 100, positions, host);
    CHECK(result.done);
    CHECK(result.steps > 0);
    CHECK(result.jammed.empty());
    CHECK(c.inverted(positions) == 0);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      if (positions[v] == c.start[v]) continue;
      ++moved;
      CHECK_FALSE(c.mesh.on_boundary(v));
      // The middle between both, three units away, is in no neighborhood.
      CHECK(std::abs(positions[v][0] - 2.5) > 0.4);
    }
    CHECK(moved > 2);
    if (first.empty()) first = positions;
    CHECK(first == positions);
  }
}

TEST_CASE("What cannot be untangled stays as it was and is distinguished from what can") {
  Case c({1.0, 4.0});
  // Nothing next to the first may move, and it alone is at fault; the second is free.
  for (std::size_t v = 0; v < c.start.size(); ++v) {
    if (c.start[v][0] < 2) std::fill_n(c.fixed.begin() + static_cast<std::ptrdiff_t>(3 * v), 3, std::uint8_t{1});
  }
  std::vector<std::size_t> next;
  for (const Tetrahedron& t : c.mesh.tetrahedra) {
    if (std::find(t.begin(), t.end(), c.pushed[0]) != t.end()) next.insert(next.end(), t.begin(), t.end());
  }
  const std::size_t beside = *std::find_if(next.begin(), next.end(), [&](std::size_t v) { return v != c.pushed[0]; });
  std::fill_n(c.fixed.begin() + static_cast<std::ptrdiff_t>(3 * beside), 3, std::uint8_t{0});
  const base::Host host;
  std::vector<Vector3> positions = c.start;
  const LocalUntangling result = untangle_locally(c.elements(host), c.fixed, 1, 100, positions, host);
  CHECK_FALSE(result.done);
  REQUIRE(result.jammed.size() == positions.size());
  CHECK(result.jammed[c.pushed[0]] == 1);
  CHECK(result.jammed[c.pushed[1]] == 0);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (c.start[v][0] < 2) CHECK(positions[v] == c.start[v]);
  }
  CHECK(positions[c.pushed[1]] != c.start[c.pushed[1]]);
  CHECK(c.inverted(positions) > 0);
  CHECK(c.inverted(positions) < c.inverted(c.start));
}

TEST_CASE("Where all that is inverted is fixed, or most of the mesh is, neighborhoods are not tried") {
  Case held({1.0});
  std::fill(held.fixed.begin(), held.fixed.end(), std::uint8_t{1});
  const base::Host host;
  std::vector<Vector3> positions = held.start;
  LocalUntangling result = untangle_locally(held.elements(host), held.fixed, 1, 100, positions, host);
  CHECK_FALSE(result.done);
  CHECK(result.steps == 0);
  CHECK(positions == held.start);

  Case mirrored({});
  for (Vector3& p : mirrored.start)
    p[0] = -p[0];
  std::fill(mirrored.fixed.begin(), mirrored.fixed.end(), std::uint8_t{0});
  positions = mirrored.start;
  result = untangle_locally(mirrored.elements(host), mirrored.fixed, 1, 100, positions, host);
  CHECK_FALSE(result.done);
  CHECK(result.jammed.empty());
  CHECK(positions == mirrored.start);
}
