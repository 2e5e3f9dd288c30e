#include "orbicube/sphere_map.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <utility>

#include "base/version.h"
#include "capi/src/entry.h"
#include "capi/src/sphere_map_surface.h"
#include "mesh/topology/surface_check.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sampling/rounding.h"
#include "sphere_map/sphere_map.h"

using namespace orbicube;
using capi::Surface;
using sphere_map::Triangle;
using sphere_map::Vector3;

namespace {

obc_sphere_map_options default_options() {
  obc_sphere_map_options o{};
  o.struct_size = sizeof o;
  o.method = OBC_SPHERE_MAP_BALANCED;
  o.angle_weight = 0.1;
  o.area_weight = 1;
  const sphere_map::AlgorithmLimits limits;
  o.level_splits = limits.level_splits;
  o.level_tolerance = limits.level_tolerance;
  o.final_tolerance = limits.final_tolerance;
  o.max_level_iterations = limits.max_level_iterations;
  o.max_final_iterations = limits.max_final_iterations;
  return o;
}

void write_report(const sphere_map::Measurement& m, obc_sphere_map_report* to) {
  obc_sphere_map_report r{};
  r.bijective = m.bijective;
  r.mirrored = m.mirrored;
  r.flipped = m.flipped;
  r.degenerate = m.degenerate;
  r.zero_area_faces = m.zero_area_faces;
  r.degree = m.degree;
  r.energy_angle = m.energy_angle;
  r.energy_area = m.energy_area;
  r.energy = m.energy;
  r.max_quasi_conformal = m.max_quasi_conformal;
  r.mean_quasi_conformal = m.mean_quasi_conformal;
  r.min_area_ratio = m.min_area_ratio;
  r.max_area_ratio = m.max_area_ratio;
  r.stretch_efficiency = m.stretch_efficiency;
  r.isometric_mean = m.isometric_mean;
  r.equation_3_1 = m.equation_3_1;
  r.equation_3_2 = m.equation_3_2;
  r.equation_3_3 = m.equation_3_3;
  r.equation_3_4 = m.equation_3_4;
  capi::write_versioned(to, r);
}

// How many vertices are in a triangle.
std::size_t used_vertices(const Surface& s, const base::Host& host) {
  base::Array<unsigned char> used(s.positions.size(), 0, host.memory);
  for (const Triangle& t : s.triangles) {
    for (const mesh::Index v : t)
      used[v] = 1;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

// What both functions that compute a map do.
void compute_map(const obc_surface* surface, const obc_sphere_map_options* options, const obc_host* host,
                 double* directions, size_t* placed, obc_sphere_map_report* report) {
  const Surface s(surface);
  capi::require(directions != nullptr, "directions is NULL");
  const obc_sphere_map_options o = capi::copy_versioned(options, default_options());
  const capi::HostAdapter adapter(host);
  sphere_map::Options settings;
  settings.method = static_cast<sphere_map::Method>(o.method);
  settings.angle_weight = o.angle_weight;
  settings.area_weight = o.area_weight;
  settings.seed = o.seed;
  settings.limits = {o.level_splits, o.level_tolerance, o.final_tolerance, o.max_level_iterations,
                     o.max_final_iterations};
  if (o.trace != nullptr) {
    settings.trace = [call = o.trace, user = o.trace_user](const sphere_map::TracePoint& point) {
      call(point.iterations, point.vertices, point.energy, user);
    };
  }
  sphere_map::Partial partial(adapter.host().memory);
  const auto write = [&] {
    std::memcpy(directions, partial.directions.data(), partial.directions.size() * sizeof(Vector3));
    if (placed != nullptr) *placed = partial.placed;
  };
  try {
    partial.directions =
        sphere_map::compute(s.positions, s.triangles, settings, adapter.host(), placed != nullptr ? &partial : nullptr);
    if (placed != nullptr) partial.placed = used_vertices(s, adapter.host());
    if (report != nullptr) {
      write_report(sphere_map::measure(s.positions, s.triangles, partial.directions, o.angle_weight, o.area_weight,
                                       adapter.host()),
                   report);
    }
    write();
  } catch (const base::Error& e) {
    const bool unfinished = e.status() == base::Status::no_valid_result || e.status() == base::Status::cancelled;
    if (placed != nullptr && unfinished && !partial.directions.empty()) write();
    throw;
  }
}

}  // namespace

obc_status obc_sphere_map_options_init(obc_sphere_map_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_sphere_map_report_init(obc_sphere_map_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, obc_sphere_map_report{});
}

obc_status obc_sphere_map_compute(const obc_surface* surface, const obc_sphere_map_options* options,
                                  const obc_host* host, double* directions, obc_sphere_map_report* report,
                                  obc_error* error) {
  return capi::guarded(error, [&] { compute_map(surface, options, host, directions, nullptr, report); });
}

obc_status obc_sphere_map_compute_partial(const obc_surface* surface, const obc_sphere_map_options* options,
                                          const obc_host* host, double* directions, size_t* placed,
                                          obc_sphere_map_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(placed != nullptr, "placed is NULL");
    *placed = 0;
    compute_map(surface, options, host, directions, placed, report);
  });
}

obc_status obc_sphere_map_measure(const obc_surface* surface, const double* directions,
                                  const obc_sphere_map_options* options, const obc_host* host,
                                  obc_sphere_map_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    const Surface s(surface);
    capi::require(report != nullptr, "report is NULL");
    const obc_sphere_map_options o = capi::copy_versioned(options, default_options());
    const capi::HostAdapter adapter(host);
    write_report(sphere_map::measure(s.positions, s.triangles, s.directions(directions), o.angle_weight, o.area_weight,
                                     adapter.host()),
                 report);
  });
}

obc_status obc_sphere_map_face_distortion(const obc_surface* surface, const double* directions, const obc_host* host,
                                          double* quasi_conformal, double* area_ratio, obc_error* error) {
  return capi::guarded(error, [&] {
    const Surface s(surface);
    const capi::HostAdapter adapter(host);
    sphere_map::FaceDistortion faces(adapter.host().memory);
    sphere_map::measure(s.positions, s.triangles, s.directions(directions), 1, 1, adapter.host(), &faces);
    if (quasi_conformal != nullptr)
      std::copy(faces.quasi_conformal.begin(), faces.quasi_conformal.end(), quasi_conformal);
    if (area_ratio != nullptr) std::copy(faces.area_ratio.begin(), faces.area_ratio.end(), area_ratio);
  });
}

obc_status obc_sphere_map_round_to_float(const obc_surface* surface, const double* directions, const obc_host* host,
                                         float* rounded, obc_error* error) {
  return capi::guarded(error, [&] {
    const Surface s(surface);
    capi::require(rounded != nullptr, "rounded is NULL");
    const capi::HostAdapter adapter(host);
    mesh::require_valid_surface(s.directions(directions), s.triangles, adapter.host());
    const auto map = sphere_map::round_to_float(s.triangles, s.directions(directions), adapter.host());
    for (std::size_t v = 0; v < map.size(); ++v) {
      for (int c = 0; c < 3; ++c)
        rounded[3 * v + static_cast<std::size_t>(c)] = static_cast<float>(map[v][c]);
    }
  });
}

uint32_t obc_sphere_map_version(void) {
  return base::version_number;
}
