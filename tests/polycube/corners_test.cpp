// The best positions for corners: regions that are unfolded rightly, derivatives, edges that are drawn again without
// changing the map, optima that are known, and maps that stay valid.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "base/error.h"
#include "blocks.h"
#include "polycube/corners/corner_cut.h"
#include "polycube/corners/optimal_corners.h"
#include "polycube/voxels/voxel_construction.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::host;

namespace {

// Cells, each triangle cut into four `times` times, as a map to themselves: an isometry.
SurfaceMap refined(const std::vector<test::Cell>& cells, int times) {
  mesh::Mesh m = test::blocks(cells);
  for (int i = 0; i < times; ++i) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [place, is_new] = middles.emplace(std::minmax(a, b), static_cast<Index>(m.positions.size()));
      if (is_new) m.positions.push_back(0.5 * (m.positions[a] + m.positions[b]));
      return place->second;
    };
    const Array<Triangle> old = m.triangles;
    m.triangles.clear();
    for (const auto& [a, b, c] : old) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
        m.triangles.push_back(t);
    }
  }
  return test::on_itself(m, host);
}

// Corners of three, of five and of four quarter turns.
const SurfaceMap& steps() {
  static const SurfaceMap map = refined(test::box_without({3, 2, 2}, {{2, 1, 1}, {2, 0, 1}, {0, 1, 1}}), 3);
  return map;
}

const SurfaceMap& creature() {
  static const SurfaceMap map = [] {
    const mesh::Mesh m = test::shape("creature", 4000);
    return construct_by_voxels(m.positions, m.triangles, {.corners = 24}, host).map;
  }();
  return map;
}

double energy_of(const SurfaceMap& map, double area_weight) {
  const Distortion d = measure_distortion(map, host);
  return d.angle_weighted_mean + area_weight * d.area_weighted_mean;
}

// A map whose corners were moved by a part of their regions, and everything else to where that distorts least.
SurfaceMap displaced(const SurfaceMap& map, const Vector2d& by) {
  WorkingMap working(map, host);
  for (const CornerRegion& region : RegionFinder(working, host).find_disjoint(300)) {
    CornerMove move(region, working.area, {}, host);
    REQUIRE(std::isfinite(move.evaluate(by, nullptr)));
    REQUIRE(cut_region(move, working, host));
  }
  SurfaceMap result = working.result(host);
  const Certificate certificate = certify(result, host);
  REQUIRE(certificate.reason == "");
  return result;
}

}  // namespace

TEST_CASE("Regions are disjoint disks around corners that unfold without a change of length") {
  std::set<int> turns;
  for (const SurfaceMap* map : {&steps(), &creature()}) {
    const WorkingMap working(*map, host);
    const Array<CornerRegion> regions = RegionFinder(working, host).find_disjoint(200);
    REQUIRE(regions.size() > 2);
    std::set<Index> seen;
    for (const CornerRegion& region : regions) {
      turns.insert(region.quarters);
      CHECK(region.inside >= 1);
      CHECK(region.inside <= 200);
      for (std::size_t i = 0; i < region.faces.size(); ++i) {
        CHECK(seen.insert(region.faces[i]).second);
        const Triangle& t = region.triangles[i];
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          CHECK(region.vertices[t[k]] == working.surface.triangle[region.faces[i]][k]);
          const Index a = t[k], b = t[(k + 1) % 3];
          const double length = (working.image[region.vertices[a]] - working.image[region.vertices[b]]).norm();
          // The same in one of the ways to lay them side by side.
          double nearest = 1e300;
          for (const int whole : {-1, 0, 1})
            nearest = std::min(
                nearest,
                std::abs((turned_by(region.cone[a], whole * region.quarters) - region.cone[b]).norm() - length));
          CHECK(nearest < 1e-12 * (1 + length));
          sum += length;
        }
        CHECK(sum > 0);
      }
      // The angle is that of the unfolded place.
      for (std::size_t v = 1; v < region.vertices.size(); ++v) {
        const Vector2d p = region.cone[v];
        CHECK(p.x() == doctest::Approx(p.norm() * std::cos(region.angle[v])).epsilon(1e-12).scale(p.norm()));
        CHECK(p.y() == doctest::Approx(p.norm() * std::sin(region.angle[v])).epsilon(1e-12).scale(p.norm()));
        CHECK(region.angle[v] < region.whole_turn());
      }
      // A disk: each edge inside is there twice, the others once around.
      CHECK(region.vertices.size() + region.faces.size() ==
            (3 * region.faces.size() + (region.vertices.size() - region.inside)) / 2 + 1);
    }
  }
  CHECK(turns.count(3) == 1);
  CHECK(turns.count(5) == 1);
}

TEST_CASE("A region's energy is its part of the map's, and the corner where it is does not raise it") {
  const WorkingMap working(creature(), host);
  for (const CornerRegion& region : RegionFinder(working, host).find_disjoint(150)) {
    for (const double area_weight : {0.3, 2.0}) {
      CornerMove move(region, working.area, {.area_weight = area_weight}, host);
      double sum = 0;
      for (const Index f : region.faces) {
        SurfaceMap one;
        one.positions = creature().positions;
        for (Vector3& p : one.positions)
          p *= working.scale;
        one.polycube = creature().polycube;
        one.triangles = {working.surface.triangle[f]};
        const auto& [a, b, c] = one.triangles[0];
        const double in_space =
            0.5 * (one.positions[b] - one.positions[a]).cross(one.positions[c] - one.positions[a]).norm();
        const double image = 0.5 * (one.polycube[b] - one.polycube[a]).cross(one.polycube[c] - one.polycube[a]).norm();
        const double ratio = image / in_space;
        const double angle = measure_distortion(one, host).angle_mean;
        sum += in_space / working.area * (angle + area_weight * 0.5 * (ratio + 1 / ratio));
      }
      CHECK(move.energy_now() == doctest::Approx(sum).epsilon(1e-6));
      CHECK(move.evaluate(Vector2d::Zero(), nullptr) <= move.energy_now() * (1 + 1e-12));
      CHECK(std::isinf(move.evaluate({1.5, 0}, nullptr)));
    }
  }
}

TEST_CASE("The gradient is that of differences while the corner stays in one triangle of the surface") {
  const WorkingMap working(creature(), host);
  int tried = 0;
  RegionFinder finder(working, host);
  for (const Index corner : finder.corners()) {
    CornerRegion region(host.memory);
    if (!finder.find(corner, 100, region)) continue;
    // Half of the triangles count as larger than they are.
    const double min_area = working.area / static_cast<double>(creature().triangles.size());
    CornerMove move(region, working.area, {.area_weight = 0.7, .min_area = min_area, .steps = 400, .min_gain = 1e-14},
                    host);
    for (const Vector2d& at : {Vector2d(0.25, 0.1), Vector2d(-0.2, 0.15), Vector2d(0.05, -0.3)}) {
      Vector2d gradient;
      const double energy = move.evaluate(at, &gradient);
      if (!std::isfinite(energy)) continue;
      const CornerMove::Place place = move.place();
      if (std::count(place.weights.begin(), place.weights.end(), 0.0) > 0) continue;
      bool same = true;
      Vector2d difference;
      const double h = 1e-4;
      for (int k = 0; k < 2; ++k) {
        const auto shifted = [&](double by) {
          Vector2d p = at;
          p[k] += by;
          const double result = move.evaluate(p, nullptr);
          // At the rim of where there are maps a shifted corner may have none.
          same = same && std::isfinite(result) && move.place().face == place.face &&
                 std::count(move.place().weights.begin(), move.place().weights.end(), 0.0) == 0;
          return result;
        };
        difference[k] = (shifted(h) - shifted(-h)) / (2 * h);
      }
      if (!same) continue;
      ++tried;
      // Minima are known to some 1e-13 of the energy, differences of them to 1e-9 and their second order.
      CHECK((gradient - difference).norm() < 1e-3 * gradient.norm() + 1e-7 * energy);
    }
  }
  CHECK(tried > 5);
}

TEST_CASE("Edges are drawn again without a change of the map") {
  for (const SurfaceMap* map : {&steps(), &creature()}) {
    const double before = energy_of(*map, 1);
    WorkingMap working(*map, host);
    const Certificate given = certify(map->polycube, map->triangles, host);
    double change = 0;
    int moved = 0;
    for (const CornerRegion& region : RegionFinder(working, host).find_disjoint(250)) {
      CornerMove move(region, working.area, {}, host);
      const double energy = move.evaluate({0.2, -0.1}, nullptr);
      if (!std::isfinite(energy)) continue;
      REQUIRE(cut_region(move, working, host));
      change += energy - move.energy_now();
      ++moved;
    }
    CHECK(moved > 2);
    SurfaceMap made = working.result(host);
    const Certificate certificate = certify(made, host);
    CHECK(certificate.reason == "");
    CHECK(certificate.corners == given.corners);
    CHECK(certificate.patch_count == given.patch_count);
    // Vertices that are beside an edge go onto it, by up to a tenth of their edges' length.
    CHECK(energy_of(made, 1) == doctest::Approx(before + change).epsilon(0.02));
    // The input is there, to the bit, and other vertices lie in its triangles.
    for (std::size_t v = 0; v < map->positions.size(); ++v)
      CHECK(made.positions[v] == map->positions[v]);
    for (std::size_t v = 0; v < made.positions.size(); ++v) {
      Vector3 p = Vector3::Zero();
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexSource& s = made.vertex_sources[v];
        if (s.corner[k] == no_index) continue;
        CHECK(s.weight[k] > 0);
        sum += s.weight[k];
        p += s.weight[k] * map->positions[s.corner[k]];
      }
      CHECK(sum == doctest::Approx(1).epsilon(1e-12));
      if (map == &steps()) CHECK((p - made.positions[v]).norm() < 1e-12);
    }
  }
}

TEST_CASE("A polycube whose corners were moved gets them back" * doctest::test_suite("long")) {
  for (const CornerMethod method : {CornerMethod::trust_region, CornerMethod::gradient}) {
    SurfaceMap map = displaced(refined(test::box_without({1, 1, 1}), 4), {0.3, 0.15});
    const double start = energy_of(map, 1);
    CHECK(start > 2.005);
    const OptimalCorners found = optimize_corners(map, {.method = method}, host);
    CHECK(found.movable == 8);
    CHECK(found.moves > 0);
    CHECK(std::is_sorted(found.energies.rbegin(), found.energies.rend()));
    // An isometry has 2.
    CHECK(found.energies.back() - 2 < 0.1 * (start - 2));
    CHECK(found.certificate.valid());
    CHECK(found.certificate.corners == 8);
  }
}

TEST_CASE("Maps stay valid, energies never rise, and bits are the same for all threads" * doctest::test_suite("long")) {
  for (const CornerMethod method : {CornerMethod::trust_region, CornerMethod::gradient}) {
    const bool domain = method == CornerMethod::trust_region;
    const CornerOptions options{.method = method, .area_weight = 0.5, .domain = domain, .rounds = 2};
    SurfaceMap map = creature();
    const OptimalCorners found = optimize_corners(map, options, host);
    REQUIRE(found.energies.size() >= 2);
    CHECK(std::is_sorted(found.energies.rbegin(), found.energies.rend()));
    CHECK(found.energies.back() < found.energies.front());
    CHECK(found.energies.back() == doctest::Approx(energy_of(map, 0.5)).epsilon(1e-12));
    const Certificate after = certify(map, host);
    CHECK(after.reason == "");
    CHECK(after.corners == found.certificate.corners);
    CHECK(after.genus == 0);
    base::Host one;
    one.thread_count = 1;
    SurfaceMap again = creature();
    const OptimalCorners same = optimize_corners(again, options, one);
    CHECK(same.energies == found.energies);
    REQUIRE(again.polycube.size() == map.polycube.size());
    CHECK(std::memcmp(map.polycube.data(), again.polycube.data(), map.polycube.size() * sizeof(Vector3)) == 0);
  }
}

TEST_CASE("Neither a motion nor the size of the surface matters" * doctest::test_suite("long")) {
  SurfaceMap map = creature(), moved = creature();
  const Eigen::AngleAxisd turn(0.9, Vector3(1, 2, 2).normalized());
  for (Vector3& p : moved.positions)
    p = 2 * (turn * p) + Vector3(5, -3, 1);
  const OptimalCorners found = optimize_corners(map, {.rounds = 1}, host);
  const OptimalCorners same = optimize_corners(moved, {.rounds = 1}, host);
  CHECK(same.energies.front() == doctest::Approx(found.energies.front()).epsilon(1e-10));
  // Rounding decides where a corner is on an edge or beside it.
  CHECK(same.energies.back() == doctest::Approx(found.energies.back()).epsilon(1e-2));
}

TEST_CASE("An isometry stays as it is, and wrong options are refused") {
  SurfaceMap map = refined(test::box_without({2, 1, 1}), 2);
  const Array<Vector3> before = map.polycube;
  const OptimalCorners found = optimize_corners(map, {}, host);
  CHECK(found.converged);
  CHECK(found.energies.back() == doctest::Approx(2).epsilon(1e-12));
  CHECK(map.polycube == before);
  CHECK_THROWS_AS(optimize_corners(map, {.area_weight = -1}, host), base::Error);
  CHECK_THROWS_AS(optimize_corners(map, {.method = static_cast<CornerMethod>(5)}, host), base::Error);
  SurfaceMap uncertified;
  CHECK_THROWS_AS(optimize_corners(uncertified, {}, host), base::Error);
}
