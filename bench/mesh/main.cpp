// Prints what the library's work on a surface in memory costs, by the number of triangles, and searches for the nearest
// vertex beside nanoflann. One thread; seconds are those that it ran, whatever else the machine does.
//
//     bench-mesh [triangles...]
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#ifdef ORBICUBE_BENCH_NANOFLANN
#include <nanoflann.hpp>
#endif

#include "bench/measuring.h"
#include "mesh/search/intersections.h"
#include "mesh/search/nearest.h"
#include "mesh/search/predicates.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/connectivity.h"
#include "mesh/topology/orient.h"
#include "mesh/topology/topology.h"
#include "mesh/topology/weld.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

// Runs `work(host)` and prints its seconds and bytes a triangle.
template <class Work>
void row(const char* name, std::size_t triangles, const Work& work) {
  bench::CountingMemory memory;
  base::Host host;
  host.thread_count = 1;
  host.memory = &memory;
  const double start = bench::cpu_seconds();
  work(host);
  const double seconds = bench::cpu_seconds() - start;
  std::printf("| %-34s | %10zu | %8.3f | %8.1f |\n", name, triangles, seconds,
              static_cast<double>(memory.peak()) / static_cast<double>(triangles));
}

// Seconds for each of `count` calls.
template <class Call>
double seconds_each(std::size_t count, const Call& call) {
  const double start = bench::cpu_seconds();
  for (std::size_t i = 0; i < count; ++i)
    call(i);
  return (bench::cpu_seconds() - start) / static_cast<double>(count);
}

#ifdef ORBICUBE_BENCH_NANOFLANN
struct Cloud {
  const Array<Vector3>& positions;
  std::size_t kdtree_get_point_count() const { return positions.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return positions[i][static_cast<Eigen::Index>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
#endif

void searches(const Mesh& surface) {
  constexpr std::size_t count = 200000;
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal(0, 0.01);
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 shift(normal(engine), normal(engine), normal(engine));
    points.push_back(surface.positions[engine() % surface.positions.size()] + shift);
  }
  base::Host host;
  const VertexSearch vertices(surface.positions, host);
  const SurfaceSearch search(surface.positions, surface.triangles, host);
  double sum = 0;
  const double vertex = seconds_each(
      count, [&](std::size_t i) { sum += (surface.positions[vertices.nearest(points[i])] - points[i]).norm(); });
  const double on_surface = seconds_each(count, [&](std::size_t i) { sum -= search.nearest(points[i]).distance; });
  std::printf("\n%zu triangles: nearest vertex %.2f us, nearest point of the surface %.2f us (mean difference %.6f)\n",
              surface.triangles.size(), 1e6 * vertex, 1e6 * on_surface, sum / static_cast<double>(count));
#ifdef ORBICUBE_BENCH_NANOFLANN
  const Cloud cloud{surface.positions};
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3>;
  const double start = bench::cpu_seconds();
  Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree.buildIndex();
  const double built = bench::cpu_seconds() - start;
  std::size_t differ = 0;
  std::size_t at = 0;
  double squared = 0;
  const double peer = seconds_each(count, [&](std::size_t i) {
    nanoflann::KNNResultSet<double> result(1);
    result.init(&at, &squared);
    tree.findNeighbors(result, points[i].data(), nanoflann::SearchParams());
    differ += (surface.positions[at] - points[i]).norm() !=
              (surface.positions[vertices.nearest(points[i])] - points[i]).norm();
  });
  std::printf("nanoflann: built in %.3f s, nearest vertex %.2f us, %zu results at another distance\n", built,
              1e6 * (peer - vertex), differ);
#endif
}

void predicates() {
  std::mt19937_64 engine(2);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto point = [&] { return Vector3(number(engine), number(engine), number(engine)); };
  std::vector<Vector3> p(3001);
  for (Vector3& x : p)
    x = point();
  constexpr std::size_t count = 1000000;
  int sum = 0;
  const double general = seconds_each(count, [&](std::size_t i) {
    const std::size_t k = i % 3000;
    sum += orientation_from_origin(p[k], p[(k + 7) % 3000], p[(k + 31) % 3000]);
  });
  double plain_sum = 0;
  const double plain = seconds_each(count, [&](std::size_t i) {
    const std::size_t k = i % 3000;
    plain_sum += p[k].cross(p[(k + 7) % 3000]).dot(p[(k + 31) % 3000]) > 0 ? 1 : -1;
  });
  std::size_t zeros = 0;
  const double exact = seconds_each(count / 10, [&](std::size_t i) {
    const std::size_t k = i % 3000;
    zeros += orientation_from_origin(p[k], p[(k + 7) % 3000], 0.5 * (p[k] + p[(k + 7) % 3000])) == 0;
  });
  std::printf(
      "\norientation from the origin: %.1f ns for points in general position (a determinant of doubles: %.1f ns), "
      "%.0f ns where the filter cannot decide (%zu of %zu exactly 0; sums %d, %.0f)\n",
      1e9 * general, 1e9 * plain, 1e9 * exact, zeros, count / 10, sum, plain_sum);
}

}  // namespace

int main(int argument_count, char** arguments) {
  std::vector<std::size_t> sizes;
  for (int i = 1; i < argument_count; ++i)
    sizes.push_back(std::strtoull(arguments[i], nullptr, 10));
  if (sizes.empty()) sizes = {10000, 100000, 1000000};
  std::printf("| %-34s | %10s | %8s | %8s |\n|---|---|---|---|\n", "", "triangles", "s", "B each");
  Mesh largest;
  for (const std::size_t size : sizes) {
    Mesh surface = make_shape("creature", {size, 0}, base::Host());
    const std::size_t n = surface.triangles.size();
    row("topology", n, [&](const base::Host& host) { topology(surface.positions, surface.triangles, host); });
    row("consistent orientation", n,
        [&](const base::Host& host) { orient(surface.positions, surface.triangles, host); });
    row("half-edges", n,
        [&](const base::Host& host) { const Connectivity made(surface.positions.size(), surface.triangles, host); });
    row("vertices at one position", n,
        [&](const base::Host& host) { first_at_same_position(surface.positions, host); });
    row("search tree of the triangles", n,
        [&](const base::Host& host) { const SurfaceSearch made(surface.positions, surface.triangles, host); });
    row("intersections, all pairs", n,
        [&](const base::Host& host) { intersecting_triangles(surface.positions, surface.triangles, host); });
    largest = std::move(surface);
  }
  searches(largest);
  predicates();
  return 0;
}
