#include "volume_map/hex_draft.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "volume_map/hex_reach.h"
#include "volume_map/hex_search.h"
#include "volume_map/hex_smoothing.h"
#include "volume_map/surface_distance.h"

namespace orbicube::volume_map {
namespace {

// In the host's memory, which a plain copy would not be.
HexMesh copy_of(const HexMesh& mesh, const base::Host& host) {
  HexMesh result(host.memory);
  result = mesh;
  return result;
}

}  // namespace

WantedSurface::WantedSurface(const PolycubeSurface& solid)
    : positions(solid.fine_triangles.empty() ? solid.map.positions : solid.fine_positions),
      triangles(solid.fine_triangles.empty() ? solid.map.triangles : solid.fine_triangles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3 low = Vector3::Constant(infinity), high = -low;
  for (const mesh::Triangle& t : triangles) {
    for (const Index v : t) {
      low = low.cwiseMin(positions[v]);
      high = high.cwiseMax(positions[v]);
    }
    volume += positions[t[0]].dot(positions[t[1]].cross(positions[t[2]])) / 6;
  }
  diagonal = (high - low).norm();
}

double excess(const HexResult& result, double distance) {
  if (distance == 0) return 1;
  return std::max(1.0, std::max(result.distance, result.volume_error) / distance);
}

bool better(const HexResult& x, const HexResult& y, double distance) {
  const double of_x = excess(x, distance), of_y = excess(y, distance);
  return of_x != of_y ? of_x < of_y : x.quality.least_scaled_jacobian > y.quality.least_scaled_jacobian;
}

std::string what_is_wrong(const HexQuality& q) {
  return std::to_string(q.inverted) + " hexahedra have a corner that is not positive, " + std::to_string(q.uncertain) +
         " more are not certainly positive; the first is " + std::to_string(q.first_bad);
}

HexDraft::HexDraft(HexMesh mesh, std::size_t padding, double scale, const PolycubeSurface& surface,
                   const WantedSurface& wanted, const HexAim& aim, const base::Host& host)
    : wanted_(wanted),
      aim_(aim),
      host_(host),
      mesh_(std::move(mesh)),
      padding_(padding),
      scale_(scale),
      target_(surface.map, surface.fine_positions, surface.fine_triangles, scale, host),
      boundary_(mesh_, target_, host) {}

HexResult HexDraft::finish(const HexManner& manner) {
  constexpr double held = 0.65;  // what is farther, of the distance that is allowed
  const HexSmoothingOptions smoothing = {.rounds = aim_.rounds,
                                         .lift = manner.lift,
                                         .padding = padding_,
                                         .distance = manner.hold ? held * distance() : 0,
                                         .most_weight = manner.insist ? 1000.0 : 60.0};
  if (!smooth_hexahedra(mesh_, boundary_, target_, smoothing, host_)) {
    // A few that stay inverted are turned right by the search.
    search_hexahedra(mesh_, boundary_, {}, host_);
    smooth_hexahedra(mesh_, boundary_, target_, smoothing, host_);
  }
  HexResult result = searched(false);
  if (!manner.hold || !result.quality.valid() || excess(result, aim_.distance) <= 1) return result;
  // The search may have gone too far.
  HexResult nearer = searched(true);
  return nearer.quality.valid() && !better(result, nearer, aim_.distance) ? std::move(nearer) : std::move(result);
}

HexResult HexDraft::searched(bool all) const {
  constexpr double reach = 0.2;  // of the distance: how far the search may move what is held
  HexSearchOptions options = {.reach = reach * distance(), .all = all};
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
  if (excess(now, safe) > excess(result, safe)) {
    options.mean_reach = 0;
    now = raised();
  }
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
  result.distance = 100 / wanted_.diagonal *
                    surface_distance(result.mesh.positions, outer, wanted_.positions, wanted_.triangles,
                                     spacing * wanted_.diagonal, host_);
  result.volume_error = 100 * std::abs(result.quality.volume / wanted_.volume - 1);
}

}  // namespace orbicube::volume_map
