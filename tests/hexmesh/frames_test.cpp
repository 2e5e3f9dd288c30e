// Maps that follow frames: the energy and its least, the identity where nothing turns, singular edges on integer lines,
// charts that meet to the bit, and hexahedra; what has no map is named.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <string>

#include "base/error.h"
#include "hexmesh/grid/grid_extraction.h"
#include "hexmesh/strategies/frame_hexes.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/cells.h"
#include "tests/volume_map/block_solid.h"
#include "tests/volume_map/frame_solids.h"
#include "volume_map/frames/frame_energy.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;
using namespace orbicube::volume_map::test;

namespace {

// Faces of charts meet, edges of the boundary and singular ones have the integers that they should have: to the bit.
void check_map(const FrameMap& map) {
  const mesh::TetrahedralConnectivity connectivity(map.solid.positions.size(), map.solid.tetrahedra, base::Host());
  const mesh::EdgeRings rings(connectivity, base::Host());
  const auto corner = [&](Index t, Index v) -> const Vector3& { return map.charts[t][connectivity.corner_of(t, v)]; };
  std::size_t apart = 0, off_plane = 0, off_line = 0, inverted = 0, singular = 0;
  for (Index t = 0; t < map.charts.size(); ++t) {
    const auto& c = map.charts[t];
    inverted += mesh::orientation_3d(c[0], c[1], c[2], c[3]) <= 0;
  }
  for (Index face = 0; face < connectivity.face_count(); ++face) {
    const Index other = connectivity.opposite(face);
    for (const Index v : connectivity.vertices(face)) {
      if (other != no_index) {
        apart += map.transition[face](corner(face / 4, v)) != corner(other / 4, v);
        continue;
      }
      const int axis = map.label[face] / 2;
      const double x = corner(face / 4, v)[axis];
      off_plane += x != std::round(x) || x != corner(face / 4, connectivity.vertices(face)[0])[axis];
    }
    if (other == no_index) CHECK(map.patch[face] < map.patches);
  }
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    if (rings.on_boundary(ring)) continue;
    Transition around;
    for (const Index face : rings.faces(ring))
      around = map.transition[face] * around;
    const Index t = rings.faces(ring).front() / 4;
    const auto [p, q] = rings.vertices(ring);
    if (around == Transition()) continue;
    ++singular;
    CHECK(around.rotation != 0);
    for (int a = 0; a < 3; ++a) {
      if (Transition::source(around.rotation, static_cast<std::size_t>(a)) == static_cast<std::size_t>(a)) continue;
      const double x = corner(t, p)[a];
      off_line += x != std::round(x) || x != corner(t, q)[a];
    }
  }
  CHECK(apart == 0);
  CHECK(off_plane == 0);
  CHECK(off_line == 0);
  CHECK(inverted == 0);
  CHECK(singular == map.singular_edges);
}

void check_hexahedra(const HexMesh& hexes) {
  mesh::Mesh cells;
  cells.positions.assign(hexes.positions.begin(), hexes.positions.end());
  cells.hexahedra.assign(hexes.hexahedra.begin(), hexes.hexahedra.end());
  CHECK_NOTHROW(mesh::require_valid_cells(cells, base::Host()));
  CHECK(mesh::boundary_triangles(cells, base::Host()).size() == 2 * hexes.quads.size());
}

double total_energy(const FramedSolid& solid, const FrameCut& cut, double cell_length, std::span<const double> x) {
  double sum = 0;
  for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t) {
    std::array<Vector3, 4> p;
    Eigen::Matrix<double, 4, 3> c;
    for (std::size_t k = 0; k < 4; ++k) {
      p[k] = solid.positions[solid.tetrahedra[t][k]];
      for (std::size_t a = 0; a < 3; ++a)
        c(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(a)) = x[3 * std::size_t{cut.copies[t][k]} + a];
    }
    const Quaternion& q = cut.frames[t];
    sum += frame_energy(p, Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix(), cell_length, c);
  }
  return sum;
}

std::string reason_of(const FramedSolid& solid, double cell_length) {
  try {
    map_by_frames(solid, {.cell_length = cell_length}, base::Host());
  } catch (const base::Error& error) {
    return std::string(error.kind()) + ": " + error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the derivative of the energy is that of differences") {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    std::array<Vector3, 4> p;
    Eigen::Matrix<double, 4, 3> x, derivative;
    do {
      for (Vector3& v : p)
        v = Vector3(normal(random), normal(random), normal(random));
    } while ((p[1] - p[0]).dot((p[2] - p[0]).cross(p[3] - p[0])) < 0.5);
    for (Eigen::Index i = 0; i < 12; ++i)
      x.data()[i] = normal(random);
    const Eigen::Matrix3d frame = Eigen::Quaterniond(Eigen::Vector4d(normal(random), normal(random), normal(random), 1))
                                      .normalized()
                                      .toRotationMatrix();
    frame_energy(p, frame, 0.7, x, &derivative);
    for (Eigen::Index i = 0; i < 12; ++i) {
      // A quadratic: differences to both sides are exact but for rounding.
      Eigen::Matrix<double, 4, 3> up = x, down = x;
      up.data()[i] += 0.5;
      down.data()[i] -= 0.5;
      CHECK(frame_energy(p, frame, 0.7, up) - frame_energy(p, frame, 0.7, down) ==
            doctest::Approx(derivative.data()[i]).epsilon(1e-9));
    }
  }
}

TEST_CASE("the energy with its best free variables is the quadratic in the integers that it says") {
  FramedSolid solid = cylinder(8, 3, 0.8);
  split_for_frames(solid, base::Host());
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, base::Host());
  const mesh::EdgeRings rings(connectivity, base::Host());
  const FrameCut cut = cut_open(connectivity, rings, solid.frames, base::Host());
  const SeamlessSystem system = make_seamless_system(solid.positions, connectivity, rings, cut, base::Host());
  const FrameEnergy energy(solid.positions, solid.tetrahedra, cut, system, 0.2, base::Host());
  CHECK(system.integers >= 5);
  std::vector<double> x(3 * cut.vertex_of_copy.size());
  const auto value = [&](const Eigen::VectorXd& integers, const Eigen::VectorXd& free) {
    expand(system, free, integers, x);
    return total_energy(solid, cut, 0.2, x);
  };
  const Eigen::VectorXd best = energy.best_integers();
  const double least = value(best, energy.free_variables(best));
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 5; ++trial) {
    Eigen::VectorXd integers = best;
    for (double& c : integers)
      c += normal(random);
    Eigen::VectorXd free = energy.free_variables(integers);
    const double above = (integers - best).dot(energy.curvature() * (integers - best));
    CHECK(value(integers, free) - least ==
          doctest::Approx(above).epsilon(1e-4));  // a millionth holds the whole where it is
    const double here = value(integers, free);
    for (double& f : free)
      f += 0.01 * normal(random);
    CHECK(value(integers, free) > here);
  }
}

TEST_CASE("where frames do not turn, a bar is mapped as it is, and no face is cut") {
  const FramedSolid solid = framed(BlockMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 2));
  const FrameMap map = map_by_frames(solid, {.cell_length = 0.25}, base::Host());
  check_map(map);
  CHECK(map.sheets == 0);
  CHECK(map.integers == 6);
  CHECK(map.integers_optimal);
  CHECK(map.inverted_at_start == 0);
  const Vector3 shift = map.charts[0][0] - 4 * map.solid.positions[map.solid.tetrahedra[0][0]];
  double off = 0;
  for (std::size_t t = 0; t < map.charts.size(); ++t) {
    for (std::size_t k = 0; k < 4; ++k)
      off = std::max(off, (map.charts[t][k] - 4 * map.solid.positions[map.solid.tetrahedra[t][k]] - shift).norm());
  }
  // What is left when steps gain less than a thousandth of the energy.
  CHECK(off < 0.05);
  const HexMesh hexes = extract_hexahedra(map, base::Host());
  CHECK(hexes.hexahedra.size() == 12 * 4 * 4);
  CHECK(hexes.quads.size() == 2 * (12 * 4 + 12 * 4 + 4 * 4));
  check_hexahedra(hexes);
}

TEST_CASE("frames named again by any of the 24 rotations give the same grid") {
  FramedSolid solid = framed(BlockMesh(angle, 2));
  const FrameMap plain = map_by_frames(solid, {.cell_length = 0.25}, base::Host());
  std::mt19937_64 random(6);
  for (Quaternion& q : solid.frames)
    q = quaternion::multiply(q, quaternion::cube_group.element[random() % 24]);
  const FrameMap turned = map_by_frames(solid, {.cell_length = 0.25}, base::Host());
  check_map(turned);
  CHECK(turned.singular_edges == 0);
  CHECK(turned.sheets == 0);
  CHECK(extract_hexahedra(turned, base::Host()).hexahedra.size() ==
        extract_hexahedra(plain, base::Host()).hexahedra.size());
  CHECK(extract_hexahedra(plain, base::Host()).hexahedra.size() == 3 * 64);
}

TEST_CASE("around a hole the cut has a gap of its own") {
  std::vector<Block> blocks;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i != 1 || j != 1) blocks.push_back({i, j, 0});
    }
  }
  const FrameMap map = map_by_frames(framed(BlockMesh(blocks, 2)), {.cell_length = 0.5}, base::Host());
  check_map(map);
  CHECK(map.sheets >= 1);
  CHECK(extract_hexahedra(map, base::Host()).hexahedra.size() == 8 * 8);
}

TEST_CASE("a cylinder has four inner curves around which cells meet in threes") {
  const FramedSolid solid = cylinder(8, 4, 1.2);
  const FrameHexes made = make_hexahedra_by_frames(solid, {.cells = 300, .rounds = 10, .distance = 0}, base::Host());
  check_map(made.map);
  CHECK(made.map.singular_edges >= 4 * 4);
  CHECK(made.map.sheets >= 1);
  CHECK(made.map.patches == 3);
  check_hexahedra(made.result.mesh);
  CHECK(made.result.quality.valid());
  CHECK(made.result.quality.min_scaled_jacobian > 0.3);
  // As many as there are layers, four times.
  CHECK(made.inner_irregular_edges % 4 == 0);
  CHECK(made.inner_irregular_edges >= 4 * 2);
  double volume = 0;
  for (const Tetrahedron& t : solid.tetrahedra)
    volume += untangle::six_volumes(solid.positions, t) / 6;
  CHECK(made.result.quality.volume == doctest::Approx(volume).epsilon(0.03));
}

TEST_CASE("hexahedra along frames are as near to the solid as requested, with more cells where it takes them") {
  const FramedSolid solid = cylinder(8, 4, 1.2);
  const auto made_with = [&](double distance) {
    FrameHexes made = make_hexahedra_by_frames(solid, {.cells = 120, .rounds = 10, .distance = distance}, base::Host());
    check_hexahedra(made.result.mesh);
    CHECK(made.result.quality.valid());
    return made;
  };
  const HexResult as_it_comes = made_with(0).result;
  const double off = std::max(as_it_comes.distance, as_it_comes.volume_error);
  REQUIRE(off > 1.5);
  // The target is satisfied already.
  CHECK(made_with(1.1 * off).result.mesh.positions == as_it_comes.mesh.positions);
  const HexResult near = made_with(1).result;
  CHECK(near.distance <= 1);
  CHECK(near.volume_error <= 1);
  CHECK(near.mesh.hexahedra.size() > as_it_comes.mesh.hexahedra.size());
}

TEST_CASE("hexahedra along frames follow the surface that the solid is a coarser version of") {
  const FramedSolid solid = cylinder(6, 4, 1.2);
  // Its boundary a little larger all over, which hexahedra of the solid alone are too far from.
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, base::Host());
  Array<mesh::Triangle> triangles;
  for (Index face = 0; face < connectivity.face_count(); ++face)
    if (connectivity.on_boundary(face)) triangles.push_back(connectivity.vertices(face));
  Array<Vector3> positions = solid.positions;
  for (Vector3& p : positions)
    p *= 1.03;
  FrameHexOptions options = {.cells = 300, .rounds = 20, .distance = 0};
  options.fine_positions = positions;
  options.fine_triangles = triangles;
  const HexResult made = make_hexahedra_by_frames(solid, options, base::Host()).result;
  CHECK(made.quality.valid());
  double volume = 0;
  for (const Tetrahedron& t : solid.tetrahedra)
    volume += untangle::six_volumes(positions, t) / 6;
  CHECK(made.volume_error == doctest::Approx(100 * std::abs(made.quality.volume / volume - 1)));
  CHECK(made.quality.volume == doctest::Approx(volume).epsilon(0.03));
}

TEST_CASE("a coarse ring has a field that a map can follow, with singular curves that keep off the boundary") {
  const FramedSolid solid = ring(4, 16, 0.4);
  const FrameHexes made = make_hexahedra_along_frames(solid.positions, solid.tetrahedra, 0,
                                                      {.cells = 300, .rounds = 10, .distance = 0}, base::Host());
  CHECK(made.fields >= 1);
  check_map(made.map);
  check_hexahedra(made.result.mesh);
  CHECK(made.result.quality.valid());
  CHECK(made.map.patches == 1);
  CHECK(made.inner_irregular_edges > 0);
  double volume = 0;
  for (const Tetrahedron& t : solid.tetrahedra)
    volume += untangle::six_volumes(solid.positions, t) / 6;
  CHECK(made.result.quality.volume == doctest::Approx(volume).epsilon(0.15));  // few and large cells
}

TEST_CASE("the same bits for any number of threads") {
  const FramedSolid solid = cylinder(6, 3, 1);
  std::optional<FrameHexes> first;
  for (const unsigned threads : {1U, 3U}) {
    base::Host host;
    host.thread_count = threads;
    FrameHexes made = make_hexahedra_by_frames(solid, {.cells = 120, .rounds = 4, .distance = 0}, host);
    if (!first) {
      first.emplace(std::move(made));
      continue;
    }
    CHECK(made.result.mesh.positions == first->result.mesh.positions);
    CHECK(made.result.mesh.hexahedra == first->result.mesh.hexahedra);
    CHECK(made.map.charts == first->map.charts);
  }
}

TEST_CASE("fields that no map has are named, with the place") {
  FramedSolid solid = cylinder(6, 3, 1);
  for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t) {
    Vector3 centre = Vector3::Zero();
    for (const Index v : solid.tetrahedra[t])
      centre += 0.25 * solid.positions[v];
    // About the axis (1 1 1) by a third of the angle around a line: a singular curve of third turns.
    const double turn = std::atan2(centre[1], centre[0]) / 3;
    const double s = std::sin(0.5 * turn) / std::sqrt(3.0);
    solid.frames[t] = {std::cos(0.5 * turn), s, s, s};
  }
  const std::string third = reason_of(solid, 0.3);
  CHECK(third.find("no-valid-result") == 0);
  CHECK(third.find("third of a turn") != std::string::npos);
  CHECK(third.find("curve") != std::string::npos);
  // Half a turn around the same line.
  for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t) {
    Vector3 centre = Vector3::Zero();
    for (const Index v : solid.tetrahedra[t])
      centre += 0.25 * solid.positions[v];
    const double turn = std::atan2(centre[1], centre[0]) / 2;
    solid.frames[t] = {std::cos(0.5 * turn), 0, 0, std::sin(0.5 * turn)};
  }
  CHECK(reason_of(solid, 0.3).find("half a turn about an axis") != std::string::npos);
}

TEST_CASE("wrong arguments are refused") {
  FramedSolid solid = framed(BlockMesh({{0, 0, 0}}, 1));
  CHECK(reason_of(solid, 0).find("invalid-argument") == 0);
  CHECK(reason_of(solid, -1).find("invalid-argument") == 0);
  solid.frames.pop_back();
  CHECK(reason_of(solid, 1).find("invalid-argument") == 0);
  CHECK_THROWS_AS(make_hexahedra_by_frames(framed(BlockMesh({{0, 0, 0}}, 1)), {.cells = 0}, base::Host()), base::Error);
}
