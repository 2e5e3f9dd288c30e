// Meshes of hexahedra of solids: valid, conforming, on the surface, and as near to it as requested.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "hexmesh/certificate/surface_distance.h"
#include "hexmesh/strategies/hex_meshing.h"
#include "mesh/search/nearest.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/cells.h"
#include "tests/volume_map/block_solid.h"
#include "volume_map/input/coarse_surface.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;
using volume_map::test::BlockSolid;

TEST_CASE(
    "Beside a mesh to beat the first way to fill the polycube is tried, and its worst corners only where it may win") {
  BlockSolid block(volume_map::test::angle, 3, 1.3, 0.8);
  REQUIRE(block.certificate == "");
  struct Attempts {
    std::size_t all = 0, worst_first = 0;
    double least = 0;
  };
  const auto attempts = [&](double to_beat) {
    Attempts seen;
    base::Host host;
    host.on_log = [&](const std::string& line) {
      if (line.find(" hexahedra, polycube") == std::string::npos) return;
      ++seen.all;
      seen.worst_first += line.find("worst corners first") != std::string::npos ? 1U : 0U;
    };
    const HexOptions options = {.method = HexMethod::polycube,
                                .cells = 150,
                                .rounds = 10,
                                .distance = 20,
                                .max_cells = 150,
                                .to_beat = to_beat};
    const HexResult made = make_hexahedra({block.map}, options, host);
    CHECK(made.quality.valid());
    seen.least = made.quality.min_scaled_jacobian;
    return seen;
  };
  const Attempts all = attempts(0), beaten = attempts(1), may_win = attempts(0.1);
  CHECK(all.all > 1);
  CHECK(beaten.all == 1);
  CHECK(may_win.all == 1 + may_win.worst_first);
  CHECK(may_win.least >= beaten.least);
  CHECK(all.least >= may_win.least);
}

TEST_CASE("A bent solid gets a valid hexahedral mesh on its surface, the same for any number of threads") {
  BlockSolid block(volume_map::test::angle, 3, 0.8, 0.4);
  block.cut(7);
  REQUIRE(block.certificate == "");
  double volume = 0;
  for (const mesh::Triangle& t : block.surface)
    volume += block.positions[t[0]].dot(block.positions[t[1]].cross(block.positions[t[2]])) / 6;
  for (const Padding padding : {Padding::with, Padding::without}) {
    std::vector<Vector3> first;
    for (const unsigned threads : {1U, 3U}) {
      base::Host host;
      host.thread_count = threads;
      const HexResult result =
          make_hexahedra({block.map}, {.cells = 400, .padding = padding, .rounds = 10, .distance = 0}, host);
      CHECK(result.quality.valid());
      CHECK(result.padded == (padding == Padding::with));
      CHECK(result.quality.min_scaled_jacobian > 0.2);
      CHECK(result.mesh.hexahedra.size() > 150);
      CHECK(result.mesh.hexahedra.size() < 800);
      mesh::Mesh m;
      m.positions = result.mesh.positions;
      m.hexahedra = result.mesh.hexahedra;
      mesh::require_valid_cells(m, host);
      const auto boundary = mesh::boundary_triangles(m, host);
      CHECK(boundary.size() == 2 * result.mesh.quads.size());
      const mesh::SurfaceSearch search(block.positions, block.surface, host);
      // On the surface, but for what balances its curvature.
      double farthest = 0;
      std::set<Index> outer;
      for (const Quad& q : result.mesh.quads)
        outer.insert(q.begin(), q.end());
      for (const Index v : outer)
        farthest = std::max(farthest, search.nearest(m.positions[v]).distance);
      const double cell = std::cbrt(volume / static_cast<double>(m.hexahedra.size()));
      // A vertex or two may be inside, so that a hexahedron is valid, and are then near.
      CHECK(result.off_surface <= 2);
      CHECK(farthest < 0.2 * cell);
      CHECK(result.quality.volume == doctest::Approx(volume).epsilon(0.02));
      if (first.empty()) first.assign(m.positions.begin(), m.positions.end());
      CHECK(std::equal(first.begin(), first.end(), m.positions.begin(), m.positions.end()));
    }
  }
}

TEST_CASE("The distance of two surfaces is that of the farthest point, whichever has it, for any number of threads") {
  const base::Host host;
  mesh::Mesh box = mesh::make_shape("cube", {.triangles = 12}, host);
  Vector3 low = box.positions[0], high = low;
  for (const Vector3& p : box.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const auto distance = [&](const auto& a, const auto& b, unsigned threads) {
    base::Host other;
    other.thread_count = threads;
    return surface_distance(a, box.triangles, b, box.triangles, 0.01, other);
  };
  CHECK(distance(box.positions, box.positions, 1) < 1e-12);
  // Moved by d along an axis: the face in front is d from where it was.
  auto moved = box.positions;
  for (Vector3& p : moved)
    p[0] += 0.125;
  CHECK(distance(box.positions, moved, 1) == doctest::Approx(0.125));
  CHECK(distance(moved, box.positions, 3) == distance(box.positions, moved, 1));
  // Larger all around: a corner is farthest from the corner of the other.
  auto larger = box.positions;
  for (Vector3& p : larger)
    p += (0.1 * (2 * (p - low).cwiseQuotient(high - low).array() - 1)).matrix();
  CHECK(distance(larger, box.positions, 1) == doctest::Approx(0.1 * std::sqrt(3.0)));
  CHECK(distance(box.positions, larger, 2) == doctest::Approx(0.1 * std::sqrt(3.0)));
}

TEST_CASE("Where a mesh is far from the surface there are more cells, until it is near or there may be no more") {
  BlockSolid block(volume_map::test::angle, 3, 0.8, 0.4);
  block.cut(7);
  REQUIRE(block.certificate == "");
  const base::Host host;
  const auto made = [&](double distance, std::size_t most) {
    return make_hexahedra({block.map},
                          {.method = HexMethod::polycube,
                           .cells = 40,
                           .padding = Padding::with,
                           .rounds = 12,
                           .distance = distance,
                           .max_cells = most},
                          host);
  };
  const HexResult few = made(0, 40);
  REQUIRE(few.quality.valid());
  const double wanted = 0.6 * std::max(few.distance, few.volume_error);
  const HexResult near = made(wanted, 5000);
  CHECK(near.quality.valid());
  CHECK(near.distance <= wanted);
  CHECK(near.volume_error <= wanted);
  // Held where it began a mesh may be near enough without.
  CHECK(near.mesh.hexahedra.size() >= few.mesh.hexahedra.size());
  const HexResult nearest = made(0.01, 150);
  CHECK(nearest.quality.valid());
  CHECK(nearest.mesh.hexahedra.size() > few.mesh.hexahedra.size());
  CHECK(nearest.mesh.hexahedra.size() < 400);
  CHECK(std::max(nearest.distance, nearest.volume_error) <= std::max(few.distance, few.volume_error));
  // What is said of distance and volume, from the mesh.
  Vector3 low = block.positions[0], high = low;
  double volume = 0;
  for (const mesh::Triangle& t : block.surface) {
    for (const Index v : t) {
      low = low.cwiseMin(block.positions[v]);
      high = high.cwiseMax(block.positions[v]);
    }
    volume += block.positions[t[0]].dot(block.positions[t[1]].cross(block.positions[t[2]])) / 6;
  }
  CHECK(near.volume_error == doctest::Approx(100 * std::abs(near.quality.volume / volume - 1)));
  const mesh::SurfaceSearch search(block.positions, block.surface, host);
  double farthest = 0;
  std::vector<mesh::Triangle> outer;
  for (const Quad& q : near.mesh.quads) {
    for (const Index v : q)
      farthest = std::max(farthest, search.nearest(near.mesh.positions[v]).distance);
    outer.push_back({q[0], q[1], q[2]});
    outer.push_back({q[0], q[2], q[3]});
  }
  const mesh::SurfaceSearch back(near.mesh.positions, outer, host);
  for (const mesh::Triangle& t : block.surface) {
    const Vector3 center = (block.positions[t[0]] + block.positions[t[1]] + block.positions[t[2]]) / 3;
    farthest = std::max(farthest, back.nearest(center).distance);
  }
  CHECK(100 * farthest / (high - low).norm() <= near.distance * 1.05);
}

TEST_CASE("A coarse surface has fewer triangles and vertices of the fine one") {
  const base::Host host;
  const mesh::Mesh fine = mesh::make_shape("blob", {.triangles = 3000}, host);
  const CoarseSurface coarse = coarse_surface(fine.positions, fine.triangles, 800, host);
  CHECK(coarse.triangles.size() <= 820);
  CHECK(coarse.triangles.size() == 2 * coarse.positions.size() - 4);
  const CoarseSurface same = coarse_surface(fine.positions, fine.triangles, 5000, host);
  CHECK(same.triangles.size() == fine.triangles.size());
}
