// The C functions for polycubes that are given, and for one that several shapes share.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "capi/src/polycube_handle.h"
#include "capi/src/polycube_surface.h"
#include "capi/src/surface_view.h"
#include "polycube/domain/common_polycube.h"
#include "polycube/layout/drawn_construction.h"

using namespace orbicube;
using mesh::Vector3;

namespace {

polycube::DomainOptions domain_options(const obc_polycube_domain_options* options) {
  obc_polycube_domain_options defaults;
  obc_polycube_domain_options_init(&defaults, sizeof defaults);
  const obc_polycube_domain_options o = capi::copy_versioned(options, defaults);
  polycube::DomainOptions result;
  result.measure = static_cast<polycube::DomainMeasure>(o.measure);
  result.area_weight = o.area_weight;
  return result;
}

// A vertex of the polycube's triangles as a corner of its graph.
mesh::Index corner_at(const polycube::TargetPolycube& target, std::uint32_t vertex) {
  capi::require(vertex < target.map.positions.size(), "constraints: the polycube has no such vertex");
  const auto& corners = target.graph.corner_vertices;
  const auto place = std::find(corners.begin(), corners.end(), vertex);
  capi::require(place != corners.end(), "constraints: a vertex is no corner of the polycube");
  return static_cast<mesh::Index>(place - corners.begin());
}

std::vector<polycube::CornerPlace> constraints_of(const obc_polycube_constraints* constraints,
                                                  const polycube::TargetPolycube& target) {
  std::vector<polycube::CornerPlace> result;
  if (constraints == nullptr || constraints->count == 0) return result;
  capi::require(constraints->corners != nullptr, "constraints->corners is NULL");
  for (std::size_t i = 0; i < constraints->count; ++i) {
    polycube::CornerPlace place{corner_at(target, constraints->corners[i]), Vector3::Zero()};
    if (constraints->vertices != nullptr) place.vertex = constraints->vertices[i];
    if (place.vertex == mesh::no_index) {
      capi::require(constraints->points != nullptr, "constraints: a corner has neither vertex nor point");
      place.point = Eigen::Map<const Vector3>(constraints->points + 3 * i);
    }
    result.push_back(place);
  }
  return result;
}

using Handles = std::vector<std::unique_ptr<obc_polycube>>;

void hand_out(Handles& handles, obc_polycube** out) {
  for (std::size_t i = 0; i < handles.size(); ++i)
    out[i] = handles[i].release();
}

// A count that is no number of shapes is refused before anything is read or written by it.
constexpr std::size_t max_shapes = 65536;

// What several functions require of an array of `count` shapes or maps and of the handles for them, which are cleared.
template <class Given>
std::span<const Given> checked_array(const Given* given, std::size_t count, const char* missing, obc_polycube** out) {
  capi::require(out != nullptr, "out is NULL");
  capi::require(count > 0, "count is 0");
  capi::require(count <= max_shapes, "count is larger than 65536");
  std::fill_n(out, count, nullptr);
  capi::require(given != nullptr, missing);
  return {given, count};
}

}  // namespace

obc_status obc_polycube_map_to_domain(const obc_surface* surface, const obc_surface* polycube,
                                      const obc_polycube_constraints* constraints, const obc_host* host,
                                      obc_polycube** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const capi::SurfaceView s(surface);
    const capi::SurfaceView given(polycube);
    auto made = std::make_unique<obc_polycube>(host);
    const base::Host& on = made->adapter.host();
    capi::require_one_surface(s, on);
    const polycube::TargetPolycube target = polycube::target_of_mesh(given.positions, given.triangles, 0, on);
    const std::vector<polycube::CornerPlace> wanted = constraints_of(constraints, target);
    polycube::Construction found =
        polycube::construct_on(s.positions, s.triangles, target.graph, target.genus, {.places = wanted}, on);
    made->map = std::move(found.map);
    made->corners = found.certificate.corners;
    made->patches = found.certificate.patch_count;
    *out = made.release();
  });
}

obc_status obc_polycube_compute_common(const obc_surface* surfaces, size_t count, const obc_polycube_options* options,
                                       const obc_polycube_domain_options* domain, const obc_host* host,
                                       size_t* constructed_from, obc_polycube** out, obc_error* error) {
  return capi::guarded(error, [&] {
    const auto given = checked_array(surfaces, count, "surfaces is NULL", out);
    obc_polycube_options defaults;
    obc_polycube_options_init(&defaults, sizeof defaults);
    const obc_polycube_options o = capi::copy_versioned(options, defaults);
    capi::require(o.construction >= OBC_POLYCUBE_AUTO && o.construction <= OBC_POLYCUBE_VOXELS,
                  "construction is not one of OBC_POLYCUBE_...");
    Handles handles;
    for (std::size_t i = 0; i < count; ++i)
      handles.push_back(std::make_unique<obc_polycube>(host));
    const base::Host& on = handles.front()->adapter.host();
    std::vector<polycube::SurfaceSpan> shapes;
    for (const obc_surface& surface : given) {
      const capi::SurfaceView s(&surface);
      capi::require_one_surface(s, on);
      shapes.push_back({s.positions, s.triangles});
    }
    polycube::CommonPolycube found =
        polycube::construct_common(shapes,
                                   {.construction = {.method = static_cast<polycube::Method>(o.construction),
                                                     .corners = o.corners,
                                                     .seed = o.seed},
                                    .domain = domain_options(domain),
                                    .landmarks = {}},
                                   on);
    for (std::size_t i = 0; i < count; ++i) {
      handles[i]->map = std::move(found.maps[i]);
      handles[i]->corners = found.certificates[i].corners;
      handles[i]->patches = found.certificates[i].patch_count;
      handles[i]->energies = found.energies;
    }
    if (constructed_from != nullptr) *constructed_from = found.base;
    hand_out(handles, out);
  });
}

obc_status obc_polycube_optimize_common_domain(const obc_polycube* const* maps, size_t count,
                                               const obc_polycube_domain_options* options, const obc_host* host,
                                               obc_polycube** out, obc_error* error) {
  return capi::guarded(error, [&] {
    const auto given = checked_array(maps, count, "maps is NULL", out);
    for (const obc_polycube* map : given)
      capi::require(map != nullptr, "a map is NULL");
    Handles handles;
    std::vector<polycube::SurfaceMap*> copies;
    for (const obc_polycube* map : given) {
      handles.push_back(std::make_unique<obc_polycube>(host));
      handles.back()->map = map->map;
      handles.back()->construction = map->construction;
      copies.push_back(&handles.back()->map);
    }
    const polycube::CommonDomain found =
        polycube::optimize_domain(copies, domain_options(options), handles.front()->adapter.host());
    for (std::size_t i = 0; i < count; ++i) {
      handles[i]->corners = found.certificates[i].corners;
      handles[i]->patches = found.certificates[i].patch_count;
      handles[i]->energies = found.energies;
    }
    hand_out(handles, out);
  });
}
