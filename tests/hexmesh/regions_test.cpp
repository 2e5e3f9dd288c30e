// Faces of hexahedra on the faces between the regions of a solid: two and three regions that meet in planes, a ball in
// a box, and what the regions of a solid of tetrahedra share.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "hexmesh/hexmesh.h"
#include "hexmesh/regions/region_interfaces.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using orbicube::test::host;

namespace {

// A box of cubes, each in six tetrahedra, whose regions are those of the centers of the cubes, and whose vertices are
// moved where `bend` has them.
mesh::Mesh box_of_regions(
    std::array<int, 3> cubes, double edge, const std::function<std::int32_t(const Vector3&)>& region,
    const std::function<Vector3(const Vector3&)>& bend = [](const Vector3& p) { return p; }) {
  mesh::Mesh solid;
  const auto number = [&](const std::array<int, 3>& at) {
    return static_cast<Index>((at[0] * (cubes[1] + 1) + at[1]) * (cubes[2] + 1) + at[2]);
  };
  for (int i = 0; i <= cubes[0]; ++i)
    for (int j = 0; j <= cubes[1]; ++j)
      for (int k = 0; k <= cubes[2]; ++k)
        solid.positions.push_back(bend(edge * Vector3(i, j, k)));
  for (int i = 0; i < cubes[0]; ++i) {
    for (int j = 0; j < cubes[1]; ++j) {
      for (int k = 0; k < cubes[2]; ++k) {
        std::array<std::size_t, 3> order = {0, 1, 2};
        do {
          std::array<int, 3> at = {i, j, k};
          Tetrahedron t{};
          t[0] = number(at);
          for (std::size_t d = 0; d < 3; ++d) {
            ++at[order[d]];
            t[d + 1] = number(at);
          }
          const auto& p = solid.positions;
          if ((p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).dot(p[t[3]] - p[t[0]]) < 0) std::swap(t[2], t[3]);
          solid.tetrahedra.push_back(t);
          solid.regions.tetrahedra.push_back(region(edge * Vector3(i + 0.5, j + 0.5, k + 0.5)));
        } while (std::next_permutation(order.begin(), order.end()));
      }
    }
  }
  return solid;
}

Hexahedra hexahedra_of(const mesh::Mesh& solid, std::size_t cells, Method method, const base::Host& with = host) {
  volume_map::InputFindings findings;
  Options options;
  options.method = method;
  options.cells = cells;
  options.distance = 0;
  return make_hexahedra(solid, options, findings, with);
}

std::map<std::int32_t, double> volumes(const Hexahedra& made) {
  std::map<std::int32_t, double> volume;
  const HexMesh& mesh = made.result.mesh;
  REQUIRE(made.regions);
  REQUIRE(made.regions->of_hexahedra.size() == mesh.hexahedra.size());
  for (std::size_t i = 0; i < mesh.hexahedra.size(); ++i)
    volume[made.regions->of_hexahedra[i]] +=
        measure_hexahedra(mesh.positions, std::span(&mesh.hexahedra[i], 1), host).volume;
  return volume;
}

// No vertex of a hexahedron is on the other side of the plane between its region and others.
void check_sides(const Hexahedra& made, std::int32_t region, const Vector3& normal, double offset) {
  constexpr double rounding = 1e-12;
  double farthest = 0;
  for (std::size_t i = 0; i < made.result.mesh.hexahedra.size(); ++i) {
    for (const Index v : made.result.mesh.hexahedra[i]) {
      const double side = normal.dot(made.result.mesh.positions[v]) - offset;
      farthest = std::max(farthest, made.regions->of_hexahedra[i] == region ? side : -side);
    }
  }
  CHECK(farthest <= rounding);
}

}  // namespace

TEST_CASE("Regions know the faces, the curves and the points in which they meet, and with the outside") {
  const mesh::Mesh solid = box_of_regions({4, 4, 4}, 0.25, [](const Vector3& p) {
    if (p.x() < 0.5) return 7;
    return p.y() < 0.5 ? -3 : 12;
  });
  RegionInterfaces interfaces(solid.positions, solid.tetrahedra, solid.regions.tetrahedra, host);
  CHECK(interfaces.any());
  REQUIRE(interfaces.numbers().size() == 3);
  CHECK(interfaces.label_of(-3) == 1);
  CHECK(interfaces.label_of(7) == 2);
  CHECK(interfaces.label_of(12) == 3);
  CHECK(interfaces.between_regions().size() == 2 * (16 + 8));
  CHECK(interfaces.meet(1, 3));
  CHECK(interfaces.meet(0, 2));
  const auto face = interfaces.nearest({1, 2}, {0.7, 0.9, 0.3}, Vector3::Zero());
  CHECK(face.dimension == 2);
  CHECK((face.position - Vector3(0.5, 0.5, 0.3)).norm() < 1e-15);
  CHECK(std::abs(face.direction.x()) == doctest::Approx(1));
  const auto curve = interfaces.nearest({1, 2, 3}, {0.9, 0.8, 0.3}, Vector3::Zero());
  CHECK(curve.dimension == 1);
  CHECK((curve.position - Vector3(0.5, 0.5, 0.3)).norm() < 1e-15);
  const auto point = interfaces.nearest({0, 1, 2, 3}, {0.4, 0.4, 0.3}, Vector3::Zero());
  CHECK(point.dimension == 0);
  CHECK(point.position == Vector3(0.5, 0.5, 0));
  const mesh::Mesh one = box_of_regions({2, 2, 2}, 0.5, [](const Vector3&) { return 4; });
  CHECK_FALSE(RegionInterfaces(one.positions, one.tetrahedra, one.regions.tetrahedra, host).any());
}

TEST_CASE("A plane between two regions is one of faces, wherever the cells would have theirs") {
  constexpr double plane = 6.0 / 7;  // no multiple of the length of a cell
  const mesh::Mesh solid = box_of_regions({14, 7, 7}, 1.0 / 7, [](const Vector3& p) { return p.x() < plane ? 1 : 2; });
  const Hexahedra made = hexahedra_of(solid, 300, Method::automatic);
  REQUIRE(made.regions);
  CHECK(made.regions->conforming);
  CHECK(made.result.quality.valid());
  CHECK(made.result.quality.min_scaled_jacobian > 0.9);
  CHECK(made.regions->distance < 1e-10);
  check_sides(made, 1, Vector3::UnitX(), plane);
  const auto volume = volumes(made);
  // Maps along frames, which this box is filled along, are solved to that.
  CHECK(volume.at(1) == doctest::Approx(plane).epsilon(1e-7));
  CHECK(volume.at(2) == doctest::Approx(2 - plane).epsilon(1e-7));
}

TEST_CASE("A sloping plane between regions gets sheets of hexahedra, as do three regions that meet in a line") {
  const auto sheared = [](const Vector3& p) {
    return Vector3(p.x() + 0.35 * (p.x() * (2 - p.x())) * (p.y() - 0.5), p.y(), p.z());
  };
  const mesh::Mesh solid = box_of_regions(
      {8, 4, 4}, 0.25, [](const Vector3& p) { return p.x() < 1 ? 1 : 2; }, sheared);
  const Hexahedra made = hexahedra_of(solid, 1000, Method::automatic);
  REQUIRE(made.regions);
  CHECK(made.regions->conforming);
  CHECK(made.result.quality.valid());
  CHECK(made.result.quality.min_scaled_jacobian > 0.3);
  check_sides(made, 1, Vector3(1, -0.35, 0), 1 - 0.175);
  const auto volume = volumes(made);
  CHECK(volume.at(1) == doctest::Approx(1).epsilon(1e-7));

  const mesh::Mesh three = box_of_regions({8, 4, 4}, 0.25, [](const Vector3& p) {
    if (p.x() < 0.75) return 1;
    return p.y() < 0.25 ? 2 : 3;
  });
  const Hexahedra of_three = hexahedra_of(three, 1000, Method::automatic);
  REQUIRE(of_three.regions);
  CHECK(of_three.regions->conforming);
  CHECK(of_three.result.quality.valid());
  const auto volume_of_three = volumes(of_three);
  CHECK(volume_of_three.at(1) == doctest::Approx(0.75).epsilon(1e-7));
  CHECK(volume_of_three.at(2) == doctest::Approx(1.25 / 4).epsilon(1e-7));
  CHECK(volume_of_three.at(3) == doctest::Approx(1.25 * 3 / 4).epsilon(1e-7));
}

TEST_CASE("A region inside another one gets a closed surface of faces") {
  const mesh::Mesh solid = box_of_regions({6, 6, 6}, 1.0 / 6, [](const Vector3& p) {
    return (p - Vector3(0.5, 0.5, 0.5)).lpNorm<Eigen::Infinity>() < 1.0 / 6 ? 5 : 0;
  });
  // Cells along the sides have edges beside those of the inner cube, cells of the grid do not: they round them.
  for (const Method method : {Method::automatic, Method::grid}) {
    const Hexahedra made = hexahedra_of(solid, 1500, method);
    REQUIRE(made.regions);
    CHECK(made.regions->conforming);
    CHECK(made.result.quality.valid());
    CHECK(made.regions->interface_quads >= 24);
    const auto volume = volumes(made);
    CHECK(volume.at(5) == doctest::Approx(1.0 / 27).epsilon(method == Method::grid ? 0.1 : 1e-9));
    if (method != Method::grid) CHECK(made.regions->distance < 1e-9);
    CHECK(volume.at(5) + volume.at(0) == doctest::Approx(made.result.quality.volume));
  }
}

TEST_CASE("Solids of one region have its number on all hexahedra, and no mesh other than without regions") {
  mesh::Mesh solid = box_of_regions({3, 3, 3}, 1.0 / 3, [](const Vector3&) { return 9; });
  const Hexahedra with = hexahedra_of(solid, 100, Method::automatic);
  REQUIRE(with.regions);
  CHECK_FALSE(with.regions->conforming);
  CHECK(std::all_of(with.regions->of_hexahedra.begin(), with.regions->of_hexahedra.end(),
                    [](std::int32_t region) { return region == 9; }));
  solid.regions.tetrahedra.clear();
  const Hexahedra without = hexahedra_of(solid, 100, Method::automatic);
  CHECK_FALSE(without.regions);
  CHECK(std::equal(with.result.mesh.positions.begin(), with.result.mesh.positions.end(),
                   without.result.mesh.positions.begin(), without.result.mesh.positions.end()));
}

TEST_CASE("A region thinner than cells is named as lost, and the mesh is what it was") {
  const mesh::Mesh solid = box_of_regions(
      {2, 2, 24}, 0.5, [](const Vector3& p) { return p.z() > 6 && p.z() < 6.5 ? 2 : 1; },
      [](const Vector3& p) { return Vector3(p.x(), p.y(), p.z() / 12); });
  const Hexahedra made = hexahedra_of(solid, 27, Method::polycube);
  REQUIRE(made.regions);
  CHECK(made.regions->lost == 1);
  CHECK_FALSE(made.regions->conforming);
  CHECK(made.result.quality.valid());
}

TEST_CASE("The same bits for any number of threads, with regions") {
  const mesh::Mesh solid = box_of_regions(
      {6, 3, 3}, 1.0 / 3, [](const Vector3& p) { return p.x() < 1 ? 1 : 2; },
      [](const Vector3& p) { return Vector3(p.x() + 0.2 * p.y(), p.y(), p.z()); });
  base::Host one, two;
  one.thread_count = 1;
  two.thread_count = 2;
  const Hexahedra a = hexahedra_of(solid, 400, Method::automatic, one);
  const Hexahedra b = hexahedra_of(solid, 400, Method::automatic, two);
  CHECK(std::equal(a.result.mesh.positions.begin(), a.result.mesh.positions.end(), b.result.mesh.positions.begin(),
                   b.result.mesh.positions.end()));
  CHECK(std::equal(a.regions->of_hexahedra.begin(), a.regions->of_hexahedra.end(), b.regions->of_hexahedra.begin(),
                   b.regions->of_hexahedra.end()));
}
