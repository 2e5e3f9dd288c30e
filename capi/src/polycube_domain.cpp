// The C functions for the best proportions of polycubes.
#include <cstddef>
#include <memory>
#include <utility>

#include "capi/src/polycube_handle.h"
#include "polycube/optimal_domain.h"

using namespace orbicube;

namespace {

static_assert(OBC_POLYCUBE_SURFACE_MEAN == static_cast<int32_t>(polycube::DomainMeasure::surface_mean) &&
              OBC_POLYCUBE_FACE_MEAN == static_cast<int32_t>(polycube::DomainMeasure::face_mean) &&
              OBC_POLYCUBE_HARMONIC == static_cast<int32_t>(polycube::DomainMeasure::harmonic));

obc_polycube_domain_options default_options() {
  const polycube::DomainOptions defaults;
  obc_polycube_domain_options o{};
  o.struct_size = sizeof o;
  o.measure = static_cast<int32_t>(defaults.measure);
  o.area_weight = defaults.area_weight;
  return o;
}

obc_polycube_domain_report to_report(const polycube::OptimalDomain& from) {
  obc_polycube_domain_report report{};
  report.converged = from.converged ? 1 : 0;
  report.energy_before = from.energies.front();
  report.energy = from.energies.back();
  report.evaluations = from.evaluations;
  report.layers = from.layers;
  report.cells = from.cells;
  report.crossing = from.crossing;
  report.angle_mean = from.distortion.angle_mean;
  report.area_mean = from.distortion.area_mean;
  report.angle_weighted_mean = from.distortion.angle_weighted_mean;
  report.area_weighted_mean = from.distortion.area_weighted_mean;
  return report;
}

}  // namespace

obc_status obc_polycube_domain_options_init(obc_polycube_domain_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_polycube_optimize_domain(const obc_polycube* map, const obc_polycube_domain_options* options,
                                        const obc_host* host, obc_polycube_domain_report* report, obc_polycube** out,
                                        obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    capi::require(map != nullptr, "map is NULL");
    const obc_polycube_domain_options o = capi::copy_versioned(options, default_options());
    auto made = std::make_unique<obc_polycube>(host);
    const base::Host& on = made->adapter.host();
    polycube::SurfaceMap& copy = made->map;
    copy = map->map;
    polycube::DomainOptions domain;
    domain.measure = static_cast<polycube::DomainMeasure>(o.measure);
    domain.area_weight = o.area_weight;
    polycube::OptimalDomain found = polycube::optimise_domain(copy, domain, on);
    made->corners = found.certificate.corners;
    made->patches = found.certificate.patches;
    made->construction = map->construction;
    capi::write_versioned(report, to_report(found));
    made->energies = std::move(found.energies);
    *out = made.release();
  });
}

size_t obc_polycube_energy_count(const obc_polycube* map) {
  return map != nullptr ? map->energies.size() : 0;
}

obc_status obc_polycube_copy_energies(const obc_polycube* map, double* energies, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(map != nullptr, "map is NULL");
    capi::copy(map->energies, energies);
  });
}
