// What a handle of a polycube map holds, for the files of its C functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "capi/src/entry.h"
#include "capi/src/surface_view.h"
#include "orbicube/polycube.h"
#include "polycube/surface/distortion.h"
#include "polycube/surface/surface_map.h"

struct obc_polycube {
  explicit obc_polycube(const obc_host* host)
      : adapter(host), map(adapter.host().memory), energies(adapter.host().memory) {}
  orbicube::capi::HostAdapter adapter;
  orbicube::polycube::SurfaceMap map;
  std::size_t corners = 0;
  std::size_t patches = 0;
  std::int32_t construction = -1;
  orbicube::base::Array<double> energies;  // of the optimization that it comes from
};

namespace orbicube::capi {

template <class Report>
void set_distortion(const polycube::Distortion& from, Report& report) {
  report.angle_mean = from.angle_mean;
  report.area_mean = from.area_mean;
  report.angle_weighted_mean = from.angle_weighted_mean;
  report.area_weighted_mean = from.area_weighted_mean;
}

// What the two optimizations report alike.
template <class Report, class Found>
Report report_of_optimum(const Found& from) {
  Report report{};
  report.converged = from.converged ? 1 : 0;
  report.energy_before = from.energies.front();
  report.energy = from.energies.back();
  report.evaluations = from.evaluations;
  set_distortion(from.distortion, report);
  return report;
}

// A handle of its own for the map that `change` (of a map and the host) makes of a copy; `tell` gets what that found
// before the handle is given away.
template <class Change, class Tell>
void changed_copy(const obc_polycube& map, const obc_host* host, obc_polycube** out, const Change& change,
                  const Tell& tell) {
  auto made = std::make_unique<obc_polycube>(host);
  made->map = map.map;
  const auto found = change(made->map, made->adapter.host());
  made->corners = found.certificate.corners;
  made->patches = found.certificate.patch_count;
  made->construction = map.construction;
  if constexpr (requires { found.energies; }) made->energies = found.energies;
  tell(found);
  *out = made.release();
}

}  // namespace orbicube::capi
