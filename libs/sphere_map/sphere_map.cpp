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
#include "sphere_map/partial.h"
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
                                const base::Host& host, Partial* partial) {
  const double mean_area = surface_area / static_cast<double>(triangles.size());
  const std::array least_areas = {0.0, 0.0, 1e-2, 1.0, 1e3};  // times the mean area
  const base::Team team(host);
  for (std::size_t attempt = 0;; ++attempt) {
    try {
      Decimation decimation = decimate(positions, VertexRings(positions.size(), triangles, host), seed, host, team);
      return refine(decimation, positions, schedule.with_stronger_barrier(attempt), least_areas[attempt] * mean_area,
                    host, team, partial);
    } catch (const base::Error& e) {
      if (e.status() != base::Status::no_valid_result || attempt + 1 == least_areas.size()) throw;
      host.log(std::string("trying again: ") + e.what());
    }
    seed += 0x1000;
  }
}

// Vertices in no triangle, which have no direction yet.
void place_unused(std::span<const Vector3> positions, std::span<Vector3> directions) {
  for (std::size_t v = 0; v < directions.size(); ++v) {
    if (directions[v] == Vector3::Zero())
      directions[v] = positions[v].norm() > 0 ? positions[v].normalized() : Vector3::UnitZ();
  }
}

void check_exactly(std::span<const Triangle> triangles, std::span<const Vector3> directions, const base::Host& host) {
  std::size_t bad = 0;
  constexpr std::size_t piece = 65536;
  for (std::size_t begin = 0; begin < triangles.size(); begin += piece) {
    host.report("exact check", begin, triangles.size());
    bad += count_not_positive(triangles.subspan(begin, std::min(piece, triangles.size() - begin)), directions);
  }
  if (bad > 0) {
    throw base::Error("no-valid-result", std::to_string(bad) + " triangles are not positive by exact predicates");
  }
}

}  // namespace

Array<Vector3> compute(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Options& options,
                       const base::Host& host, Partial* partial) {
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

  Array<Vector3> directions(host.memory);
  try {
    directions = options.method == Method::seed ? seed::compute(unit, outward,
                                                                {.angle_weight = options.angle_weight,
                                                                 .area_weight = options.area_weight,
                                                                 .seed = options.seed,
                                                                 .trace = options.trace},
                                                                host, partial)
                                                : map_with_retries(unit, outward, total_area(unit, outward), schedule,
                                                                   options.seed, host, partial);
    check_exactly(outward, directions, host);
  } catch (const base::Error&) {
    keep_partial({}, directions, partial);
    if (partial != nullptr) place_unused(unit, partial->directions);
    throw;
  }
  place_unused(unit, directions);
  return directions;
}

}  // namespace orbicube::sphere_map
