// The C functions for the best positions of a polycube's corners.
#include <cstddef>

#include "capi/src/polycube_handle.h"
#include "polycube/corners/optimal_corners.h"

using namespace orbicube;

namespace {

static_assert(OBC_POLYCUBE_TRUST_REGION == static_cast<int32_t>(polycube::CornerMethod::trust_region) &&
              OBC_POLYCUBE_GRADIENT == static_cast<int32_t>(polycube::CornerMethod::gradient));

obc_polycube_corner_options default_corner_options() {
  const polycube::CornerOptions defaults;
  obc_polycube_corner_options o{};
  o.struct_size = sizeof o;
  o.method = static_cast<int32_t>(defaults.method);
  o.area_weight = defaults.area_weight;
  o.domain = defaults.domain ? 1 : 0;
  o.rounds = defaults.rounds;
  return o;
}

obc_polycube_corner_report to_report(const polycube::OptimalCorners& from) {
  auto report = capi::report_of_optimum<obc_polycube_corner_report>(from);
  report.map_evaluations = from.map_evaluations;
  report.moves = from.moves;
  report.movable = from.movable;
  return report;
}

}  // namespace

obc_status obc_polycube_corner_options_init(obc_polycube_corner_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_corner_options());
}

obc_status obc_polycube_optimize_corners(const obc_polycube* map, const obc_polycube_corner_options* options,
                                         const obc_host* host, obc_polycube_corner_report* report, obc_polycube** out,
                                         obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    capi::require(map != nullptr, "map is NULL");
    const obc_polycube_corner_options o = capi::copy_versioned(options, default_corner_options());
    capi::require(o.domain == 0 || o.domain == 1, "domain is neither 0 nor 1");
    capi::require(o.rounds >= 1, "rounds must be positive");
    polycube::CornerOptions corners;
    corners.method = static_cast<polycube::CornerMethod>(o.method);
    corners.area_weight = o.area_weight;
    corners.domain = o.domain == 1;
    corners.rounds = o.rounds;
    capi::changed_copy(
        *map, host, out,
        [&](polycube::SurfaceMap& copy, const base::Host& on) { return polycube::optimize_corners(copy, corners, on); },
        [&](const polycube::OptimalCorners& found) { capi::write_versioned(report, to_report(found)); });
  });
}
