// The dissertation's chapter 4 as printed: each step by itself, and the whole on shapes that it can do.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "base/error.h"
#include "blocks.h"
#include "polycube/dissertation/corner_disks.h"
#include "polycube/dissertation/corner_mapping.h"
#include "polycube/dissertation/domain_shape.h"
#include "polycube/dissertation/octree.h"
#include "polycube/dissertation/printed_construction.h"
#include "polycube/map/construction.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using namespace orbicube::polycube::dissertation;
using test::host;

namespace {

VoxelSolid octree_of(const mesh::Mesh& m, int depth, double inside) {
  const Occupancy occupancy(m.positions, m.triangles, 64, host);
  return octree_solid(occupancy, {.depth = depth, .inside = inside}, host);
}

// A surface with the nearest corner points of one cuboid.
struct BoxedSurface {
  explicit BoxedSurface(const char* name, std::size_t triangles)
      : mesh(test::shape(name, triangles)),
        surface(mesh.positions, mesh.triangles, host),
        layout(make_layout(octree_of(mesh, 0, 0.5), host)),
        points(project_corners(layout, surface, Projection::nearest, host)) {}
  mesh::Mesh mesh;
  EditableSurface surface;
  Layout layout;
  Array<Index> points;
};

// Lengths of shortest paths from a vertex, by relaxing all edges until nothing changes.
std::vector<double> all_lengths(const EditableSurface& surface, Index from) {
  std::vector<double> length(surface.vertices(), std::numeric_limits<double>::infinity());
  length[from] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (Index h = 0; h < 3 * surface.faces(); ++h) {
      const double there = length[surface.start(h)] + surface.length(h);
      if (!(there < length[surface.end(h)])) continue;
      length[surface.end(h)] = there;
      changed = true;
    }
  }
  return length;
}

void check_certified(const Printed& printed) {
  const Certificate certificate = certify(printed.made.map.polycube, printed.made.map.triangles, host);
  CHECK(certificate.valid());
  CHECK(certificate.corners == printed.made.certificate.corners);
}

}  // namespace

TEST_CASE("An octree of depth 0 is the bounding box, deeper ones have the voxels that are inside") {
  const mesh::Mesh m = test::shape("sphere", 2000);
  const VoxelSolid box = octree_of(m, 0, 0.5);
  CHECK(box.corners() == 8);
  for (const int depth : {1, 2, 3}) {
    const VoxelSolid solid = octree_of(m, depth, 0.5);
    const Occupancy occupancy(m.positions, m.triangles, 64, host);
    const int boxes = 1 << depth;
    for (int x = 0; x < boxes; ++x) {
      for (int y = 0; y < boxes; ++y) {
        for (int z = 0; z < boxes; ++z) {
          const auto plane = [&](std::size_t axis, int i) { return occupancy.count(axis) * i / boxes; };
          const std::array<int, 3> low = {plane(0, x), plane(1, y), plane(2, z)};
          const std::array<int, 3> high = {plane(0, x + 1), plane(1, y + 1), plane(2, z + 1)};
          const double volume = static_cast<double>(high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
          CHECK(solid.inside(Cell{x + 1, y + 1, z + 1}) ==
                (static_cast<double>(occupancy.inside(low, high)) > 0.5 * volume));
        }
      }
    }
  }
}

TEST_CASE("Merged rectangles cover the boundary of the voxels exactly") {
  const mesh::Mesh m = test::shape("sphere", 2000);
  const VoxelSolid solid = octree_of(m, 3, 0.5);
  const Layout layout = make_layout(solid, host);
  double covered = 0, boundary = 0;
  // Centers of all boundary squares lie in one rectangle each.
  for (std::size_t place = 0; place < solid.size(); ++place) {
    if (!solid.inside(place)) continue;
    const Cell c = solid.cell(place);
    const Vector3 low = solid.position(c), high = solid.position({c[0] + 1, c[1] + 1, c[2] + 1});
    for (AxisLabel label = 0; label < label_count; ++label) {
      const int axis = axis_of(label), u = (axis + 1) % 3, v = (axis + 2) % 3;
      if (solid.inside(solid.neighbor(place, static_cast<std::size_t>(axis), sign_of(label)))) continue;
      boundary += (high - low)[u] * (high - low)[v];
      Vector3 center = (low + high) / 2;
      center[axis] = sign_of(label) > 0 ? high[axis] : low[axis];
      std::size_t holders = 0;
      for (const LayoutRectangle& r : layout.rectangles) {
        const Vector3 a = layout.position(r.low), b = layout.position(r.high);
        holders += r.label == label && a[axis] == center[axis] && a[u] < center[u] && center[u] < b[u] &&
                   a[v] < center[v] && center[v] < b[v];
      }
      CHECK(holders == 1);
    }
  }
  for (const LayoutRectangle& r : layout.rectangles) {
    const Vector3 size = layout.position(r.high) - layout.position(r.low);
    covered += size[(axis_of(r.label) + 1) % 3] * size[(axis_of(r.label) + 2) % 3];
  }
  CHECK(covered == doctest::Approx(boundary).epsilon(1e-12));
}

TEST_CASE("Paths are shortest, and the same in both directions") {
  const BoxedSurface box("creature", 600);
  ShortestPaths shortest(box.surface, host);
  std::mt19937_64 random(3);
  for (int i = 0; i < 10; ++i) {
    const auto from = static_cast<Index>(random() % box.surface.vertices());
    const std::vector<double> lengths = all_lengths(box.surface, from);
    for (int k = 0; k < 10; ++k) {
      const auto to = static_cast<Index>(random() % box.surface.vertices());
      const auto path = shortest.find(from, to);
      const std::vector<Index> kept(path.begin(), path.end());
      REQUIRE(!kept.empty());
      CHECK(kept.front() == from);
      CHECK(kept.back() == to);
      double length = 0;
      for (std::size_t n = 1; n < kept.size(); ++n) {
        const Index h = box.surface.between(kept[n - 1], kept[n]);
        REQUIRE(h != no_index);
        length += box.surface.length(h);
      }
      CHECK(length == doctest::Approx(lengths[to]).epsilon(1e-12));
      const auto back = shortest.find(to, from);
      CHECK(std::equal(back.begin(), back.end(), kept.rbegin(), kept.rend()));
    }
  }
}

TEST_CASE("Paths that meet are counted, with the place") {
  const BoxedSurface box("sphere", 600);
  Array<Index> points = box.points;
  points[1] = points[0];
  ShortestPaths shortest(box.surface, host);
  const Drawn drawn = draw_paths(box.layout, points, box.surface, shortest, host);
  CHECK(!drawn.valid());
  CHECK(drawn.first.find("vertex " + std::to_string(points[0])) != std::string::npos);
}

TEST_CASE("Harmonic maps of a box reproduce linear functions, without a flipped triangle") {
  const BoxedSurface box("cube", 1200);
  PrintedMapper mapper(box.surface, host);
  const Drawn drawn = mapper.draw(box.layout, box.points);
  REQUIRE(drawn.valid());
  const PatchMap map = mapper.map(box.layout, drawn);
  CHECK(map.flipped == 0);
  for (Index v = 0; v < box.surface.vertices(); ++v)
    CHECK((map.polycube[v] - box.surface.position[v]).norm() < 1e-12);
  // Of an isometry: H is the area, and so is A.
  CHECK(map.total(0) == doctest::Approx(24).epsilon(1e-12));
  CHECK(map.total(1) == doctest::Approx(48).epsilon(1e-12));
  Certificate certificate(host.memory);
  const FinishedMap finished = mapper.finish(box.layout, drawn, certificate);
  CHECK(finished.flipped == 0);
  CHECK(certificate.valid());
  CHECK(certificate.corners == 8);
}

TEST_CASE("A factor with rows removed and put back gives what a new one gives") {
  const BoxedSurface box("sphere", 4000);
  const Array<double> weights = half_edge_weights(box.surface, host);
  HarmonicSystem kept(box.surface, weights, host);
  std::mt19937_64 random(5);
  Array<std::uint8_t> fixed(box.surface.vertices(), 0);
  for (int i = 0; i < 200; ++i)
    fixed[random() % fixed.size()] = 1;
  REQUIRE(kept.fix(fixed));
  for (int round = 0; round < 6; ++round) {
    for (int i = 0; i < 2; ++i)
      fixed[random() % fixed.size()] ^= 1U;
    // One of the fixed vertices becomes free as well.
    *std::find(fixed.begin(), fixed.end(), 1) = 0;
    Array<Vector3> a(box.surface.position.begin(), box.surface.position.end()), b = a;
    REQUIRE(kept.fix(fixed));
    REQUIRE(kept.solve(a));
    HarmonicSystem fresh(box.surface, weights, host);
    REQUIRE(fresh.fix(fixed));
    REQUIRE(fresh.solve(b));
    for (Index v = 0; v < a.size(); ++v)
      CHECK((a[v] - b[v]).norm() < 1e-8);
  }
  CHECK(kept.counts().rows_added > 0);
  CHECK(kept.counts().rows_removed > 0);
  CHECK(kept.counts().factorizations < 6);
}

TEST_CASE("Energies of rectangles are eqs. 4.2 to 4.4, and follow their lengths as eqs. 4.5 to 4.8") {
  const BoxedSurface box("sphere", 2000);
  PrintedMapper mapper(box.surface, host);
  const Drawn drawn = mapper.draw(box.layout, box.points);
  REQUIRE(drawn.valid());
  const PatchMap map = mapper.map(box.layout, drawn);
  // Each edge and triangle by itself, of the map stretched along the axes.
  const auto printed = [&](const Vector3& stretch, double alpha) {
    double sum = 0;
    for (Index face = 0; face < box.surface.faces(); ++face) {
      const auto& t = box.surface.triangle[face];
      std::array<Vector3, 3> x, u;
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] = box.surface.position[t[k]];
        u[k] = map.polycube[t[k]].cwiseProduct(stretch);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3 a = x[(k + 1) % 3] - x[k], b = x[(k + 2) % 3] - x[k];
        const double cotangent = 1 / std::tan(std::acos(a.dot(b) / (a.norm() * b.norm())));
        sum += 0.5 * (0.5 * cotangent) * (u[(k + 1) % 3] - u[(k + 2) % 3]).squaredNorm();
      }
      const double area = (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
      const double image = (u[1] - u[0]).cross(u[2] - u[0]).norm() / 2;
      sum += alpha * image * image / area;
    }
    return sum;
  };
  for (const double alpha : {0.0, 0.7})
    CHECK(map.total(alpha) == doctest::Approx(printed(Vector3::Ones(), alpha)).epsilon(1e-9));
  const double alpha = 0.7;
  const dissertation::DomainEnergy energy(box.layout, map.energy, alpha, host);
  REQUIRE(energy.lengths() == 3);
  std::vector<double> x(energy.start().begin(), energy.start().end()), gradient(x.size());
  const double area = energy.unit() * energy.unit();
  for (const Vector3& stretch : {Vector3(1, 1, 1), Vector3(1.3, 1, 1), Vector3(0.8, 1.1, 1.7)}) {
    for (std::size_t a = 0; a < 3; ++a) {
      // One length along each axis: alpha and beta of eq. 4.9 are the same.
      x[a] = energy.start()[a] * stretch[static_cast<Eigen::Index>(a)];
      x[3 + a] = energy.start()[3 + a] * stretch[static_cast<Eigen::Index>(a)];
    }
    CHECK(energy.evaluate(x, 0, gradient) * area == doctest::Approx(printed(stretch, alpha)).epsilon(1e-9));
  }
}

TEST_CASE("The derivative of the energy of proportions is that of differences") {
  const mesh::Mesh m = test::shape("l-shape", 600);
  const Layout layout = make_layout(octree_of(m, 3, 0.5), host);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(0.5, 2);
  std::vector<PatchEnergy> energies(layout.rectangles.size());
  for (PatchEnergy& e : energies)
    e = {{any(random), any(random), any(random)}, any(random), 0, 0};
  const dissertation::DomainEnergy energy(layout, energies, 0.7, host);
  std::vector<double> x(energy.start().begin(), energy.start().end()), gradient(x.size()), none(x.size());
  for (double& value : x)
    value *= any(random);
  energy.evaluate(x, 100, gradient);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double step = 1e-5, at = x[i];
    x[i] = at + step;
    const double above = energy.evaluate(x, 100, none);
    x[i] = at - step;
    const double below = energy.evaluate(x, 100, none);
    x[i] = at;
    CHECK((above - below) / (2 * step) == doctest::Approx(gradient[i]).epsilon(1e-5).scale(100));
  }
  CHECK(energy.area(energy.start()) == doctest::Approx(1));
}

TEST_CASE("Optimal proportions keep the area and lower the energy of the rectangles") {
  const BoxedSurface box("creature", 1200);
  std::vector<PatchEnergy> energies(6);
  for (std::size_t r = 0; r < 6; ++r) {
    energies[r].harmonic.fill(axis_of(box.layout.rectangles[r].label) == 0 ? 5.0 : 1.0);
    energies[r].stretch = 1;
  }
  const DomainShape shape = optimize_domain_shape(box.layout, energies, 1, host);
  CHECK(shape.converged);
  CHECK(shape.energy < shape.energy_before);
  const auto area = [](const auto& planes) {
    double sum = 0;
    for (std::size_t a = 0; a < 3; ++a)
      sum += 2 * (planes[a][2] - planes[a][1]) * (planes[(a + 1) % 3][2] - planes[(a + 1) % 3][1]);
    return sum;
  };
  CHECK(area(shape.planes) == doctest::Approx(area(box.layout.planes)).epsilon(1e-10));
}

TEST_CASE("Disks are disks around their corner points, and bijective") {
  const BoxedSurface box("creature", 5000);
  for (const Index center : {box.points[0], box.points[5]}) {
    const CornerDisk disk = make_disk(box.surface, center, disk_rings, host);
    CHECK(disk.vertices[0] == center);
    CHECK(disk.rings <= disk_rings);
    CHECK(disk.nearest(disk.places[0]) == center);
    std::vector<Index> place(box.surface.vertices(), no_index);
    for (std::size_t i = 0; i < disk.vertices.size(); ++i) {
      place[disk.vertices[i]] = static_cast<Index>(i);
      CHECK(disk.places[i].norm() < 1 + 1e-12);
    }
    for (const Triangle& t : box.surface.triangle) {
      if (place[t[0]] == no_index || place[t[1]] == no_index || place[t[2]] == no_index) continue;
      const Eigen::Vector2d p = disk.places[place[t[1]]] - disk.places[place[t[0]]];
      const Eigen::Vector2d q = disk.places[place[t[2]]] - disk.places[place[t[0]]];
      CHECK(p.x() * q.y() - p.y() * q.x() > 0);
    }
  }
}

TEST_CASE("A corner point that is displaced moves to where the energy is less") {
  const BoxedSurface box("sphere", 2000);
  PrintedMapper mapper(box.surface, host);
  Array<Index> moved = box.points;
  for (int step = 0; step < 3; ++step)
    moved[0] = box.surface.end(box.surface.outgoing(moved[0]));
  REQUIRE(mapper.draw(box.layout, moved).valid());
  const CornerMapping found = optimize_corner_mapping(box.layout, moved, mapper, {}, host);
  CHECK(found.energy < found.energy_before);
  CHECK(found.evaluations > 2 * 16);
  const Drawn drawn = mapper.draw(box.layout, found.corner_points);
  REQUIRE(drawn.valid());
  CHECK(mapper.map(box.layout, drawn).total(1) == doctest::Approx(found.energy).epsilon(1e-10));
}

TEST_CASE("Algorithm 3 lowers the energy and keeps the certificate") {
  for (const char* const name : {"sphere", "l-shape"}) {
    CAPTURE(name);
    const mesh::Mesh m = test::shape(name, 1500);
    const Printed printed = construct_as_printed(m.positions, m.triangles, {.max_rounds = 2}, host);
    check_certified(printed);
    const auto& energies = printed.report.energies;
    REQUIRE(energies.size() > 1);
    CHECK(std::is_sorted(energies.rbegin(), energies.rend()));
    CHECK(printed.report.corner_points <= default_corner_points);
    CHECK(printed.report.corner_points >= printed.made.certificate.corners);
    CHECK(count_corner_points(printed.made.map, host) >= printed.made.certificate.corners);
    CHECK(std::equal(m.positions.begin(), m.positions.end(), printed.made.map.positions.begin()));
  }
}

TEST_CASE("What the method cannot map is refused with the place") {
  const mesh::Mesh m = test::shape("creature", 2500);
  try {
    const Printed printed =
        construct_as_printed(m.positions, m.triangles, {.corner_points = 40, .max_rounds = 1}, host);
    check_certified(printed);
  } catch (const base::Error& error) {
    CHECK(error.status() == base::Status::no_valid_result);
    CHECK(std::string(error.what()).find("corner points: ") != std::string::npos);
  }
  const mesh::Mesh open = [&] {
    mesh::Mesh part = m;
    part.triangles.pop_back();
    return part;
  }();
  CHECK_THROWS_AS(construct_as_printed(open.positions, open.triangles, {}, host), base::Error);
}

TEST_CASE("The choice of constructions has the dissertation's, which no other choice uses") {
  const mesh::Mesh m = test::shape("sphere", 800);
  const BestConstruction best =
      construct(m.positions, m.triangles, {.method = Method::dissertation, .corners = 8, .rounds = 1}, host);
  CHECK(best.method == Method::dissertation);
  REQUIRE(best.printed.has_value());
  CHECK(best.printed->corner_points == 8);
  CHECK(best.made.certificate.corners == 8);
  const BestConstruction ours = construct(m.positions, m.triangles, {.corners = 8}, host);
  CHECK(ours.method != Method::dissertation);
  CHECK(!ours.printed.has_value());
}
