#include "polycube/domain/common_improvement.h"

#include <utility>

#include "base/error.h"
#include "polycube/domain/shape_copies.h"
#include "polycube/unfolded/map_improvement.h"

namespace orbicube::polycube {
namespace {

constexpr double min_gain_of_round = 1e-3;  // of a round, relative to the energy

// In the host's memory, which plain copies are not.
SurfaceMap copy_of(const SurfaceMap& map, const base::Host& host) {
  SurfaceMap result(host.memory);
  result = map;
  return result;
}

// Does change(map) to a copy of each map, and to those of copies of shapes what that did to the original. Keeps them if
// their energies add up to less; returns what was gained, or 0.
template <class Change>
double attempt(CommonMaps& common, std::span<const std::size_t> originals, const CommonImprovementOptions& options,
               const base::Host& host, const Change& change) {
  const double before = common.energies.back();
  CommonMaps next(host.memory);
  for (std::size_t i = 0; i < common.maps.size(); ++i) {
    if (originals[i] != i) {
      next.maps.push_back(map_of_copy(next.maps[originals[i]], common.maps[i].positions, host));
      continue;
    }
    change(next.maps.emplace_back(copy_of(common.maps[i], host)));
  }
  settle(next, options, host);
  const double now = next.energies.back();
  if (!(now < before)) return 0;
  common.energies.push_back(now);
  common.maps = std::move(next.maps);
  common.certificates = std::move(next.certificates);
  common.distortions = std::move(next.distortions);
  return before - now;
}

}  // namespace

void settle(CommonMaps& common, const CommonImprovementOptions& options, const base::Host& host) {
  if (options.proportions) {
    std::vector<SurfaceMap*> pointers;
    for (SurfaceMap& map : common.maps)
      pointers.push_back(&map);
    CommonDomain domain = optimize_domain(pointers, options.domain, host);
    common.energies = std::move(domain.energies);
    common.certificates = std::move(domain.certificates);
    common.distortions = std::move(domain.distortions);
    return;
  }
  double sum = 0;
  common.certificates.clear();
  common.distortions.clear();
  for (SurfaceMap& map : common.maps) {
    common.certificates.push_back(certify(map, host));
    if (!common.certificates.back().valid()) throw base::Error("no-valid-result", common.certificates.back().reason);
    common.distortions.push_back(measure_distortion(map, host));
    sum += energy_of(map, options.domain, host);
  }
  common.energies.assign(1, sum);
}

void improve(CommonMaps& common, std::span<const std::size_t> originals, int rounds,
             const CommonImprovementOptions& options, const base::Host& host) {
  const auto smooth = [&](SurfaceMap& map) {
    Certificate certificate(host.memory);
    improve_map(map, certificate, {.rounds = 1, .domain = false}, host);
  };
  const auto move_corners = [&](SurfaceMap& map) {
    optimize_corners(
        map, {.method = options.corner_search, .area_weight = options.domain.area_weight, .domain = false, .rounds = 1},
        host);
  };
  for (int round = 0; round < rounds; ++round) {
    const double before = common.energies.back();
    double gained = attempt(common, originals, options, host, smooth);
    if (options.corners) gained += attempt(common, originals, options, host, move_corners);
    if (gained < min_gain_of_round * before) break;
  }
}

}  // namespace orbicube::polycube
