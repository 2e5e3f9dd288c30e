// Polycubes of solids with cavities: where they are put, and the maps and hexahedra that come of them.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <vector>

#include "base/error.h"
#include "hexmesh/strategies/hex_meshing.h"
#include "mesh/search/measures.h"
#include "mesh/shapes/make_shape.h"
#include "tests/base/quiet_host.h"
#include "tests/volume_map/block_solid.h"
#include "volume_map/solid/cavity_placement.h"
#include "volume_map/solid/solid_polycube.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;
using orbicube::test::host;
using volume_map::test::BlockSolid;

namespace {

// Blocks of a cube of three without the middle one.
std::vector<volume_map::test::Block> shell() {
  constexpr int size = 3;
  std::vector<volume_map::test::Block> blocks;
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      for (int z = 0; z < size; ++z) {
        if (std::min({x, y, z}) == 0 || std::max({x, y, z}) == size - 1) blocks.push_back({x, y, z});
      }
    }
  }
  return blocks;
}

}  // namespace

TEST_CASE("A cavity is placed where the map of the surface around it has it, turned and scaled as that is") {
  // The outer map moves all of space by one affine map; the cavity's own polycube is another turn and scale of it.
  const Eigen::Matrix3d outer_turn = Eigen::AngleAxisd(M_PI / 2, Vector3::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3d own_turn =
      (Eigen::AngleAxisd(M_PI / 2, Vector3::UnitX()) * Eigen::AngleAxisd(M_PI, Vector3::UnitY())).toRotationMatrix();
  const Eigen::Matrix3d exact = outer_turn.array().round(), own = own_turn.array().round();
  BlockSolid outer(volume_map::test::angle, 4, 0, 0), cavity({{0, 0, 0}}, 3, 0, 0);
  const Vector3 stretch(2, 3, 2.5), shift(7, -1, 2);
  const auto wanted = [&](const Vector3& p) { return Vector3(exact * stretch.cwiseProduct(p) + shift); };
  for (std::size_t v = 0; v < outer.map.positions.size(); ++v)
    outer.map.polycube[v] = wanted(outer.map.positions[v]);
  for (std::size_t v = 0; v < cavity.map.positions.size(); ++v) {
    Vector3& p = cavity.map.positions[v];
    p = Vector3(0.4, 0.3, 0.5) + 0.2 * p;
    cavity.map.polycube[v] = own * (5 * p) + Vector3(1, 2, 3);
  }
  const CavityPlacement placement = place_cavity(outer.map, cavity.map, host);
  // Mean value coordinates reproduce affine maps, so that nothing is left.
  for (std::size_t v = 0; v < cavity.map.positions.size(); ++v)
    CHECK((placement(cavity.map.polycube[v]) - wanted(cavity.map.positions[v])).norm() < 1e-9);
  CHECK((placement.turn - exact * own.transpose()).norm() == 0);
}

TEST_CASE("A bent solid with a cavity has a certified polycube, a map to it and hexahedra between both walls") {
  const BlockSolid block(shell(), 3, 0.5, 0.2);
  REQUIRE(block.certificate == "");
  const std::size_t outer = block.map.polycube.size();
  const polycube::Construction made =
      construct_polycube(std::span(block.positions).first(outer), block.surface, {}, host);
  CHECK(made.certificate.valid());
  CHECK(made.certificate.cavities == 1);
  // Vertices of the surface keep their numbers, what is added lies on its triangles.
  CHECK(made.map.positions.size() >= outer);
  CHECK(std::equal(made.map.positions.begin(), made.map.positions.begin() + static_cast<std::ptrdiff_t>(outer),
                   block.positions.begin()));
  for (std::size_t v = 0; v < made.map.positions.size(); ++v) {
    const polycube::VertexSource& source = made.map.vertex_sources[v];
    Vector3 p = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      if (source.corner[k] != no_index) p += source.weight[k] * block.positions[source.corner[k]];
    }
    CHECK((p - made.map.positions[v]).norm() < 1e-12);
  }
  for (std::size_t i = 0; i < made.map.triangles.size(); ++i) {
    const mesh::Triangle &t = made.map.triangles[i], &from = block.surface[made.map.triangle_sources[i]];
    const auto normal = [](const auto& p, const mesh::Triangle& of) {
      return Vector3((p[of[1]] - p[of[0]]).cross(p[of[2]] - p[of[0]]));
    };
    CHECK(normal(made.map.positions, t).dot(normal(block.positions, from)) > 0);
  }

  const VolumeMap map = map_to_polycube({block.positions, block.tetrahedra, block.surface, made.map}, host);
  CHECK(untangle::count_inverted(map.tetrahedra, map.image, host).count == 0);
  CHECK(untangle::count_inverted(map.tetrahedra, map.source, host).count == 0);

  const HexResult hexes = make_hexahedra({made.map}, {.cells = 800, .rounds = 16, .distance = 3}, host);
  CHECK(hexes.quality.valid());
  CHECK(hexes.quality.min_scaled_jacobian > 0.3);
  CHECK(hexes.distance < 3);
  CHECK(!hexes.grid_based);
  // Both walls are covered.
  double volume = 0;
  for (const Tetrahedron& t : block.tetrahedra)
    volume += untangle::six_volumes(block.positions, t) / 6;
  CHECK(hexes.quality.volume == doctest::Approx(volume).epsilon(0.03));
}

TEST_CASE(
    "Of two round cavities side by side the second is made smaller on the polycube, where their boxes would meet") {
  mesh::Mesh all = mesh::make_shape("cube", {.triangles = 300}, host);
  const mesh::Mesh ball = mesh::make_shape("sphere", {.triangles = 300}, host);
  const mesh::Measures box = mesh::measures(all.positions, all.triangles, host),
                       round = mesh::measures(ball.positions, ball.triangles, host);
  const Vector3 middle = 0.5 * (box.low + box.high), center = 0.5 * (round.low + round.high);
  const double radius = 0.5 * (round.high - round.low).maxCoeff(), size = (box.high - box.low).maxCoeff();
  // Apart by a fiftieth of their radius along a diagonal.
  const auto outer = static_cast<Index>(all.positions.size());
  for (const double side : {-1.0, 1.0}) {
    const auto first = static_cast<Index>(all.positions.size());
    const double r = 0.15 * size;
    const Vector3 at = middle + side * 1.01 * r * Vector3(1, 1, 0).normalized();
    for (const Vector3& p : ball.positions)
      all.positions.push_back(at + r / radius * (p - center));
    for (const mesh::Triangle& t : ball.triangles)
      all.triangles.push_back({first + t[0], first + t[2], first + t[1]});
  }
  const polycube::Construction made = construct_polycube(all.positions, all.triangles, {}, host);
  CHECK(made.certificate.valid());
  CHECK(made.certificate.cavities == 2);
  CHECK(made.certificate.corners == 24);
  const std::size_t each = ball.positions.size();
  const auto extent = [&](std::size_t begin) {
    Vector3 low = made.map.polycube[begin], high = low;
    for (std::size_t v = begin; v < begin + each; ++v) {
      low = low.cwiseMin(made.map.polycube[v]);
      high = high.cwiseMax(made.map.polycube[v]);
    }
    return (high - low).norm();
  };
  CHECK(extent(outer + each) < 0.9 * extent(outer));

  // A wall that is inward-oriented beside the solid, not within it.
  mesh::Mesh beside = mesh::make_shape("cube", {.triangles = 300}, host);
  const auto first = static_cast<Index>(beside.positions.size());
  for (const Vector3& p : ball.positions)
    beside.positions.push_back(p + 9 * size * Vector3::UnitX());
  for (const mesh::Triangle& t : ball.triangles)
    beside.triangles.push_back({first + t[0], first + t[2], first + t[1]});
  std::string reason;
  try {
    construct_polycube(beside.positions, beside.triangles, {}, host);
  } catch (const base::Error& error) {
    reason = error.what();
  }
  CHECK(reason.find("does not fit") != std::string::npos);
}
