#include "sphere_map/sphere_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/topology.h"
#include "sphere_map/decimation.h"
#include "sphere_map/measure.h"
#include "sphere_map/method.h"
#include "sphere_map/normalise.h"
#include "sphere_map/refinement.h"
#include "sphere_map/seed.h"

namespace orbicube::sphere_map {
namespace {

double total_area(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  double twice = 0;
  for (const Triangle& t : triangles) {
    twice += (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm();
  }
  return 0.5 * twice;
}

// A kernel can become too small for double precision where the surface has triangles without area. Another order of
// decimation and a stronger barrier get past that, or else triangles that count as having some area, in the end all
// alike: maps of that kind exist for every surface (Tutte 1963).
Array<Vector3> map_with_retries(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                double surface_area, const Schedule& schedule, std::uint64_t seed,
                                const base::Host& host) {
  const double mean_area = surface_area / static_cast<double>(triangles.size());
  const std::array least_areas = {0.0, 0.0, 1e-2, 1.0, 1e3};  // times the mean area
  const base::Team team(host);
  for (std::size_t attempt = 0;; ++attempt) {
    try {
      Decimation decimation = decimate(positions, VertexRings(positions.size(), triangles, host), seed, host, team);
      return refine(decimation, positions, schedule.with_stronger_barrier(attempt), least_areas[attempt] * mean_area,
                    host, team);
    } catch (const base::Error& e) {
      if (e.status() != base::Status::no_valid_result || attempt + 1 == least_areas.size()) throw;
      host.log(std::string("trying again: ") + e.what());
    }
    seed += 0x1000;
  }
}

}  // namespace

Array<Vector3> compute(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Options& options,
                       const base::Host& host) {
  const Schedule schedule = schedule_of(options);
  const mesh::Topology facts = mesh::topology(positions, triangles, host);
  mesh::require_closed_genus_zero(facts);
  const Array<Vector3> unit = normalised(positions, host.memory);

  // Inward surfaces are mapped as they look from outside.
  Array<Triangle> outward(triangles.begin(), triangles.end(), host.memory);
  if (facts.volume < 0) {
    for (Triangle& t : outward)
      std::swap(t[1], t[2]);
  }

  Array<Vector3> directions =
      options.method == Method::seed
          ? seed::compute(
                unit, outward,
                {.angle_weight = options.angle_weight, .area_weight = options.area_weight, .seed = options.seed}, host)
          : map_with_retries(unit, outward, total_area(unit, outward), schedule, options.seed, host);
  for (std::size_t v = 0; v < directions.size(); ++v) {
    if (directions[v] == Vector3::Zero()) {  // in no triangle
      directions[v] = unit[v].norm() > 0 ? unit[v].normalized() : Vector3::UnitZ();
    }
  }
  std::size_t bad = 0;
  constexpr std::size_t piece = 65536;
  for (std::size_t begin = 0; begin < outward.size(); begin += piece) {
    host.report("exact check", begin, outward.size());
    bad += count_not_positive(std::span(outward).subspan(begin, std::min(piece, outward.size() - begin)), directions);
  }
  if (bad > 0) {
    throw base::Error("no-valid-result", std::to_string(bad) + " triangles are not positive by exact predicates");
  }
  return directions;
}

}  // namespace orbicube::sphere_map
