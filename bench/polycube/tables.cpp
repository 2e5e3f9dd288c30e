#include "tables.h"

#include <cstdio>
#include <cstdlib>

#include "bench/measuring.h"
#include "map_files.h"
#include "polycube/corners/optimal_corners.h"

namespace orbicube::bench {
namespace {

using namespace orbicube::polycube;

void measure(const std::string& file, std::size_t corners, const base::Host& host) {
  const std::string name = stem_of(file);
  double start = cpu_seconds();
  const SurfaceMap map = make_map(file, Method::automatic, corners, host);
  const double constructed = cpu_seconds() - start;
  const Distortion before = measure_distortion(map, host);
  const std::size_t had = certify(map.polycube, map.triangles, host).corners;
  start = cpu_seconds();
  SurfaceMap proportioned = map;
  optimize_domain(proportioned, {}, host);
  const double domain = cpu_seconds() - start;
  for (const double weight : {1.0, 0.1, 0.5, 1.5}) {
    SurfaceMap best = map;
    start = cpu_seconds();
    const OptimalCorners found =
        optimize_corners(best, {.method = CornerMethod::gradient, .area_weight = weight, .domain = true}, host);
    const Distortion& after = found.distortion;
    if (weight == 1)
      std::printf("map\t%s\t%zu\t%zu\t%zu\t%.4f\t%.4f\t%.4f\t%.4f\t%.2f\t%.3f\t%.2f\t%zu\n", name.c_str(),
                  map.triangles.size(), corners, had, before.angle_mean, before.area_mean, after.angle_mean,
                  after.area_mean, constructed, domain, cpu_seconds() - start,
                  dissertation::count_corner_points(best, host));
    std::printf("weight\t%s\t%g\t%.4f\t%.4f\t%.5f\t%.5f\n", name.c_str(), weight, after.angle_mean, after.area_mean,
                found.energies.front(), found.energies.back());
    std::fflush(stdout);
  }
}

// The dissertation's method on the same surface for each weight of areas, or why it has no map.
void measure_as_printed(const std::string& file, std::size_t corners, const base::Host& host) {
  const std::string name = stem_of(file);
  mesh::Mesh surface = mesh::read_mesh(file, {}, host);
  mesh::orient(surface.positions, surface.triangles, host);
  for (const double weight : {1.0, 0.1, 0.5, 1.5}) {
    const double start = cpu_seconds();
    try {
      const BestConstruction best =
          construct(surface.positions, surface.triangles,
                    {.method = Method::dissertation, .corners = corners, .area_weight = weight}, host);
      const Distortion &before = best.printed->before, &after = best.made.distortion;
      if (weight == 1)
        std::printf("as printed\t%s\t%zu\t%zu\t%zu\t%.4f\t%.4f\t%.4f\t%.4f\t%.2f\n", name.c_str(),
                    best.made.map.triangles.size(), best.printed->corner_points, best.made.certificate.corners,
                    before.angle_mean, before.area_mean, after.angle_mean, after.area_mean, cpu_seconds() - start);
      std::printf("printed weight\t%s\t%g\t%.4f\t%.4f\n", name.c_str(), weight, after.angle_mean, after.area_mean);
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      if (weight == 1)
        std::printf("not printed\t%s\t%.2f\t%s\n", name.c_str(), cpu_seconds() - start, error.what());
      else
        std::printf("printed weight\t%s\t%g\t0\t0\n", name.c_str(), weight);
      if (weight == 1) return;
    }
    std::fflush(stdout);
  }
}

}  // namespace

void measure_tables(std::span<const std::string> files, const base::Host& host) {
  for (const std::string& entry : files) {
    const std::size_t colon = entry.rfind(':');
    try {
      base::require(colon != std::string::npos, "FILE:CORNERS is required");
      const std::string file = entry.substr(0, colon);
      const std::size_t corners = std::strtoul(entry.c_str() + colon + 1, nullptr, 10);
      measure(file, corners, host);
      measure_as_printed(file, corners, host);
    } catch (const base::Error& error) {
      std::printf("failed\t%s\t%s: %s\n", entry.c_str(), error.kind(), error.what());
    }
  }
}

}  // namespace orbicube::bench
