// Maps of surfaces with triangles without area, or nearly, and of surfaces at any scale.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/host.h"
#include "blocks.h"
#include "mesh/topology/degenerate_triangles.h"
#include "polycube/corners/optimal_corners.h"
#include "polycube/domain/optimal_domain.h"
#include "polycube/features/features.h"
#include "polycube/map/certificate.h"
#include "polycube/map/construction.h"
#include "polycube/surface/distortion.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::blocks;
using test::box_without;
using test::host;

namespace {

BestConstruction constructed(const mesh::Mesh& m) {
  return construct(m.positions, m.triangles, {.method = Method::labels}, host);
}

// An L of cells, turned; every `each`-th triangle is split on one side of an edge alone, with a triangle of no height
// (but for rounding) in between.
mesh::Mesh turned_blocks(std::size_t each) {
  mesh::Mesh m = blocks(
      box_without({4, 2, 4}, {{2, 0, 2}, {3, 0, 2}, {2, 0, 3}, {3, 0, 3}, {2, 1, 2}, {3, 1, 2}, {2, 1, 3}, {3, 1, 3}}));
  const std::size_t count = m.triangles.size();
  for (std::size_t t = 0; each > 0 && t < count; t += each) {
    const auto [a, b, c] = m.triangles[t];
    const auto v = static_cast<Index>(m.positions.size());
    m.positions.push_back(0.6 * m.positions[a] + 0.4 * m.positions[b]);
    m.triangles[t] = {a, v, c};
    m.triangles.push_back({v, b, c});
    m.triangles.push_back({a, b, v});
  }
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(0.4, Vector3(1, 2, 3).normalized()) * Eigen::AngleAxisd(1, Vector3::UnitX())).matrix();
  for (Vector3& p : m.positions)
    p = turn * p + Vector3(0.3, 1.7, -2.9);
  return m;
}

bool same(const Distortion& a, const Distortion& b) {
  return a.angle_mean == b.angle_mean && a.area_mean == b.area_mean && a.angle_weighted_mean == b.angle_weighted_mean &&
         a.area_weighted_mean == b.area_weighted_mean && a.left_out == b.left_out;
}

}  // namespace

TEST_CASE("Triangles without height but for rounding do not enter the distortion of a polycube map, nor choose it") {
  const BestConstruction without = constructed(turned_blocks(0));
  CHECK(without.made.distortion.left_out == 0);
  const mesh::Mesh m = turned_blocks(5);
  const std::size_t degenerate = mesh::count_degenerate(m.positions, m.triangles);
  REQUIRE(degenerate >= 10);
  const BestConstruction with = constructed(m);
  const Distortion& d = with.made.distortion;
  CHECK(with.made.certificate.valid());
  CHECK(d.left_out >= degenerate);
  // Not 1: on edges of the polycube such triangles lie in one of its faces, and have some area there.
  CHECK(d.angle_mean < without.made.distortion.angle_mean + 0.1);
  CHECK(d.area_mean < without.made.distortion.area_mean + 0.1);
  CHECK(d.angle_weighted_mean < without.made.distortion.angle_weighted_mean + 0.1);
  CHECK(d.area_weighted_mean < without.made.distortion.area_weighted_mean + 0.1);

  // Of proportions the same is measured.
  const CoordinateLayers layers = find_layers(with.made.map, host);
  const polycube::DomainEnergy energy(with.made.map, layers, DomainMeasure::surface_mean, 0.7, host);
  CHECK(energy.evaluate(energy.lengths(), {}) ==
        doctest::Approx(d.angle_weighted_mean + 0.7 * d.area_weighted_mean).epsilon(1e-10));

  SurfaceMap map = with.made.map;
  const OptimalDomain domain = optimize_domain(map, {.measure = DomainMeasure::face_mean}, host);
  CHECK(domain.energies.back() < 2.2);
}

TEST_CASE("What triangles without height in space cover of the polycube does not enter the areas of others") {
  // The unit cube is its own polycube, an isometry. A vertex in the middle of an edge in space lies outside on the
  // polycube, so that its triangle covers a third of what the others do: at equal total areas these would have the
  // ratio 3 / 4.
  const mesh::Mesh cube = blocks({{0, 0, 0}});
  SurfaceMap map;
  map.positions = cube.positions;
  map.triangles = cube.triangles;
  map.polycube = cube.positions;
  const Index a = cube.triangles[0][0], b = cube.triangles[0][1], v = static_cast<Index>(cube.positions.size());
  const Vector3 side = cube.positions[b] - cube.positions[a];
  map.positions.push_back(0.5 * (cube.positions[a] + cube.positions[b]));
  map.polycube.push_back(map.positions.back() + 4 / side.norm() * side.unitOrthogonal());
  map.triangles.push_back({a, b, v});
  set_unrefined(map);
  const Distortion d = measure_distortion(map, host);
  CHECK(d.left_out == 1);
  CHECK(d.angle_mean == doctest::Approx(1));
  CHECK(d.area_mean == doctest::Approx(1));
  CHECK(d.angle_weighted_mean == doctest::Approx(1));
  CHECK(d.area_weighted_mean == doctest::Approx(1));
}

TEST_CASE("A surface scaled by a power of two has the same polycube map, scaled, and the same figures to the bit") {
  const mesh::Mesh m = test::shape("creature", 300);
  const BestConstruction expected = constructed(m);
  for (const int exponent : {-990, -1, 1, 990}) {
    CAPTURE(exponent);
    mesh::Mesh scaled(m);
    for (Vector3& p : scaled.positions)
      p *= std::ldexp(1.0, exponent);
    const BestConstruction found = constructed(scaled);
    REQUIRE(found.made.map.positions.size() == expected.made.map.positions.size());
    CHECK(found.made.map.triangles == expected.made.map.triangles);
    CHECK(same(found.made.distortion, expected.made.distortion));
    CHECK(same(measure_distortion(found.made.map, host), expected.made.distortion));
    CHECK(std::equal(scaled.positions.begin(), scaled.positions.end(), found.made.map.positions.begin()));
    std::size_t different = 0;
    for (std::size_t v = 0; v < found.made.map.polycube.size(); ++v) {
      // Only what is near zero loses digits, below the least normal number.
      const Vector3 there = expected.made.map.polycube[v] * std::ldexp(1.0, exponent);
      different += (found.made.map.polycube[v] - there).cwiseAbs().maxCoeff() > 1e-320;
    }
    CHECK(different == 0);
  }
}

TEST_CASE("A vertex in no triangle changes no bit of a polycube map") {
  const mesh::Mesh m = test::shape("creature", 300);
  const BestConstruction expected = constructed(m);
  mesh::Mesh with(m);
  with.positions.emplace_back(1e6, -1e7, 3);
  const BestConstruction found = constructed(with);
  CHECK(same(found.made.distortion, expected.made.distortion));
  CHECK(found.made.map.polycube[0] == expected.made.map.polycube[0]);
  CHECK(found.made.map.positions[m.positions.size()] == with.positions.back());
}

TEST_CASE("Proportions, corners and sharp edges of maps of extreme size are improved as those of others") {
  const mesh::Mesh m = turned_blocks(0);
  const SurfaceMap made = constructed(m).made.map;
  const auto at = [&](int exponent) {
    SurfaceMap map = made;
    for (Array<Vector3>* positions : {&map.positions, &map.polycube}) {
      for (Vector3& p : *positions)
        p *= std::ldexp(1.0, exponent);
    }
    return map;
  };
  SurfaceMap plain = at(0);
  const double energy = optimize_domain(plain, {}, host).energies.back();
  for (const int exponent : {-980, 980}) {
    CAPTURE(exponent);
    SurfaceMap map = at(exponent);
    const Array<Vector3> before = map.positions;
    const OptimalDomain domain = optimize_domain(map, {}, host);
    CHECK(domain.certificate.valid());
    CHECK(domain.energies.back() == doctest::Approx(energy).epsilon(1e-9));
    CHECK(map.positions == before);
    CHECK(align_features(map, {.feature_angle = 40}, host).certificate.valid());
    CHECK(optimize_corners(map, {.rounds = 1}, host).certificate.valid());
    CHECK(std::equal(m.positions.begin(), m.positions.end(), map.positions.begin(),
                     [&](const Vector3& a, const Vector3& b) { return a * std::ldexp(1.0, exponent) == b; }));
  }
}
