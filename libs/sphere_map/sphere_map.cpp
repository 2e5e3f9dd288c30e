#include "sphere_map/sphere_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/topology/degenerate_triangles.h"
#include "mesh/topology/topology.h"
#include "sphere_map/dissertation/method.h"
#include "sphere_map/hierarchy/decimation.h"
#include "sphere_map/hierarchy/normalize.h"
#include "sphere_map/hierarchy/partial.h"
#include "sphere_map/hierarchy/refinement.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/optimization/method.h"

namespace orbicube::sphere_map {
namespace {

double total_area(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  double twice = 0;
  for (const Triangle& t : triangles) {
    twice += (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm();
  }
  return 0.5 * twice;
}

// `values`, one a vertex by its number, in the order of the vertices.
void put_back(std::span<const Index> number, Array<Vector3>& values) {
  Array<Vector3> result(values.size(), values.get_allocator());
  for (std::size_t v = 0; v < number.size(); ++v)
    result[v] = values[number[v]];
  values = std::move(result);
}

// Refines by numbers that depend on the hierarchy alone.
Array<Vector3> refine_renumbered(Decimation& decimation, std::span<const Vector3> positions, const Schedule& schedule,
                                 const RestTriangles& rest, const base::Host& host, const base::ThreadPool& pool,
                                 Partial* partial) {
  const Array<Index> number = renumber(decimation, host);
  Array<Vector3> renumbered(positions.size(), host.memory);
  for (std::size_t v = 0; v < number.size(); ++v)
    renumbered[number[v]] = positions[v];
  Partial reached(host.memory);
  try {
    Array<Vector3> directions =
        refine(decimation, renumbered, schedule, rest, host, pool, partial ? &reached : nullptr);
    put_back(number, directions);
    return directions;
  } catch (const base::Error&) {
    if (reached.placed > 0 && reached.placed >= partial->placed) {
      put_back(number, reached.directions);
      std::swap(*partial, reached);
    }
    throw;
  }
}

// A kernel can become too small for double precision where the surface has triangles without area. Another order of
// decimation and a stronger barrier get past that, or else triangles that count as having some area, in the end all
// alike: maps of that kind exist for every surface (Tutte 1963).
Array<Vector3> map_with_retries(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                const RestTriangles& rest, double surface_area, const Schedule& schedule,
                                std::uint64_t seed, const base::Host& host, Partial* partial) {
  const double mean_area = surface_area / static_cast<double>(triangles.size());
  const std::array min_areas = {0.0, 0.0, 1e-2, 1.0, 1e3};  // times the mean area
  const base::ThreadPool pool(host);
  for (std::size_t attempt = 0;; ++attempt) {
    const base::Stage stage(host, 0.9);
    try {
      Decimation decimation = [&] {
        const base::Stage first(host, 0.1);
        return decimate(positions, VertexRings(positions.size(), triangles, host), seed, host, pool);
      }();
      RestTriangles attempted = rest;
      attempted.min_area = min_areas[attempt] * mean_area;
      attempted.unit_area = surface_area;
      return refine_renumbered(decimation, positions, schedule.with_stronger_barrier(attempt), attempted, host, pool,
                               partial);
    } catch (const base::Error& e) {
      if (e.status() != base::Status::no_valid_result || attempt + 1 == min_areas.size()) throw;
      host.log(std::string("trying again: ") + e.what());
    }
    seed += 0x1000;
  }
}

// Of a surface, `unit` of diagonal 1.
RestTriangles rest_triangles(std::span<const Vector3> positions, std::span<const Vector3> unit,
                             std::span<const Triangle> triangles) {
  RestTriangles rest;
  const Placing placing = placing_of(positions, triangles);
  if (!(placing.half_size > 0)) {
    rest.release_degenerate = true;
    return rest;
  }
  // A height that is lost in rounding before the surface is scaled to the diagonal 1.
  double farthest = 0;
  for (const Triangle& t : triangles) {
    for (const Index v : t)
      farthest = std::max(farthest, positions[v].cwiseAbs().maxCoeff());
  }
  rest.min_height = mesh::degenerate_height_roundings * mesh::rounding_unit(positions, triangles) *
                    (farthest / placing.half_size / placing.diagonal);
  rest.sliver_area = sliver_area_share * total_area(unit, triangles) / static_cast<double>(triangles.size());
  rest.release_degenerate = std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    const Vector3 pq = unit[t[1]] - unit[t[0]], pr = unit[t[2]] - unit[t[0]];
    const double longest_square = std::max({pq.squaredNorm(), pr.squaredNorm(), (pr - pq).squaredNorm()});
    return is_released(rest, pq.cross(pr).norm(), longest_square);
  });
  return rest;
}

// Vertices in no triangle, which have no direction yet.
void place_unused(const Placing& placing, std::span<const Vector3> positions, std::span<Vector3> directions) {
  for (std::size_t v = 0; v < directions.size(); ++v) {
    if (directions[v] == Vector3::Zero()) directions[v] = placing.direction(positions[v]);
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
    throw base::Error("no-valid-result",
                      base::counted(bad, "triangle is", "triangles are") + " not positive by exact predicates");
  }
}

}  // namespace

void require_weights(double angle_weight, double area_weight) {
  // Beyond these, squares of gradients leave the range of doubles, and the map stays as it begins.
  constexpr double least = 1e-100, most = 1e100;
  const bool usable = angle_weight >= 0 && area_weight >= 0 && angle_weight <= most && area_weight <= most &&
                      std::max(angle_weight, area_weight) >= least;
  if (!usable) {
    throw base::Error("invalid-argument",
                      "angle_weight and area_weight must be from 0 to 1e100, and one of them at least 1e-100");
  }
}

Array<Vector3> compute(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Options& options,
                       const base::Host& host, Partial* partial) {
  const Schedule schedule = schedule_of(options);
  const mesh::Topology facts = mesh::topology(positions, triangles, host);
  mesh::require_closed_genus_zero(facts);
  const Array<Vector3> unit = normalized(positions, triangles, host.memory);
  const RestTriangles rest = rest_triangles(positions, unit, triangles);

  // Inward surfaces are mapped as they look from outside.
  Array<Triangle> outward(triangles.begin(), triangles.end(), host.memory);
  if (facts.volume < 0) {
    for (Triangle& t : outward)
      std::swap(t[1], t[2]);
  }

  Array<Vector3> directions(host.memory);
  try {
    directions =
        options.method == Method::dissertation
            ? dissertation::compute(unit, outward,
                                    {.angle_weight = options.angle_weight,
                                     .area_weight = options.area_weight,
                                     .limits = options.limits,
                                     .seed = options.seed,
                                     .rest = rest,
                                     .trace = options.trace},
                                    host, partial)
            : map_with_retries(unit, outward, rest, total_area(unit, outward), schedule, options.seed, host, partial);
    check_exactly(outward, directions, host);
  } catch (const base::Error&) {
    keep_partial({}, directions, partial);
    if (partial != nullptr) place_unused(placing_of(positions, triangles), positions, partial->directions);
    throw;
  }
  place_unused(placing_of(positions, triangles), positions, directions);
  return directions;
}

}  // namespace orbicube::sphere_map
