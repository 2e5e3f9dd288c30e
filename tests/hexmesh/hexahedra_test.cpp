// Hexahedra: certificates against samples, and meshes of solids that are valid, conforming and on the surface.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <random>
#include <set>

#include "hexmesh/certificate/hex_tetrahedra.h"
#include "hexmesh/certificate/surface_distance.h"
#include "hexmesh/grid/even_lengths.h"
#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/grid/integer_domain.h"
#include "hexmesh/grid/padding.h"
#include "hexmesh/grid/sharp_map.h"
#include "hexmesh/quality/hex_reach.h"
#include "hexmesh/quality/hex_search.h"
#include "hexmesh/quality/hex_smoothing.h"
#include "hexmesh/strategies/hex_meshing.h"
#include "mesh/search/nearest.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/cells.h"
#include "polycube/map/certificate.h"
#include "polycube/map/construction.h"
#include "polycube/outputs/patch_graph.h"
#include "tests/volume_map/block_solid.h"
#include "volume_map/input/coarse_surface.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;

namespace {

constexpr std::array<std::array<int, 3>, 8> corners = {
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
constexpr Hexahedron whole = {0, 1, 2, 3, 4, 5, 6, 7};

std::vector<Vector3> cube(double push, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-push, push);
  std::vector<Vector3> result;
  for (const auto& c : corners)
    result.push_back(Vector3(c[0] + uniform(random), c[1] + uniform(random), c[2] + uniform(random)));
  return result;
}

// Of the trilinear map, by differences of its definition.
double determinant(const std::vector<Vector3>& p, const Vector3& at) {
  Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < 8; ++k) {
    for (Eigen::Index d = 0; d < 3; ++d) {
      double slope = 1;
      for (Eigen::Index e = 0; e < 3; ++e) {
        const bool high = corners[k][static_cast<std::size_t>(e)] == 1;
        slope *= e == d ? (high ? 1 : -1) : (high ? at[e] : 1 - at[e]);
      }
      j.col(d) += slope * p[k];
    }
  }
  return j.determinant();
}

// Of a polycube with about so many cells.
HexMesh grid_of(const polycube::SurfaceMap& map, std::size_t cells, double scale, const base::Host& host) {
  HexMesh mesh = sample_hexahedra(domain_of_cells(polycube::make_patch_graph(map, host), cells, 0, host), map, host);
  for (Vector3& p : mesh.positions)
    p *= scale;
  return mesh;
}

// With which those cells are about 1 long.
double scale_of_cells(const polycube::SurfaceMap& map, std::size_t cells, const base::Host& host) {
  double volume = 0;
  for (const mesh::Triangle& t : map.triangles)
    volume += map.positions[t[0]].dot(map.positions[t[1]].cross(map.positions[t[2]])) / 6;
  return std::cbrt(static_cast<double>(grid_of(map, cells, 1, host).hexahedra.size()) / volume);
}

// A grid on its way to be smoothed.
struct Draft {
  double scale;
  HexMesh mesh;
  SurfaceTarget target;
  HexBoundary boundary;

  Draft(const polycube::SurfaceMap& map, std::size_t cells, const base::Host& host)
      : scale(scale_of_cells(map, cells, host)),
        mesh(grid_of(map, cells, scale, host)),
        target(map, {}, {}, scale, host),
        boundary(mesh, target, host) {}

  bool smooth(const HexSmoothingOptions& options, const base::Host& host) {
    return smooth_hexahedra(mesh, boundary, target, options, host);
  }
};

}  // namespace

TEST_CASE("Bernstein coefficients are those of the trilinear map's determinant") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int run = 0; run < 20; ++run) {
    const auto p = cube(0.4, random);
    const auto f = bezier_coefficients(p, whole);
    const Vector3 at(uniform(random), uniform(random), uniform(random));
    const auto bernstein = [](int i, double t) {
      return i == 0 ? (1 - t) * (1 - t) : i == 1 ? 2 * t * (1 - t) : t * t;
    };
    double sum = 0;
    for (int i = 0; i < 27; ++i)
      sum += f[static_cast<std::size_t>(i)] * bernstein(i % 3, at[0]) * bernstein(i / 3 % 3, at[1]) *
             bernstein(i / 9, at[2]);
    CHECK(sum == doctest::Approx(determinant(p, at)).epsilon(1e-12));
  }
}

TEST_CASE(
    "The tetrahedra at corners and along edges are boxes in a box, and have the determinant's coefficients there") {
  std::mt19937_64 random(5);
  const std::array<double, 3> lengths = {2, 0.5, 3};
  std::vector<Vector3> box;
  for (const auto& c : corners)
    box.push_back(Vector3(lengths[0] * c[0], lengths[1] * c[1], lengths[2] * c[2]));
  for (const HexTetrahedron& t : hex_tetrahedra) {
    Element element = t.element(whole);
    t.set_shape(lengths, element);
    const Eigen::Matrix3d jacobian = element.jacobian(box);
    CHECK((jacobian.transpose() * jacobian - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK(jacobian.determinant() == doctest::Approx(1));
    CHECK(t.scaled_jacobian(box, element) == doctest::Approx(1));
  }
  // In a cube of edges 1 determinants are those of the target shape's map.
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<Vector3> p = cube(0.7, random);
    const auto coefficients = bezier_coefficients(p, whole);
    std::array<double, 27> means{};
    for (std::size_t k = 0; k < hex_tetrahedra.size(); ++k) {
      Element element = hex_tetrahedra[k].element(whole);
      hex_tetrahedra[k].set_shape({1, 1, 1}, element);
      const double determinant = element.jacobian(p).determinant();
      // A corner's, or half-way between those of the first two vertices.
      const auto& a = corners[element.corner[0]];
      const auto& b = corners[element.corner[k < corner_tetrahedra ? 0 : 1]];
      const int place = (a[0] + b[0]) + 3 * (a[1] + b[1]) + 9 * (a[2] + b[2]);
      means[static_cast<std::size_t>(place)] += k < corner_tetrahedra ? determinant : determinant / 2;
      if (k < corner_tetrahedra)
        CHECK(hex_tetrahedra[k].scaled_jacobian(p, element) == doctest::Approx(corner_jacobian(p, whole, k)));
    }
    std::size_t compared = 0;
    for (std::size_t i = 0; i < 27; ++i) {
      if ((i % 3 == 1) + (i / 3 % 3 == 1) + (i / 9 == 1) > 1) continue;  // on faces and inside
      ++compared;
      CHECK(means[i] == doctest::Approx(coefficients[i]).epsilon(1e-10));
    }
    CHECK(compared == 20);
  }
}

TEST_CASE("What is called certainly positive is so, and what is not has a reason") {
  std::mt19937_64 random(2);
  int positive = 0;
  for (int run = 0; run < 1000; ++run) {
    const auto p = cube(0.45, random);
    double least = 1;
    constexpr int steps = 10;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        for (int k = 0; k <= steps; ++k)
          least = std::min(least, determinant(p, Vector3(i, j, k) / steps));
      }
    }
    const bool certain = certainly_positive(p, whole);
    if (certain) CHECK(least > 0);
    if (least > 0.05) CHECK(certain);
    positive += certain;
  }
  CHECK(positive > 30);
}

TEST_CASE("Measures of a box and of what is inverted") {
  std::mt19937_64 random(3);
  auto p = cube(0, random);
  const std::vector<Hexahedron> cells = {whole};
  HexQuality q = measure_hexahedra(p, cells, base::Host());
  CHECK(q.valid());
  CHECK(q.min_scaled_jacobian == 1);
  CHECK(q.mean_scaled_jacobian == 1);
  CHECK(q.volume == doctest::Approx(1));
  CHECK(min_bezier(p, whole) == doctest::Approx(1));
  p[6] = Vector3(0.1, 0.1, 0.1);
  q = measure_hexahedra(p, cells, base::Host());
  CHECK(!q.valid());
  CHECK(q.inverted == 1);
  CHECK(q.first_bad == 0);
}

TEST_CASE("A bent solid gets a valid hexahedral mesh on its surface, the same for any number of threads") {
  test::BlockSolid block(test::angle, 3, 0.8, 0.4);
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

TEST_CASE("Smoothing leaves no hexahedron twisted where its corners are good") {
  struct Bar {
    double turn, taper;  // about its axis from end to end, and how wide the far end is
    std::size_t cells;
  };
  // Without the tetrahedra along edges three, one and seven hexahedra end so.
  for (const Bar& bar : {Bar{0, 0.02, 30}, Bar{8, 0.02, 150}, Bar{8, 2, 30}}) {
    test::BlockSolid block({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}}, 4, 0, 0);
    REQUIRE(block.certificate == "");
    // Bent to nearly a ring.
    for (std::size_t v = 0; v < block.map.positions.size(); ++v) {
      constexpr double angle = 5.5, length = 6, radius = length / angle;
      const Vector3& p = block.map.polycube[v];
      const double along = p[0] / length;
      const Vector3 across = (1 + (bar.taper - 1) * along) * (Eigen::AngleAxisd(bar.turn * along, Vector3::UnitX()) *
                                                              Vector3(0, p[1] - 0.5, p[2] - 0.5));
      block.map.positions[v] = Vector3((radius - across[1]) * std::sin(angle * along),
                                       radius - (radius - across[1]) * std::cos(angle * along), across[2]);
    }
    const base::Host host;
    Draft draft(block.map, bar.cells, host);
    CHECK(draft.smooth({.distance = 0.1}, host));
    for (const Hexahedron& h : draft.mesh.hexahedra) {
      CHECK(scaled_jacobian(draft.mesh.positions, h) > 0);
      CHECK(min_bezier(draft.mesh.positions, h) > 0);
    }
  }
}

TEST_CASE("The search makes hexahedra better on average, none worse than the worst, and leaves the boundary near") {
  test::BlockSolid block(test::angle, 3, 0.8, 0.4);
  REQUIRE(block.certificate == "");
  const base::Host host;
  Draft draft(block.map, 400, host);
  REQUIRE(draft.smooth({}, host));
  const HexMesh& before = draft.mesh;
  const HexBoundary& boundary = draft.boundary;
  search_hexahedra(draft.mesh, boundary, {}, host);
  constexpr double reach = 0.2;
  const auto raised = [&](const HexSearchOptions& options) {
    HexMesh mesh(before);
    raise_mean(mesh, boundary, options, host);
    return mesh;
  };
  const auto quality = [&](const HexMesh& mesh) { return measure_hexahedra(mesh.positions, mesh.hexahedra, host); };
  const HexMesh after = raised({.mean_reach = reach});
  REQUIRE(quality(before).valid());
  CHECK(quality(after).valid());
  CHECK(quality(after).min_scaled_jacobian >= quality(before).min_scaled_jacobian);
  CHECK(quality(after).mean_scaled_jacobian > quality(before).mean_scaled_jacobian + 0.003);
  for (const Index v : boundary.vertices()) {
    // The last step puts vertices onto the surface.
    const double snapped = (boundary.project(v, after.positions[v]).position - after.positions[v]).norm();
    CHECK((after.positions[v] - before.positions[v]).norm() <= reach + 0.05 + snapped);
  }
  CHECK(raised({.mean_reach = reach}).positions == after.positions);
  // Where the boundary may not move at all, what is inside still may.
  const HexMesh inside = raised({.mean_reach = 0});
  CHECK(quality(inside).mean_scaled_jacobian > quality(before).mean_scaled_jacobian);
  CHECK(quality(inside).mean_scaled_jacobian < quality(after).mean_scaled_jacobian);
}

TEST_CASE(
    "A boundary that the surface is too far from somewhere is brought there, and stays valid and on the surface") {
  test::BlockSolid block(test::angle, 4, 0.8, 0.4);
  REQUIRE(block.certificate == "");
  // A protrusion: what is near to a corner is drawn out.
  const Vector3 corner = block.map.positions[0];
  for (Vector3& p : block.map.positions)
    p += 0.5 * std::exp(-20 * (p - corner).squaredNorm()) * Vector3(-1, -1, -1);
  const base::Host host;
  Draft draft(block.map, 300, host);
  REQUIRE(draft.smooth({}, host));
  const HexMesh& mesh = draft.mesh;
  const HexBoundary& boundary = draft.boundary;
  const SurfaceTarget& target = draft.target;
  search_hexahedra(draft.mesh, boundary, {}, host);
  const auto farthest = [&](const HexMesh& of) {
    const Array<mesh::Triangle> halves = halves_of(of.quads, host.memory);
    const mesh::SurfaceSearch search(of.positions, halves, host);
    double most = 0;
    for (const Vector3& p : block.map.positions)
      most = std::max(most, search.nearest(draft.scale * p).distance);
    return most;
  };
  const auto quality = [&](const HexMesh& of) { return measure_hexahedra(of.positions, of.hexahedra, host); };
  REQUIRE(quality(mesh).valid());
  const double before = farthest(mesh);
  REQUIRE(before > 0.3);
  HexMesh near(mesh), far(mesh);
  reach_surface(near, boundary, target, 0.7 * before, host);
  CHECK(quality(near).valid());
  CHECK(quality(near).min_scaled_jacobian >= std::min(0.15, quality(mesh).min_scaled_jacobian));
  CHECK(farthest(near) < 0.8 * before);
  for (const Index v : boundary.vertices()) {
    if (near.positions[v] == mesh.positions[v]) continue;
    CHECK((boundary.project(v, near.positions[v]).position - near.positions[v]).norm() < 0.05);
  }
  HexMesh again(mesh);
  reach_surface(again, boundary, target, 0.7 * before, host);
  CHECK(again.positions == near.positions);
  // What is near enough is left alone.
  reach_surface(far, boundary, target, 2 * before, host);
  CHECK(far.positions == mesh.positions);
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
  test::BlockSolid block(test::angle, 3, 0.8, 0.4);
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

namespace {

HexMesh grid_of(const test::BlockSolid& block, double cell_length) {
  const base::Host host;
  const IntegerDomain domain(polycube::make_patch_graph(block.map, host), cell_length, host);
  return sample_hexahedra(domain, block.map, host);
}

}  // namespace

TEST_CASE("Planes of a polycube are moved to where lengths on it are those in space") {
  const base::Host host;
  test::BlockSolid box({{0, 0, 0}}, 8, 0, 0);
  // Three times as long beyond the first quarter, and the whole half as high.
  for (std::size_t v = 0; v < box.map.positions.size(); ++v) {
    const Vector3 p = box.map.polycube[v];
    box.map.positions[v] = {p[0] + 2 * std::max(0.0, p[0] - 0.25), p[1], 0.5 * p[2]};
  }
  const polycube::SurfaceMap even = map_with_even_lengths(box.map, host);
  CHECK(std::equal(even.positions.begin(), even.positions.end(), box.map.positions.begin(), box.map.positions.end()));
  CHECK(std::equal(even.labels.begin(), even.labels.end(), box.map.labels.begin(), box.map.labels.end()));
  CHECK(std::equal(even.patches.begin(), even.patches.end(), box.map.patches.begin(), box.map.patches.end()));
  double largest = 0;
  for (std::size_t v = 0; v < even.positions.size(); ++v)
    largest = std::max(largest, (even.polycube[v] - even.positions[v]).norm());
  CHECK(largest < 1e-12);
}

TEST_CASE("Whatever the lengths in space, the polycube of even lengths is certified") {
  const base::Host host;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-3, 3);
  for (int run = 0; run < 20; ++run) {
    test::BlockSolid block(test::angle, 2 + run % 4, 0.8, 0.4);
    block.cut(static_cast<unsigned>(run));
    for (Vector3& p : block.map.positions)
      p *= std::exp(exponent(random));
    const auto before = polycube::certify(block.map.polycube, block.map.triangles, host);
    polycube::SurfaceMap even = map_with_even_lengths(block.map, host);
    const auto after = polycube::certify(even.polycube, even.triangles, host);
    CHECK(after.valid());
    CHECK(after.corners == before.corners);
    CHECK(after.patch_count == before.patch_count);
    CHECK(std::equal(after.labels.begin(), after.labels.end(), before.labels.begin(), before.labels.end()));
  }
}

TEST_CASE("A layer on any of the faces of a box leaves a conforming mesh with the same boundary") {
  const base::Host host;
  const test::BlockSolid box({{0, 0, 0}}, 3, 0, 0);
  REQUIRE(box.certificate == "");
  const HexMesh grid = grid_of(box, 1.0 / 3);
  REQUIRE(grid.hexahedra.size() == 27);
  for (unsigned faces = 0; faces < 64; ++faces) {
    std::array<std::uint8_t, 6> padded{};
    for (std::size_t k = 0; k < 6; ++k)
      padded[k] = (faces >> k) & 1;
    HexMesh made = grid;
    pad(made, padded, 1.0 / 3, host);
    CHECK(made.hexahedra.size() == 27 + 9 * static_cast<std::size_t>(std::popcount(faces)));
    const HexQuality quality = measure_hexahedra(made.positions, made.hexahedra, host);
    CHECK(quality.valid());
    CHECK(quality.volume == doctest::Approx(measure_hexahedra(grid.positions, grid.hexahedra, host).volume));
    mesh::Mesh cells;
    cells.positions = made.positions;
    cells.hexahedra = made.hexahedra;
    mesh::require_valid_cells(cells, host);
    CHECK(mesh::boundary_triangles(cells, host).size() == 2 * made.quads.size());
    // What a quad says it lies on is where it lies; outward.
    REQUIRE(made.quads.size() == made.quad_patches.size());
    std::array<double, 6> area{};
    for (std::size_t i = 0; i < made.quads.size(); ++i) {
      const Quad& q = made.quads[i];
      const Vector3 normal =
          0.5 * (made.positions[q[2]] - made.positions[q[0]]).cross(made.positions[q[3]] - made.positions[q[1]]);
      area[made.quad_patches[i]] += normal.norm();
      for (std::size_t j = 0; j < grid.quads.size(); ++j) {
        if (grid.quad_patches[j] != made.quad_patches[i]) continue;
        const Quad& g = grid.quads[j];
        const Vector3 out =
            (grid.positions[g[2]] - grid.positions[g[0]]).cross(grid.positions[g[3]] - grid.positions[g[1]]);
        CHECK(out.normalized().dot(normal.normalized()) == doctest::Approx(1));
        for (const Index v : q)
          CHECK(std::abs(out.dot(made.positions[v] - grid.positions[g[0]])) < 1e-12);
        break;
      }
    }
    for (const double a : area)
      CHECK(a == doctest::Approx(1));
  }
}

TEST_CASE("Faces that meet in right angles are not padded, round ones are, and those along an inner edge alike") {
  const base::Host host;
  const test::BlockSolid sharp(test::angle, 4, 0, 0);
  for (const std::uint8_t face : choose_padding(grid_of(sharp, 0.25), host))
    CHECK(face == 0);
  // A block in the shape of a ball.
  test::BlockSolid round({{0, 0, 0}}, 6, 0, 0);
  for (std::size_t v = 0; v < round.map.positions.size(); ++v) {
    const Vector3 p = 2 * round.map.polycube[v] - Vector3::Ones();
    round.map.positions[v] = p.lpNorm<Eigen::Infinity>() * p.normalized();
  }
  const auto all = choose_padding(grid_of(round, 1.0 / 6), host);
  CHECK(all.size() == 6);
  for (const std::uint8_t face : all)
    CHECK(face == 1);
  // One whose upper face is a dome that goes on into its neighbors, which meet the lower one at right angles.
  test::BlockSolid dome({{0, 0, 0}}, 6, 0, 0);
  for (std::size_t v = 0; v < dome.map.positions.size(); ++v) {
    Vector3 p = dome.map.polycube[v];
    const double edge = std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5));
    p[2] *= std::sqrt(1.25 - 4 * edge * edge);
    dome.map.positions[v] = p;
  }
  const HexMesh grid = grid_of(dome, 1.0 / 6);
  const auto some = choose_padding(grid, host);
  std::size_t lower = 0, upper = 0;
  for (std::size_t i = 0; i < grid.quads.size(); ++i) {
    double low = 2, high = 0;
    for (const Index v : grid.quads[i]) {
      low = std::min(low, grid.positions[v][2]);
      high = std::max(high, grid.positions[v][2]);
    }
    if (high == 0) {
      CHECK(some[grid.quad_patches[i]] == 0);
      ++lower;
    }
    if (low > 0.9) {
      CHECK(some[grid.quad_patches[i]] == 1);
      ++upper;
    }
  }
  CHECK(lower == 36);
  CHECK(upper >= 4);
}

TEST_CASE(
    "Hexahedra of a right-angled solid are boxes up to its sharp edges, those of a smooth one have none to follow") {
  const base::Host host;
  const mesh::Mesh shape = mesh::make_shape("l-shape", {.triangles = 1200}, host);
  const auto best = polycube::construct(shape.positions, shape.triangles, {.corners = 60}, host);
  const HexResult made = make_hexahedra({best.made.map}, {.cells = 600}, host);
  CHECK(made.follows_sharp_edges);
  CHECK(made.quality.valid());
  CHECK(made.quality.min_scaled_jacobian > 0.99);
  CHECK(made.distance < 0.05);
  CHECK(made.volume_error < 0.01);
  const HexResult without = make_hexahedra({best.made.map}, {.cells = 600, .feature_angle = 0}, host);
  CHECK(without.quality.valid());
  CHECK(!without.follows_sharp_edges);
  CHECK(made.quality.min_scaled_jacobian >= without.quality.min_scaled_jacobian - 1e-6);
  const test::BlockSolid round(test::angle, 4, 0.8, 0.4);
  CHECK(!map_with_sharp_edges(round.map, 100, host));
}

TEST_CASE("Sharp edges are left alone where the polycube has edges for less than three fifths of them") {
  const base::Host host;
  test::BlockSolid bar(test::bar(2), 6, 0, 0);
  CHECK(map_with_sharp_edges(bar.map, 40, host));
  // Every second row of vertices across top and bottom becomes a ridge.
  for (std::size_t v = 0; v < bar.map.positions.size(); ++v) {
    const Vector3& p = bar.map.polycube[v];
    const bool ridge = std::lround(6 * p[0]) % 2 == 1 && (p[2] == 0 || p[2] == 1);
    if (ridge) bar.map.positions[v] += Vector3(0, 0, 0.1);
  }
  CHECK(!map_with_sharp_edges(bar.map, 40, host));
}
