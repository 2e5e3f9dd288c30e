#include "polycube/unfolded/map_improvement.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "polycube/domain/optimal_domain.h"
#include "polycube/unfolded/polycube_edges.h"
#include "polycube/unfolded/unfolded_smoothing.h"

namespace orbicube::polycube {
namespace {

// Each takes time in proportion to the triangles.
int max_steps(std::size_t triangles) {
  constexpr double work = 4e6, least = 20, most = 500;
  return static_cast<int>(std::clamp(work / static_cast<double>(std::max<std::size_t>(triangles, 1)), least, most));
}

// What a round has to gain, of the distortion above an isometry, to be followed by another: more where rounds take
// long. On 70,000 triangles the rounds below 2.3 % took a third of the time and gained 0.2 % of the distortion
// together.
double min_gain(std::size_t triangles) {
  return 0.005 * std::max(1.0, static_cast<double>(triangles) / 15'000);
}

// 2 for an isometry.
double score_of(const Distortion& d, bool domain) {
  const double over_triangles = d.angle_mean + d.area_mean;
  return domain ? over_triangles : 0.5 * (over_triangles + d.angle_weighted_mean + d.area_weighted_mean);
}

void hold(std::span<const Vector3> places, UnfoldedMap& map) {
  for (UnfoldedCorner& corner : map.corners)
    corner.held = std::find(places.begin(), places.end(), corner.place) != places.end();
}

}  // namespace

Distortion improve_map(SurfaceMap& map, Certificate& certificate, const ImprovementOptions& options,
                       const base::Host& host) {
  const double little = min_gain(map.triangles.size());
  int steps = options.newton_steps > 0 ? options.newton_steps : max_steps(map.triangles.size());
  const auto score = [&](const Distortion& d) { return score_of(d, options.domain); };
  Distortion now = measure_distortion(map, host);
  for (int round = 0; round < options.rounds && steps > 0; ++round) {
    const double before = score(now);
    try {
      UnfoldedMap unfolded(map, host);
      hold(options.held_corners, unfolded);
      steps -= smooth_unfolded(unfolded, {.newton_steps = steps}, host);
      SurfaceMap trial = fold(unfolded, host);
      Certificate proof = certify(trial, host);
      if (!proof.valid()) throw base::Error("no-valid-result", proof.reason);
      const Distortion after = options.domain
                                   ? optimize_domain(trial, {.measure = DomainMeasure::face_mean}, host).distortion
                                   : measure_distortion(trial, host);
      host.log("smoothed: angle " + std::to_string(after.angle_mean) + ", area " + std::to_string(after.area_mean));
      if (!(score(after) < before)) break;
      map = std::move(trial);
      certificate = std::move(proof);
      now = after;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      host.log(error.what());
      break;
    }
    if (score(now) - 2 > (1 - little) * (before - 2)) break;
  }
  return now;
}

}  // namespace orbicube::polycube
