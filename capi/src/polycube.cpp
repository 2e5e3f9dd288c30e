#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/version.h"
#include "capi/src/polycube_handle.h"
#include "capi/src/polycube_surface.h"
#include "capi/src/surface_view.h"
#include "polycube/map/certificate.h"
#include "polycube/map/construction.h"

using namespace orbicube;
using mesh::Vector3;

namespace {

using capi::copy;

obc_polycube_options default_options() {
  const polycube::ConstructionOptions defaults;
  obc_polycube_options o{};
  o.struct_size = sizeof o;
  o.construction = OBC_POLYCUBE_AUTO;
  o.corners = defaults.corners;
  o.seed = defaults.seed;
  o.area_weight = defaults.area_weight;
  o.rounds = static_cast<std::uint32_t>(defaults.rounds);
  return o;
}

void write_certificate(const polycube::Certificate& from, obc_polycube_certificate* to) {
  if (to == nullptr) return;
  obc_polycube_certificate value{};
  value.valid = from.valid();
  value.genus = from.genus;
  value.corners = from.corners;
  value.patches = from.patch_count;
  const std::size_t length = std::min(from.reason.size(), sizeof value.reason - 1);
  std::copy_n(from.reason.begin(), length, value.reason);
  capi::write_versioned(to, value);
}

}  // namespace

obc_status obc_polycube_create(const obc_surface* surface, const double* polycube, const obc_host* host,
                               obc_polycube_certificate* certificate, obc_polycube** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const capi::SurfaceView s(surface);
    capi::require(polycube != nullptr || s.positions.empty(), "polycube is NULL");
    auto made = std::make_unique<obc_polycube>(host);
    polycube::SurfaceMap& map = made->map;
    map.positions.assign(s.positions.begin(), s.positions.end());
    map.triangles.assign(s.triangles.begin(), s.triangles.end());
    const auto* const points = reinterpret_cast<const Vector3*>(polycube);
    map.polycube.assign(points, points + s.positions.size());
    polycube::set_unrefined(map);
    polycube::Certificate found = polycube::certify(map, made->adapter.host());
    if (found.valid() && found.cavities > 0)
      found.reason = "the surface has " + base::counted(1 + found.cavities, "component");
    write_certificate(found, certificate);
    if (!found.valid()) throw base::Error("no-valid-result", found.reason);
    made->corners = found.corners;
    made->patches = found.patch_count;
    *out = made.release();
  });
}

obc_status obc_polycube_options_init(obc_polycube_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_polycube_compute(const obc_surface* surface, const obc_polycube_options* options, const obc_host* host,
                                obc_polycube** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const capi::SurfaceView s(surface);
    const obc_polycube_options o = capi::copy_versioned(options, default_options());
    capi::require(o.construction >= OBC_POLYCUBE_AUTO && o.construction <= OBC_POLYCUBE_DISSERTATION,
                  "construction is not one of OBC_POLYCUBE_...");
    capi::require(std::isfinite(o.area_weight) && o.area_weight >= 0, "area_weight must not be negative");
    constexpr std::uint32_t max_rounds = std::numeric_limits<int>::max();
    auto made = std::make_unique<obc_polycube>(host);
    const base::Host& on = made->adapter.host();
    capi::require_one_surface(s, on);
    auto [best, method, printed] = polycube::construct(s.positions, s.triangles,
                                                       {.method = static_cast<polycube::Method>(o.construction),
                                                        .corners = o.corners,
                                                        .seed = o.seed,
                                                        .area_weight = o.area_weight,
                                                        .rounds = static_cast<int>(std::min(o.rounds, max_rounds))},
                                                       on);
    made->map = std::move(best.map);
    made->corners = best.certificate.corners;
    made->patches = best.certificate.patch_count;
    made->construction = static_cast<std::int32_t>(method);
    *out = made.release();
  });
}

void obc_polycube_destroy(obc_polycube* map) {
  delete map;
}

size_t obc_polycube_vertex_count(const obc_polycube* map) {
  return map != nullptr ? map->map.positions.size() : 0;
}

size_t obc_polycube_triangle_count(const obc_polycube* map) {
  return map != nullptr ? map->map.triangles.size() : 0;
}

size_t obc_polycube_corner_count(const obc_polycube* map) {
  return map != nullptr ? map->corners : 0;
}

size_t obc_polycube_patch_count(const obc_polycube* map) {
  return map != nullptr ? map->patches : 0;
}

int32_t obc_polycube_construction(const obc_polycube* map) {
  return map != nullptr ? map->construction : -1;
}

obc_status obc_polycube_corner_points(const obc_polycube* map, const obc_host* host, size_t* count, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(count != nullptr, "count is NULL");
    *count = 0;
    capi::require(map != nullptr, "map is NULL");
    const capi::HostAdapter adapter(host);
    *count = polycube::dissertation::count_corner_points(map->map, adapter.host());
  });
}

obc_status obc_polycube_copy(const obc_polycube* map, double* positions, double* polycube, uint32_t* triangles,
                             obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(map != nullptr, "map is NULL");
    copy(map->map.positions, positions);
    copy(map->map.polycube, polycube);
    copy(map->map.triangles, triangles);
  });
}

obc_status obc_polycube_copy_triangles(const obc_polycube* map, uint8_t* labels, uint32_t* patches, uint32_t* sources,
                                       obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(map != nullptr, "map is NULL");
    copy(map->map.labels, labels);
    copy(map->map.patches, patches);
    copy(map->map.triangle_sources, sources);
  });
}

obc_status obc_polycube_copy_sources(const obc_polycube* map, uint32_t* corners, double* weights, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(map != nullptr, "map is NULL");
    for (std::size_t i = 0; i < map->map.vertex_sources.size(); ++i) {
      const polycube::VertexSource& source = map->map.vertex_sources[i];
      if (corners != nullptr) std::copy(source.corner.begin(), source.corner.end(), corners + 3 * i);
      if (weights != nullptr) std::copy(source.weight.begin(), source.weight.end(), weights + 3 * i);
    }
  });
}

uint32_t obc_polycube_version(void) {
  return static_cast<uint32_t>(base::version_major * 10000 + base::version_minor * 100 + base::version_patch);
}
