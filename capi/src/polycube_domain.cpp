// The C functions for the best proportions of polycubes.
#include <cstddef>

#include "capi/src/polycube_handle.h"
#include "polycube/domain/optimal_domain.h"

using namespace orbicube;

namespace {

static_assert(OBC_POLYCUBE_SURFACE_MEAN == static_cast<int32_t>(polycube::DomainMeasure::surface_mean) &&
              OBC_POLYCUBE_FACE_MEAN == static_cast<int32_t>(polycube::DomainMeasure::face_mean) &&
              OBC_POLYCUBE_HARMONIC == static_cast<int32_t>(polycube::DomainMeasure::harmonic));

obc_polycube_domain_options default_domain_options() {
  const polycube::DomainOptions defaults;
  obc_polycube_domain_options o{};
  o.struct_size = sizeof o;
  o.measure = static_cast<int32_t>(defaults.measure);
  o.area_weight = defaults.area_weight;
  return o;
}

obc_polycube_domain_report to_report(const polycube::OptimalDomain& from) {
  auto report = capi::report_of_optimum<obc_polycube_domain_report>(from);
  report.layers = from.layers;
  report.cells = from.cells;
  report.crossing = from.crossing;
  return report;
}

}  // namespace

obc_status obc_polycube_domain_options_init(obc_polycube_domain_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_domain_options());
}

obc_status obc_polycube_optimize_domain(const obc_polycube* map, const obc_polycube_domain_options* options,
                                        const obc_host* host, obc_polycube_domain_report* report, obc_polycube** out,
                                        obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    capi::require(map != nullptr, "map is NULL");
    const obc_polycube_domain_options o = capi::copy_versioned(options, default_domain_options());
    polycube::DomainOptions domain;
    domain.measure = static_cast<polycube::DomainMeasure>(o.measure);
    domain.area_weight = o.area_weight;
    capi::changed_copy(
        *map, host, out,
        [&](polycube::SurfaceMap& copy, const base::Host& on) { return polycube::optimize_domain(copy, domain, on); },
        [&](const polycube::OptimalDomain& found) { capi::write_versioned(report, to_report(found)); });
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
