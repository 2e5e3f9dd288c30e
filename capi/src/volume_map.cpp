#include "orbicube/volume_map.h"

#include <cstring>
#include <span>

#include "base/version.h"
#include "capi/src/entry.h"
#include "volume_map/untangle/untangle.h"

using namespace orbicube;
using mesh::Tetrahedron;
using mesh::Vector3;

namespace {

obc_volume_map_untangle_problem nothing() {
  obc_volume_map_untangle_problem t{};
  t.struct_size = sizeof t;
  return t;
}

obc_volume_map_untangle_options default_options() {
  const volume_map::UntangleOptions defaults;
  obc_volume_map_untangle_options o{};
  o.struct_size = sizeof o;
  o.steps = defaults.steps;
  o.polish_steps = defaults.polish_steps;
  o.volume_weight = defaults.volume_weight;
  return o;
}

obc_volume_map_untangle_report empty_report() {
  obc_volume_map_untangle_report r{};
  r.struct_size = sizeof r;
  r.first_inverted = UINT32_MAX;
  return r;
}

volume_map::UntangleProblem view_of(const obc_volume_map_untangle_problem& t) {
  static_assert(sizeof(Vector3) == 3 * sizeof(double) && sizeof(Tetrahedron) == 4 * sizeof(uint32_t));
  capi::require(t.positions != nullptr || t.vertex_count == 0, "problem->positions is NULL");
  capi::require(t.tetrahedra != nullptr || t.tetrahedron_count == 0, "problem->tetrahedra is NULL");
  constexpr std::size_t most = UINT32_MAX / 4;
  capi::require(t.vertex_count < most && t.tetrahedron_count < most, "too many vertices or tetrahedra");
  const auto positions = [&](const double* from) {
    return std::span(reinterpret_cast<const Vector3*>(from), from != nullptr ? t.vertex_count : 0);
  };
  const auto coordinates = [&](const auto* from) { return std::span(from, from != nullptr ? 3 * t.vertex_count : 0); };
  return {{reinterpret_cast<const Tetrahedron*>(t.tetrahedra), t.tetrahedron_count},
          positions(t.positions),
          positions(t.rest),
          coordinates(t.fixed),
          coordinates(t.ties)};
}

}  // namespace

obc_status obc_volume_map_untangle_problem_init(obc_volume_map_untangle_problem* problem, size_t struct_size) {
  return capi::init_versioned(problem, struct_size, nothing());
}

obc_status obc_volume_map_untangle_options_init(obc_volume_map_untangle_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_volume_map_untangle_report_init(obc_volume_map_untangle_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, empty_report());
}

obc_status obc_volume_map_untangle(const obc_volume_map_untangle_problem* problem,
                                   const obc_volume_map_untangle_options* options, const obc_host* host, double* result,
                                   obc_volume_map_untangle_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(problem != nullptr, "the argument `problem` is NULL");
    capi::require(result != nullptr, "result is NULL");
    const volume_map::UntangleProblem mesh = view_of(capi::copy_versioned(problem, nothing()));
    const obc_volume_map_untangle_options o = capi::copy_versioned(options, default_options());
    const capi::HostAdapter adapter(host);
    capi::write_versioned(report, empty_report());
    const volume_map::Untangled untangled = volume_map::untangle(
        mesh, {.steps = o.steps, .polish_steps = o.polish_steps, .volume_weight = o.volume_weight}, adapter.host());
    obc_volume_map_untangle_report r = empty_report();
    r.first_inverted = untangled.first_inverted;
    r.inverted_before = untangled.inverted_before;
    r.inverted = untangled.inverted;
    r.steps = untangled.steps;
    r.polish_steps = untangled.polish_steps;
    r.min_determinant = untangled.min_determinant;
    r.max_determinant = untangled.max_determinant;
    r.energy = untangled.energy;
    capi::write_versioned(report, r);
    std::memcpy(result, untangled.positions.data(), untangled.positions.size() * sizeof(Vector3));
    volume_map::require_untangled(untangled, mesh.tetrahedra.size());
  });
}

uint32_t obc_volume_map_version(void) {
  return static_cast<uint32_t>(base::version_major * 10000 + base::version_minor * 100 + base::version_patch);
}
