// What a map is for, by time.
//
//   bench-sphere-map-uses inverse [FILE...]   queries a second on a shape made here and on the files' surfaces
//   bench-sphere-map-uses rest                seconds of remeshing, images, distances, overlays, rotations and warps
//
// The peer beside the inverse looks for the nearest triangle of the flat map with a tree of boxes, as one would without
// a locator of its own; it is not exact at the borders.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/files/read.h"
#include "mesh/search/distances.h"
#include "mesh/search/nearest.h"
#include "mesh/shapes/make_shape.h"
#include "sphere_map/correspondence/overlay.h"
#include "sphere_map/correspondence/sphere_warp.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sampling/geometry_image.h"
#include "sphere_map/sampling/grids.h"
#include "sphere_map/sampling/locator.h"
#include "sphere_map/sampling/sampling.h"
#include "sphere_map/sphere_map.h"

using namespace orbicube;

namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Into some of the triangles come triangles in triangles, each a fiftieth of the one before, down to what double holds.
void nest(std::vector<mesh::Triangle>& triangles, std::vector<mesh::Vector3>& directions) {
  const std::size_t count = triangles.size();
  for (std::size_t first = 0; first < count; first += 50) {
    std::size_t triangle = first;
    for (int level = 0; level < 12; ++level) {
      const auto [a, b, c] = triangles[triangle];
      const mesh::Vector3& p = directions[a];
      const mesh::Vector3 added = (p + 0.01 * (directions[b] + directions[c] - 2 * p)).normalized();
      const auto v = static_cast<mesh::Index>(directions.size());
      directions.push_back(added);
      const std::vector<mesh::Triangle> parts{{v, b, c}, {a, v, c}, {a, b, v}};
      if (sphere_map::count_not_positive(parts, directions) > 0) {
        directions.pop_back();
        break;
      }
      triangles[triangle] = parts[0];
      triangles.insert(triangles.end(), {parts[1], parts[2]});
      triangle = triangles.size() - 1 - static_cast<std::size_t>(level % 2);
    }
  }
}

void row(const std::string& name, std::span<const mesh::Triangle> triangles, std::span<const mesh::Vector3> directions,
         bool on_surface) {
  base::Host host;
  host.thread_count = 1;
  double start = cpu_seconds();
  const sphere_map::Locator locator(triangles, directions, host);
  const double build = cpu_seconds() - start;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<mesh::Vector3> queries(1'000'000);
  for (mesh::Vector3& d : queries) {
    d = mesh::Vector3(normal(random), normal(random), normal(random)).normalized();
    if (on_surface) {  // a random point of a random triangle
      const mesh::Triangle& t = triangles[random() % triangles.size()];
      d = (d.x() * d.x() * directions[t[0]] + d.y() * d.y() * directions[t[1]] + d.z() * d.z() * directions[t[2]])
              .normalized();
    }
  }
  std::vector<mesh::Index> found(queries.size());
  start = cpu_seconds();
  locator.for_each_location(queries, host,
                            [&](std::size_t i, const sphere_map::Location& at) { found[i] = at.triangle; });
  const double seconds = cpu_seconds() - start;

  const std::size_t tried = 20'000;
  const mesh::SurfaceSearch search(directions, triangles, host);
  std::size_t same = 0;
  start = cpu_seconds();
  for (std::size_t i = 0; i < tried; ++i)
    same += search.nearest(queries[i]).triangle == found[i];
  const double peer = (cpu_seconds() - start) / static_cast<double>(tried);
  std::printf("%-24s %9zu %9s %9.3f %10.2f %12.2f %9.1f%%\n", name.c_str(), directions.size(),
              on_surface ? "triangles" : "sphere", build, 1e-6 * static_cast<double>(queries.size()) / seconds,
              1e-6 / peer, 100.0 * static_cast<double>(same) / static_cast<double>(tried));
  std::fflush(stdout);
}

void rows(const std::string& name, const mesh::Mesh& surface) {
  const auto directions = sphere_map::compute(surface.positions, surface.triangles, {}, base::Host());
  row(name, surface.triangles, directions, false);
  row(name, surface.triangles, directions, true);
  std::vector<mesh::Triangle> triangles(surface.triangles.begin(), surface.triangles.end());
  std::vector<mesh::Vector3> nested(directions.begin(), directions.end());
  nest(triangles, nested);
  row(name + ", nested", triangles, nested, true);
}

int inverse(const std::vector<std::string>& files) {
  std::printf("%-24s %9s %9s %9s %10s %12s %10s\n", "map", "vertices", "queries", "build s", "M / s", "boxes, M / s",
              "they agree");
  rows("creature", mesh::make_shape("creature", {.triangles = 70'000}, base::Host()));
  for (const std::string& file : files)
    rows(std::filesystem::path(file).filename().string(), mesh::read_mesh(file, {}, base::Host()));
  return 0;
}

// Runs `work` on one thread and prints its CPU seconds.
template <class Work>
void timed(const std::string& what, const Work& work) {
  base::Host host;
  host.thread_count = 1;
  const double start = cpu_seconds();
  work(host);
  std::printf("%-48s %8.3f\n", what.c_str(), cpu_seconds() - start);
  std::fflush(stdout);
}

// Spread directions, each moved by a part of how far they are apart.
std::vector<mesh::Vector3> landmarks(std::size_t count, double moved) {
  std::mt19937_64 random(count);
  std::normal_distribution<double> normal;
  std::vector<mesh::Vector3> still, result;
  const double apart = 1.5 / std::sqrt(static_cast<double>(count));
  while (result.size() < count) {
    const mesh::Vector3 d = mesh::Vector3(normal(random), normal(random), normal(random)).normalized();
    const mesh::Vector3 shift = mesh::Vector3(normal(random), normal(random), normal(random)).normalized();
    if (std::any_of(still.begin(), still.end(), [&](const mesh::Vector3& e) { return (e - d).norm() < apart; }))
      continue;
    still.push_back(d);
    result.push_back((d + moved * apart * shift).normalized());
  }
  return result;
}

int rest() {
  const mesh::Mesh a = mesh::make_shape("creature", {.triangles = 70'000}, base::Host());
  const mesh::Mesh b = mesh::make_shape("star", {.triangles = 70'000}, base::Host());
  const auto map_a = sphere_map::compute(a.positions, a.triangles, {}, base::Host());
  const auto map_b = sphere_map::compute(b.positions, b.triangles, {}, base::Host());
  const sphere_map::Locator locator_a(a.triangles, map_a, base::Host());
  std::printf("shapes of %zu and %zu vertices, CPU seconds on one core\n", a.positions.size(), b.positions.size());
  mesh::Mesh remeshed;
  timed("remesh on an icosphere of 40962 vertices", [&](const base::Host& host) {
    const auto grid = sphere_map::make_grid(sphere_map::GridKind::icosphere, 6, host);
    remeshed.positions =
        sphere_map::sample_vectors(locator_a, grid.directions, a.positions, sphere_map::Interpolation::linear, host);
    remeshed.triangles = grid.triangles;
  });
  timed("distance from the surface to it and back", [&](const base::Host& host) {
    mesh::surface_distance(a.positions, a.triangles, remeshed.positions, remeshed.triangles, host);
  });
  timed("geometry image of 513 x 513 pixels", [&](const base::Host& host) {
    sphere_map::make_geometry_image(locator_a, a.positions, sphere_map::ImageLayout::octahedron, 512, host);
  });
  timed("overlay of the two maps", [&](const base::Host& host) {
    const sphere_map::PlacedMap other{map_b, b.triangles};
    sphere_map::overlay({map_a, a.triangles}, {&other, 1}, host);
  });
  for (const std::size_t count : {5U, 20U, 80U}) {
    timed("warp between " + std::to_string(count) + " landmarks",
          [&](const base::Host& host) { sphere_map::SphereWarp(landmarks(count, 0), landmarks(count, 0.3), host); });
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (!arguments.empty() && arguments[0] == "inverse") return inverse({arguments.begin() + 1, arguments.end()});
    if (!arguments.empty() && arguments[0] == "rest") return rest();
  } catch (const base::Error& error) {
    std::fprintf(stderr, "%s: %s\n", error.kind(), error.what());
    return 1;
  }
  std::fprintf(stderr, "usage: %s inverse [FILE...] | rest\n", argv[0]);
  return 2;
}
