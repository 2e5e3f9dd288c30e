// The parts of the hierarchy: rings, decimation, kernels, the queue, vertex steps.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "mesh/search/predicates.h"
#include "mesh/topology/topology.h"
#include "shapes.h"
#include "sphere_map/hierarchy/bucket_queue.h"
#include "sphere_map/hierarchy/decimation.h"
#include "sphere_map/hierarchy/spherical_kernel.h"
#include "sphere_map/optimization/vertex_step.h"

using namespace orbicube;
using namespace orbicube::sphere_map;

namespace {

auto* const memory = std::pmr::get_default_resource();

// The triangles that the rings stand for, each once, lowest vertex first. A removed vertex keeps its ring.
std::vector<Triangle> triangles_of(const VertexRings& rings, const std::set<Index>& removed) {
  std::vector<Triangle> result;
  for (Index v = 0; v < rings.vertex_count(); ++v) {
    if (removed.count(v)) continue;
    const auto ring = rings[v];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Index q = ring[i];
      const Index r = ring[(i + 1) % ring.size()];
      if (v < q && v < r) result.push_back({v, q, r});
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

TEST_CASE("Every mesh of a decimation is a closed manifold of genus 0, and splits undo collapses exactly") {
  const test::Surface s = test::creature(3);
  const base::Host host;
  const VertexRings start(s.positions.size(), s.triangles, host);
  // By one queue, and by regions first: of a fifth of the vertices, and again of a fifth of what these leave.
  for (const std::size_t region_size : {usual_region_size, s.positions.size() / 20}) {
    CAPTURE(region_size);
    Decimation d = decimate(s.positions, start, 0, host, base::ThreadPool(host), region_size);
    REQUIRE(d.collapses.size() == s.positions.size() - 4);

    VertexRings rings = start;
    std::set<Index> removed;
    std::vector<std::vector<Triangle>> meshes = {triangles_of(rings, removed)};
    for (const Collapse& c : d.collapses) {
      rings.collapse(c, d.ring(c));
      removed.insert(c.removed);
      meshes.push_back(triangles_of(rings, removed));
      const auto facts = mesh::topology(s.positions, meshes.back(), base::Host());
      REQUIRE(facts.closed());
      REQUIRE(facts.manifold());
      REQUIRE(facts.genus == 0);
      REQUIRE(facts.inconsistent_edges == 0);
    }
    CHECK(meshes.back().size() == 4);
    CHECK(triangles_of(d.rings, removed) == meshes.back());
    for (std::size_t i = d.collapses.size(); i-- > 0;) {
      d.rings.split(d.collapses[i], d.ring(d.collapses[i]));
      removed.erase(d.collapses[i].removed);
      REQUIRE(triangles_of(d.rings, removed) == meshes[i]);
    }
  }
}

TEST_CASE("Regions are decimated the same on any number of threads") {
  const test::Surface s = test::creature(5);
  base::Host host;
  const VertexRings start(s.positions.size(), s.triangles, host);
  const std::size_t region_size = s.positions.size() / 20;
  std::vector<Decimation> results;
  for (const unsigned threads : {1U, 2U, 7U}) {
    host.thread_count = threads;
    results.push_back(decimate(s.positions, start, 0, host, base::ThreadPool(host), region_size));
  }
  const auto removed = [](const Decimation& d) {
    std::vector<std::array<Index, 2>> pairs;
    for (const Collapse& c : d.collapses)
      pairs.push_back({c.removed, c.kept});
    return pairs;
  };
  for (const Decimation& d : results) {
    CHECK(removed(d) == removed(results[0]));
    CHECK(d.tetrahedron == results[0].tetrahedron);
    for (std::size_t i = 0; i < d.collapses.size(); ++i)
      REQUIRE(std::ranges::equal(d.ring(d.collapses[i]), results[0].ring(results[0].collapses[i])));
  }
  // Without regions the order is another one: they were at work.
  const Decimation whole = decimate(s.positions, start, 0, host, base::ThreadPool(host));
  CHECK(removed(whole) != removed(results[0]));
}

TEST_CASE("The queue hands out priorities in order to within a factor of two, first come first served") {
  BucketQueue queue(1000, memory);
  queue.start(1.0);
  std::mt19937_64 random(9);
  std::vector<double> priority(1000);
  for (Index i = 0; i < 1000; ++i) {
    priority[i] = std::exp2(-std::uniform_real_distribution<double>(0, 40)(random));
    queue.raise(i, 0.5 * priority[i]);
    queue.raise(i, priority[i]);
    queue.raise(i, 0.1 * priority[i]);  // lower: changes nothing
  }
  queue.hold(17);
  queue.raise(17, 1);
  double last = 1;
  std::set<Index> seen;
  while (!queue.empty()) {
    const Index i = queue.pop();
    CHECK(priority[i] <= 2 * last);
    last = std::min(last, priority[i]);
    CHECK(seen.insert(i).second);
  }
  CHECK(seen.size() == 999);
  CHECK(seen.count(17) == 0);
  queue.release(17);
  for (const Index i : {5U, 17U, 3U})
    queue.raise(i, 0.3);
  CHECK(queue.pop() == 5);
  CHECK(queue.pop() == 17);
  CHECK(queue.pop() == 3);
}

TEST_CASE("The centroid of a kernel sees its whole ring, also of a ring that is not star-shaped from most points") {
  KernelPolygon polygon(memory);
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(0, 1);
  int found = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const int n = 3 + trial % 9;
    const double size = std::pow(10.0, -3 * uniform(random));
    std::vector<Vector3> directions;
    std::vector<Index> ring;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * M_PI * (i + 0.8 * uniform(random)) / n;
      const double radius = size * (i == 0 ? 0 : 0.3 + uniform(random));
      // The first vertex, which the new one is split from, is at the center of the others.
      directions.push_back(Vector3(radius * std::cos(angle), radius * std::sin(angle), 1).normalized());
      ring.push_back(static_cast<Index>(i));
    }
    const auto point = kernel_centroid(ring, 0, directions, polygon);
    if (!point) continue;
    ++found;
    CHECK(point->norm() == doctest::Approx(1).epsilon(1e-15));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector3& next = directions[ring[(i + 1) % ring.size()]];
      CHECK(mesh::orientation_from_origin(*point, directions[ring[i]], next) > 0);
    }
  }
  CHECK(found > 500);
}

TEST_CASE("The centroid of a regular ring is its center, of a ring with a clockwise corner nothing") {
  KernelPolygon polygon(memory);
  std::vector<Vector3> directions;
  std::vector<Index> ring;
  for (Index i = 0; i < 6; ++i) {
    directions.push_back(Vector3(std::cos(M_PI * i / 3), std::sin(M_PI * i / 3), 4).normalized());
    ring.push_back(i);
  }
  REQUIRE(polygon.cut(ring, directions, Vector3::UnitZ(), mesh::no_index));
  CHECK((*polygon.area_centroid() - Vector3::UnitZ()).norm() < 1e-12);
  std::reverse(ring.begin(), ring.end());
  CHECK_FALSE(polygon.cut(ring, directions, Vector3::UnitZ(), mesh::no_index));
}

TEST_CASE("A step lowers the energy by what it says, keeps the star positive, and ends where nothing is to be gained") {
  const test::Surface s = test::sphere(2);
  const VertexRings rings(s.positions.size(), s.triangles, base::Host());
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  Energy energy;
  energy.weights = {.angle = 0.1, .area = 1, .isometric = 0.05, .quasi_conformal_4 = 1e-3};
  energy.uniform_area = 4 * M_PI / static_cast<double>(s.triangles.size());
  StepScratch scratch(memory);
  std::vector<Vector3> directions = s.positions;
  for (Index v = 0; v < directions.size(); ++v) {
    std::vector<StarTriangle> star;
    for (std::size_t i = 0; i < rings[v].size(); ++i) {
      const Index q = rings[v][i];
      const Index r = rings[v][(i + 1) % rings[v].size()];
      star.push_back({q, r, triangle_shape(s.positions[v], s.positions[q], s.positions[r])});
    }
    const Vector3 home = directions[v];
    directions[v] = (home + 0.1 * Vector3(normal(random), normal(random), normal(random))).normalized();
    const double before = star_energy(energy, star, directions[v], directions);
    if (!std::isfinite(before)) {
      directions[v] = home;
      continue;
    }
    double value = before;
    for (int step = 0; step < 30; ++step) {
      const StepResult result = improve_vertex(energy, v, star, directions, scratch);
      const double now = star_energy(energy, star, directions[v], directions);
      CHECK(now <= value);
      CHECK(value - now == doctest::Approx(result.gain).epsilon(1e-6));
      for (const StarTriangle& t : star) {
        REQUIRE(mesh::orientation_from_origin(directions[v], directions[t.q], directions[t.r]) > 0);
      }
      value = now;
    }
    // A local minimum of the star: no small move in any direction is lower.
    const TangentBasis basis(directions[v]);
    for (int k = 0; k < 8; ++k) {
      const Vector3 moved =
          (directions[v] + 1e-3 * (std::cos(M_PI * k / 4) * basis.first + std::sin(M_PI * k / 4) * basis.second))
              .normalized();
      CHECK(star_energy(energy, star, moved, directions) > value);
    }
    directions[v] = home;
  }
}
