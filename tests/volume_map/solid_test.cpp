// Solids mapped to polycubes: nothing inverted, the boundary on the polycube; and the steps on the way there.
#include <doctest/doctest.h>

#include <set>

#include "base/error.h"
#include "block_solid.h"
#include "mesh/search/predicates.h"
#include "untangle/tetrahedra/elements.h"
#include "untangle/tetrahedra/untangle_tetrahedra.h"
#include "volume_map/solid/boundary_refinement.h"
#include "volume_map/solid/freeing_splits.h"

using namespace orbicube;
using namespace orbicube::volume_map;

namespace {

template <class Positions, class Cells>
double volume_of(const Positions& positions, const Cells& cells) {
  double sum = 0;
  for (const Tetrahedron& t : cells)
    sum += untangle::six_volumes(positions, t) / 6;
  return sum;
}

}  // namespace

TEST_CASE(
    "After splits each tetrahedron has at most a face in common with the boundary, and nothing else has changed") {
  const volume_map::test::BlockSolid block(volume_map::test::angle, 1, 0, 0);
  Array<Vector3> positions(block.positions.begin(), block.positions.end());
  Array<Tetrahedron> tetrahedra(block.tetrahedra.begin(), block.tetrahedra.end());
  const base::Host host;
  const std::size_t outer = block.map.positions.size();
  const std::size_t added = split_for_freedom(positions, tetrahedra, host);
  CHECK(added > 0);
  CHECK(positions.size() == block.positions.size() + added);
  CHECK(untangle::count_inverted(tetrahedra, positions, host).count == 0);
  CHECK(volume_of(positions, tetrahedra) == doctest::Approx(3));
  std::set<std::set<Index>> faces;
  for (const mesh::Triangle& t : block.surface)
    faces.insert({t[0], t[1], t[2]});
  std::size_t walls = 0;
  for (const Tetrahedron& t : tetrahedra) {
    std::set<Index> on_boundary;
    for (const Index v : t) {
      if (v < outer) on_boundary.insert(v);
    }
    CHECK(on_boundary.size() < 4);
    if (on_boundary.size() != 3) continue;
    CHECK(faces.count(on_boundary) == 1);
    ++walls;
  }
  CHECK(walls >= block.surface.size());
}

TEST_CASE("A solid is cut where its surface is") {
  volume_map::test::BlockSolid block(volume_map::test::angle, 2, 0.5, 0.3);
  REQUIRE(block.certificate == "");
  for (const std::size_t triangle : {0U, 17U, 30U})
    block.cut(triangle);
  REQUIRE(block.certificate == "");
  const base::Host host;
  const RefinedSolid refined = refine_boundary(block.positions, block.tetrahedra, block.surface, block.map, host);
  CHECK(untangle::count_inverted(refined.tetrahedra, refined.positions, host).count == 0);
  CHECK(volume_of(refined.positions, refined.tetrahedra) ==
        doctest::Approx(volume_of(block.positions, block.tetrahedra)));
  CHECK(std::equal(block.map.positions.begin(), block.map.positions.end(), refined.positions.begin()));
  // Each triangle of the map is a face of one tetrahedron.
  std::map<std::set<Index>, int> uses;
  for (const Tetrahedron& t : refined.tetrahedra) {
    for (std::size_t k = 0; k < 4; ++k) {
      std::set<Index> face(t.begin(), t.end());
      face.erase(t[k]);
      ++uses[face];
    }
  }
  std::size_t once = 0;
  for (const auto& [face, count] : uses) {
    CHECK(count <= 2);
    once += count == 1;
  }
  CHECK(once == block.map.triangles.size());
  for (const mesh::Triangle& t : block.map.triangles)
    CHECK(uses.at({t[0], t[1], t[2]}) == 1);
}

TEST_CASE("A bent solid is mapped to its polycube one to one, the same for any number of threads") {
  volume_map::test::BlockSolid block(volume_map::test::angle, 3, 0.8, 0.4);
  block.cut(5);
  REQUIRE(block.certificate == "");
  std::vector<Vector3> first;
  for (const unsigned threads : {1U, 3U}) {
    base::Host host;
    host.thread_count = threads;
    const VolumeMap map = map_to_polycube(block.solid(), host);
    CHECK(untangle::count_inverted(map.tetrahedra, map.image, host).count == 0);
    CHECK(untangle::count_inverted(map.tetrahedra, map.source, host).count == 0);
    CHECK(volume_of(map.image, map.tetrahedra) == doctest::Approx(3).epsilon(1e-12));
    for (std::size_t v = 0; v < block.map.positions.size(); ++v)
      CHECK(map.source[v] == block.map.positions[v]);
    for (std::size_t i = 0; i < block.map.triangles.size(); ++i) {
      const int axis = polycube::axis_of(block.map.labels[i]);
      for (const Index v : block.map.triangles[i])
        CHECK(map.image[v][axis] == block.map.polycube[v][axis]);
    }
    if (first.empty()) first.assign(map.image.begin(), map.image.end());
    CHECK(std::equal(first.begin(), first.end(), map.image.begin(), map.image.end()));
  }
}

TEST_CASE("A surface that is not the boundary is refused") {
  volume_map::test::BlockSolid block(volume_map::test::angle, 2, 0, 0);
  block.tetrahedra.pop_back();
  CHECK_THROWS_AS(map_to_polycube(block.solid(), base::Host()), base::Error);
}
