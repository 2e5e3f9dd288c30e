#include "hexmesh/strategies/hex_draft.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/counted.h"
#include "base/infinity.h"
#include "hexmesh/certificate/hex_embedding.h"
#include "hexmesh/certificate/surface_distance.h"
#include "hexmesh/quality/gap_opening.h"
#include "hexmesh/quality/hex_reach.h"
#include "hexmesh/quality/hex_search.h"
#include "hexmesh/quality/hex_smoothing.h"
#include "mesh/topology/place_text.h"

namespace orbicube::hexmesh {
namespace {

// excess() of a mesh whose vertices the search, which moves them by parts of a cell, does not bring near. The search
// takes half of the time.
constexpr double out_of_reach = 3;

}  // namespace

HexMesh copy_of(const HexMesh& mesh, const base::Host& host) {
  HexMesh result(host.memory);
  result = mesh;
  return result;
}

TargetSurface::TargetSurface(const PolycubeSurface& solid)
    : positions(solid.fine_triangles.empty() ? solid.map.positions : solid.fine_positions),
      triangles(solid.fine_triangles.empty() ? solid.map.triangles : solid.fine_triangles) {
  Vector3 low = Vector3::Constant(base::infinity), high = -low;
  for (const mesh::Triangle& t : triangles) {
    for (const Index v : t) {
      low = low.cwiseMin(positions[v]);
      high = high.cwiseMax(positions[v]);
    }
  }
  const Vector3 at = near_origin(low, high);
  for (const mesh::Triangle& t : triangles)
    volume += (positions[t[0]] - at).dot((positions[t[1]] - at).cross(positions[t[2]] - at)) / 6;
  diagonal = (high - low).norm();
  diagonal_ratio = solid.diagonal_ratio;
  volume_ratio = solid.volume_ratio;
}

double excess(const HexResult& result, double distance) {
  if (distance == 0) return 1;
  return std::max(1.0, std::max(result.distance, result.volume_error) / distance);
}

bool better(const HexResult& x, const HexResult& y, double distance) {
  const double of_x = excess(x, distance), of_y = excess(y, distance);
  return of_x != of_y ? of_x < of_y : x.quality.min_scaled_jacobian > y.quality.min_scaled_jacobian;
}

std::string what_is_wrong(const HexQuality& q) {
  if (q.positive() && q.intersections > 0)
    return "the boundary of the hexahedra meets itself: " +
           base::counted(q.intersections, "pair of quads intersects", "pairs of quads intersect") + ", the first at " +
           mesh::place_text(q.first_intersection);
  if (q.positive() && q.misplaced_parts > 0)
    return "parts of the boundary of the hexahedra lie on the wrong side of others: " +
           std::to_string(q.misplaced_parts) + ", the first at " + mesh::place_text(q.first_intersection);
  return base::counted(q.inverted, "hexahedron has", "hexahedra have") + " a corner that is not positive, " +
         std::to_string(q.uncertain) + " more are not certainly positive; the first is " + std::to_string(q.first_bad);
}

void log_made(const HexResult& made, const HexManner& manner, const base::Host& host) {
  std::string how = made.grid_based ? "grid in space" : "polycube";
  if (!made.grid_based && made.follows_sharp_edges) how += " with sharp edges";
  if (!made.grid_based) how += made.padded ? ", padded" : ", not padded";
  if (manner.hold) how += ", fixed";
  if (manner.insist) how += ", worst corners first";
  std::string outcome = what_is_wrong(made.quality);
  if (made.quality.valid())
    outcome = "scaled Jacobians at least " + std::to_string(made.quality.min_scaled_jacobian) + ", " +
              std::to_string(made.distance) + " % away";
  host.log(std::to_string(made.mesh.hexahedra.size()) + " hexahedra, " + how + ": " + outcome);
}

HexDraft::HexDraft(HexMesh mesh, std::size_t padding, double scale, const PolycubeSurface& surface,
                   const TargetSurface& shape, const HexTarget& aim, const base::Host& host)
    : shape_(shape),
      aim_(aim),
      host_(host),
      mesh_(std::move(mesh)),
      padding_(padding),
      scale_(scale),
      target_(surface.map, surface.fine_positions, surface.fine_triangles, scale, host),
      boundary_(mesh_, target_, host) {}

HexResult HexDraft::finish(const HexManner& manner) {
  const HexSmoothingOptions smoothing = {.rounds = aim_.rounds,
                                         .lift = manner.lift,
                                         .padding = padding_,
                                         .distance = manner.hold ? held_distance(manner) : 0,
                                         .max_weight = manner.insist ? 1000.0 : 60.0};
  if (manner.apart) boundary_.keep_apart(mesh_.positions, mesh_.quads);
  {
    const base::Stage stage(host_, 0.6);
    if (!smooth_hexahedra(mesh_, boundary_, target_, smoothing, host_)) {
      // The search untangles the few that stay inverted.
      search_hexahedra(mesh_, boundary_, {}, host_);
      smooth_hexahedra(mesh_, boundary_, target_, smoothing, host_);
    }
  }
  if (HexResult far = measured(mesh_, 0); excess(far, aim_.distance) > out_of_reach && far.quality.valid()) return far;
  HexResult result = searched(manner, false);
  if (manner.hold && result.quality.valid() && excess(result, aim_.distance) > 1) {
    // The search may have gone too far.
    HexResult nearer = searched(manner, true);
    if (nearer.quality.valid() && !better(result, nearer, aim_.distance)) result = std::move(nearer);
  }
  return result;
}

void HexDraft::part_walls(HexResult& result) const {
  if (!result.quality.positive() || result.quality.intersections == 0) return;
  HexResult apart(host_.memory);
  apart = result;
  if (!open_gaps(apart.mesh, host_)) return;
  measure(apart);
  if (apart.quality.valid()) result = std::move(apart);
}

HexResult HexDraft::searched(const HexManner& manner, bool all) const {
  constexpr double reach = 0.2;  // of the distance: how far the search may move what is fixed
  HexSearchOptions options = {.reach = reach * manner.held_fraction * distance(), .all = all};
  HexMesh mesh = copy_of(mesh_, host_);
  std::size_t off_surface = search_hexahedra(mesh, boundary_, options, host_);
  HexResult result = measured(mesh, off_surface);
  if (!result.quality.valid()) return result;
  // Distances are measured at samples. What is twice as far as allowed is out of reach.
  const double safe = 0.97 * aim_.distance, reachable = 2 * aim_.distance;
  bool reached = false;
  if (excess(result, safe) > 1 && excess(result, reachable) <= 1) {
    HexMesh nearer = copy_of(mesh, host_);
    reach_surface(nearer, boundary_, target_, distance(), host_);
    HexResult now = measured(nearer, off_surface);
    if (now.quality.valid() && excess(now, safe) < excess(result, safe)) {
      mesh = std::move(nearer);
      result = std::move(now);
      reached = true;
    }
  }
  const auto raised = [&] {
    HexMesh better = copy_of(mesh, host_);
    off_surface = raise_mean(better, boundary_, options, host_);
    return measured(better, off_surface);
  };
  HexResult now = raised();
  // What slides may lose a tip or a ridge; the distance comes first.
  if (!now.quality.valid() || excess(now, safe) > excess(result, safe)) {
    options.mean_reach = 0;
    now = raised();
  }
  if (!now.quality.valid()) now = std::move(result);  // its boundary met itself for the sake of the mean
  now.hardly_near = reached || excess(now, safe) > 1;
  return now;
}

HexResult HexDraft::measured(const HexMesh& mesh, std::size_t off_surface) const {
  HexResult result(host_.memory);
  result.padded = padding_ > 0;
  result.off_surface = off_surface;
  result.mesh = mesh;
  for (Vector3& p : result.mesh.positions)
    p /= scale_;
  measure(result);
  return result;
}

void HexDraft::measure(HexResult& result) const {
  constexpr double spacing = 0.0025;  // of the diagonal
  const Array<mesh::Triangle> outer = halves_of(result.mesh.quads, host_.memory);
  result.quality = measure_hexahedra(result.mesh.positions, result.mesh.hexahedra, host_);
  measure_embedding(result.mesh.positions, result.mesh.quads, result.quality, host_);
  result.distance = 100 / (shape_.diagonal_ratio * shape_.diagonal) *
                    surface_distance(result.mesh.positions, outer, shape_.positions, shape_.triangles,
                                     spacing * shape_.diagonal, host_);
  result.volume_error = 100 / shape_.volume_ratio * std::abs(result.quality.volume / shape_.volume - 1);
}

}  // namespace orbicube::hexmesh
