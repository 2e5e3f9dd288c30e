#include "polycube/map_improvement.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "polycube/optimal_domain.h"
#include "polycube/polycube_edges.h"
#include "polycube/unfolded_smoothing.h"

namespace orbicube::polycube {
namespace {

// Each takes time in proportion to the 1.5th power of the triangles, as the factors of its systems do.
int most_steps(std::size_t triangles) {
  constexpr double work = 2e9, least = 30, most = 500;
  const auto n = static_cast<double>(std::max<std::size_t>(triangles, 1));
  return static_cast<int>(std::clamp(work / (n * std::sqrt(n)), least, most));
}

double sum_of(const Distortion& d) {
  return d.angle_mean + d.area_mean;
}

}  // namespace

Distortion improve_map(SurfaceMap& map, Certificate& certificate, const ImprovementOptions& options,
                       const base::Host& host) {
  constexpr double little = 0.005;  // of what there is above an isometry
  int steps = options.newton_steps > 0 ? options.newton_steps : most_steps(map.triangles.size());
  Distortion now = measure_distortion(map, host);
  for (int round = 0; round < options.rounds && steps > 0; ++round) {
    const double before = sum_of(now);
    try {
      UnfoldedMap unfolded(map, host);
      steps -= smooth_unfolded(unfolded, {.newton_steps = steps}, host);
      SurfaceMap trial = fold(unfolded, host);
      Certificate proof = certify(trial, host);
      if (!proof.valid()) throw base::Error("no-valid-result", proof.reason);
      const OptimalDomain domain = optimise_domain(trial, {.measure = DomainMeasure::face_mean}, host);
      host.log("smoothed: angle " + std::to_string(domain.distortion.angle_mean) + ", area " +
               std::to_string(domain.distortion.area_mean));
      if (!(sum_of(domain.distortion) < before)) break;
      map = std::move(trial);
      certificate = std::move(proof);
      now = domain.distortion;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      host.log(error.what());
      break;
    }
    if (sum_of(now) - 2 > (1 - little) * (before - 2)) break;
  }
  return now;
}

}  // namespace orbicube::polycube
