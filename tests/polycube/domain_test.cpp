// The best proportions of a polycube: derivatives, optima that are known, the same optimum from everywhere, and maps
// that stay valid.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "base/error.h"
#include "blocks.h"
#include "mesh/shapes/make_shape.h"
#include "polycube/domain/optimal_domain.h"
#include "polycube/voxels/voxel_construction.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::area_of;
using test::host;

namespace {

const std::array<DomainMeasure, 3> measures = {DomainMeasure::surface_mean, DomainMeasure::face_mean,
                                               DomainMeasure::harmonic};

// Cells stretched in space, certified as a map to the cells as they are.
SurfaceMap stretched(const std::vector<test::Cell>& cells, const Vector3& stretch) {
  const mesh::Mesh m = test::blocks(cells);
  SurfaceMap map;
  map.polycube = m.positions;
  for (const Vector3& p : m.positions)
    map.positions.push_back(p.cwiseProduct(stretch));
  map.triangles = m.triangles;
  set_unrefined(map);
  REQUIRE(certify(map, host).valid());
  return map;
}

// The map of a made shape, with triangles in cells and across layers.
const SurfaceMap& layered_creature() {
  static const SurfaceMap map = [] {
    const mesh::Mesh m = mesh::make_shape("creature", {.triangles = 2500}, host);
    return construct_by_voxels(m.positions, m.triangles, {.corners = 40}, host).map;
  }();
  return map;
}

std::vector<double> varied(std::span<const double> lengths, double most, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> exponent(-std::log(most), std::log(most));
  std::vector<double> result(lengths.begin(), lengths.end());
  for (double& length : result)
    length *= std::exp(exponent(random));
  return result;
}

Vector3 extent(std::span<const Vector3> positions) {
  Vector3 low = positions[0], high = positions[0];
  for (const Vector3& p : positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return high - low;
}

}  // namespace

TEST_CASE("The energy is what distortion.h measures, for cells and for triangles across layers") {
  const SurfaceMap& map = layered_creature();
  const CoordinateLayers layers = find_layers(map, host);
  const Distortion d = measure_distortion(map, host);
  const polycube::DomainEnergy by_surface(map, layers, DomainMeasure::surface_mean, 0.7, host);
  CHECK(by_surface.crossing() > 0);
  CHECK(by_surface.cells() > 0);
  // Sums of thousands of terms, some of them large.
  CHECK(by_surface.evaluate(by_surface.lengths(), {}) ==
        doctest::Approx(d.angle_weighted_mean + 0.7 * d.area_weighted_mean).epsilon(1e-10));
  const polycube::DomainEnergy by_face(map, layers, DomainMeasure::face_mean, 0.7, host);
  CHECK(by_face.evaluate(by_face.lengths(), {}) == doctest::Approx(d.angle_mean + 0.7 * d.area_mean).epsilon(1e-10));
  CHECK(by_face.area(by_face.lengths()) == doctest::Approx(area_of(map.polycube, map.triangles)).epsilon(1e-12));
  // And of other lengths: those of the map that has them.
  std::array<Array<double>, 3> positions = layers.positions;
  std::vector<double> lengths;
  for (Array<double>& along : positions) {
    for (std::size_t i = 0; i < along.size(); ++i)
      along[i] += 0.3 * std::abs(along[i] - along[0]);
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
      lengths.push_back(along[i + 1] - along[i]);
    for (double& x : along)
      x -= 1;
  }
  lengths[0] *= 1.5;
  for (std::size_t i = 1; i < positions[0].size(); ++i)
    positions[0][i] += lengths[0] / 3;
  SurfaceMap moved = map;
  place_vertices(layers, positions, moved.polycube);
  const Distortion after = measure_distortion(moved, host);
  CHECK(by_face.evaluate(lengths, {}) == doctest::Approx(after.angle_mean + 0.7 * after.area_mean).epsilon(1e-10));
}

TEST_CASE("The gradient is that of differences, in cells and across layers") {
  const SurfaceMap& map = layered_creature();
  const CoordinateLayers layers = find_layers(map, host);
  for (const DomainMeasure measure : measures) {
    const polycube::DomainEnergy energy(map, layers, measure, 0.4, host);
    const std::vector<double> at = varied(energy.lengths(), 1.1, 3);
    std::vector<double> gradient(at.size()), x = at;
    const double value = energy.evaluate(at, gradient);
    REQUIRE(std::isfinite(value));
    double along = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      // Fourth order, so that the step can be long enough for rounding not to matter.
      const auto shifted = [&](double by) {
        x[i] = at[i] * (1 + by);
        const double result = energy.evaluate(x, {});
        x[i] = at[i];
        return result;
      };
      const double h = 1e-4;
      const double difference =
          (8 * (shifted(h) - shifted(-h)) - (shifted(2 * h) - shifted(-2 * h))) / (12 * h * at[i]);
      CHECK(gradient[i] * at[i] == doctest::Approx(difference * at[i]).epsilon(1e-7).scale(value));
      along += gradient[i] * at[i];
    }
    // Nothing changes with the size.
    CHECK(std::abs(along) < 1e-11 * value * static_cast<double>(at.size()));
    for (double& length : x)
      length *= 3;
    CHECK(energy.evaluate(x, {}) == doctest::Approx(value).epsilon(1e-12));
  }
}

TEST_CASE("A stretched box gets the box's proportions, an isometry, whatever is measured") {
  const Vector3 stretch(3, 0.25, 1.7);
  for (const DomainMeasure measure : measures) {
    for (const DomainVariables variables : {DomainVariables::logarithms, DomainVariables::lengths}) {
      SurfaceMap map = stretched(test::box_without({2, 1, 1}), stretch);
      const double area = area_of(map.polycube, map.triangles);
      const OptimalDomain found =
          optimize_domain(map, {.measure = measure, .area_weight = 0.5, .variables = variables}, host);
      CHECK(found.converged);
      CHECK(found.crossing == 0);
      CHECK(found.layers == 6);
      CHECK(found.cells == 3);
      // The energy is quadratic about the optimum.
      CHECK(found.energies.back() == doctest::Approx(1.5).epsilon(1e-11));
      const Vector3 size = extent(map.polycube), wanted = extent(map.positions);
      CHECK((size / size.norm() - wanted / wanted.norm()).norm() < 1e-6);
      CHECK(area_of(map.polycube, map.triangles) == doctest::Approx(area).epsilon(1e-14));
      CHECK(found.certificate.valid());
      CHECK(found.certificate.corners == 8);
      CHECK(found.distortion.angle_mean == doctest::Approx(1).epsilon(1e-11));
    }
  }
}

TEST_CASE("Layers that are no neighbors in space share their slabs, and an isometry with them is found again") {
  // An L with a notch, stretched slab by slab.
  const std::vector<test::Cell> cells = test::box_without({4, 3, 2}, {{3, 2, 0}, {3, 2, 1}, {0, 1, 1}, {2, 0, 0}});
  SurfaceMap map = stretched(cells, {1, 1, 1});
  const std::array<std::array<double, 5>, 3> planes = {{{0, 0.4, 3, 3.5, 7}, {1, 2, 2.2, 4, 0}, {-1, 0.5, 1, 0, 0}}};
  for (Vector3& p : map.positions)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& x = p[static_cast<Eigen::Index>(axis)];
      x = planes[axis][static_cast<std::size_t>(x)];
    }
  const OptimalDomain found = optimize_domain(map, {}, host);
  CHECK(found.energies.back() == doctest::Approx(2).epsilon(1e-11));
  for (std::size_t v = 0; v < map.positions.size(); ++v) {
    const double scale = extent(map.polycube).x() / extent(map.positions).x();
    CHECK((map.polycube[v] - map.polycube[0] - scale * (map.positions[v] - map.positions[0])).norm() < 1e-5);
  }
}

TEST_CASE("Angles and areas pull where the weight says") {
  const SurfaceMap& map = layered_creature();
  std::array<Distortion, 2> d;
  for (const bool areas : {false, true}) {
    SurfaceMap own = map;
    d[areas ? 1 : 0] = optimize_domain(own, {.area_weight = areas ? 100.0 : 0.01}, host).distortion;
  }
  CHECK(d[0].angle_weighted_mean < d[1].angle_weighted_mean);
  CHECK(d[0].area_weighted_mean > d[1].area_weighted_mean);
}

TEST_CASE("From other starts, and in lengths as in logarithms, the same energy is reached") {
  const SurfaceMap& map = layered_creature();
  const CoordinateLayers layers = find_layers(map, host);
  for (const DomainMeasure measure : {DomainMeasure::surface_mean, DomainMeasure::face_mean}) {
    const polycube::DomainEnergy energy(map, layers, measure, 1, host);
    const DomainMinimum first = minimise_domain(energy, energy.lengths(), {}, host);
    REQUIRE(first.converged);
    CHECK(first.energies.back() < first.energies.front());
    std::size_t started = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const std::vector<double> start = varied(energy.lengths(), 1.6, seed);
      if (!std::isfinite(energy.evaluate(start, {}))) continue;
      ++started;
      for (const DomainVariables variables : {DomainVariables::logarithms, DomainVariables::lengths}) {
        const DomainMinimum other =
            minimise_domain(energy, start, {.variables = variables, .max_iterations = 5000}, host);
        CHECK(other.converged);
        CHECK(other.energies.back() == doctest::Approx(first.energies.back()).epsilon(1e-9));
      }
    }
    CHECK(started > 0);
  }
}

TEST_CASE(
    "Maps stay valid and keep their area and center, energies never rise, and bits are the same for all threads") {
  for (const DomainMeasure measure : measures) {
    SurfaceMap map = layered_creature();
    const Vector3 size = extent(map.polycube);
    const double area = area_of(map.polycube, map.triangles);
    Certificate before = certify(map, host);
    base::Host one;
    one.thread_count = 1;
    SurfaceMap again = map;
    const OptimalDomain found = optimize_domain(map, {.measure = measure}, host);
    const OptimalDomain same = optimize_domain(again, {.measure = measure}, one);
    CHECK(std::memcmp(map.polycube.data(), again.polycube.data(), map.polycube.size() * sizeof(Vector3)) == 0);
    CHECK(found.energies == same.energies);
    REQUIRE(found.energies.size() >= 2);
    CHECK(std::is_sorted(found.energies.rbegin(), found.energies.rend()));
    CHECK(found.energies.back() < found.energies.front());
    const Certificate after = certify(map.polycube, map.triangles, host);
    CHECK(after.valid());
    CHECK(after.corners == before.corners);
    CHECK(after.labels == before.labels);
    CHECK(after.patches == before.patches);
    CHECK(area_of(map.polycube, map.triangles) == doctest::Approx(area).epsilon(1e-12));
    CHECK((extent(map.polycube) - size).norm() > 1e-3);
    // There is hardly anything left to gain: the solver stops at a small gradient, and in logarithms that of a thin
    // layer is small long before its thickness is found. A start from positions rounds lengths again.
    const OptimalDomain once_more = optimize_domain(map, {.measure = measure}, host);
    CHECK(once_more.energies.back() <= found.energies.back() * (1 + 1e-14));
    CHECK(once_more.energies.back() == doctest::Approx(found.energies.back()).epsilon(1e-5));
  }
}

TEST_CASE("An optimum stays as it is, and wrong options are refused") {
  SurfaceMap map = stretched(test::box_without({3, 2, 1}, {{2, 1, 0}}), {1, 1, 1});
  const std::vector<Vector3> before(map.polycube.begin(), map.polycube.end());
  const OptimalDomain found = optimize_domain(map, {}, host);
  CHECK(found.energies == Array<double>(found.energies.size(), found.energies.front()));
  CHECK(std::equal(before.begin(), before.end(), map.polycube.begin()));
  CHECK_THROWS_AS(optimize_domain(map, {.area_weight = -1}, host), base::Error);
  CHECK_THROWS_AS(optimize_domain(map, {.measure = static_cast<DomainMeasure>(7)}, host), base::Error);
  SurfaceMap uncertified;
  CHECK_THROWS_AS(optimize_domain(uncertified, {}, host), base::Error);
}

TEST_CASE("Lengths at which a map has no energy stay as they are") {
  const std::array start = {1.0, 2.0, 4.0};
  const LengthEnergy none = [](std::span<const double>, std::span<double> gradient) {
    std::fill(gradient.begin(), gradient.end(), 0.0);
    return std::numeric_limits<double>::infinity();
  };
  const DomainMinimum found = minimise_domain(none, start, {}, host);
  CHECK(std::equal(start.begin(), start.end(), found.lengths.begin(), found.lengths.end()));
  CHECK_FALSE(found.converged);
}
