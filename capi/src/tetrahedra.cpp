#include "orbicube/tetrahedra.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

#include "base/known_kind.h"
#include "base/version.h"
#include "capi/src/entry.h"
#include "capi/src/surface_view.h"
#include "tetrahedra/input_check.h"
#include "tetrahedra/tetrahedra.h"

using namespace orbicube;
using capi::copy;
using mesh::Triangle;
using mesh::Vector3;

struct obc_tetrahedra {
  explicit obc_tetrahedra(const obc_host* host) : adapter(host), solid(adapter.host().memory) {}
  capi::HostAdapter adapter;
  tetrahedra::Solid solid;
};

namespace {

obc_tetrahedra_options default_options() {
  const tetrahedra::Options defaults;
  obc_tetrahedra_options o{};
  o.struct_size = sizeof o;
  o.keep_surface = defaults.keep_surface;
  o.quality = defaults.quality;
  o.max_volume = defaults.max_volume;
  o.edge_length = defaults.edge_length;
  o.size_growth = defaults.size_growth;
  return o;
}

base::Array<tetrahedra::SizePoint> sizes_of(const obc_tetrahedra_options& o, std::pmr::memory_resource* memory) {
  capi::require((o.size_positions != nullptr && o.size_lengths != nullptr) || o.size_count == 0,
                "options->size_positions or size_lengths is NULL");
  capi::require(o.size_count <= PTRDIFF_MAX / sizeof(tetrahedra::SizePoint), "options->size_count is too large");
  base::Array<tetrahedra::SizePoint> sizes(memory);
  sizes.reserve(o.size_count);
  for (std::size_t i = 0; i < o.size_count; ++i) {
    const double* p = o.size_positions + 3 * i;
    sizes.push_back({Vector3(p[0], p[1], p[2]), o.size_lengths[i]});
  }
  return sizes;
}

}  // namespace

obc_status obc_tetrahedra_options_init(obc_tetrahedra_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_tetrahedra_fill(const obc_surface* surface, const obc_tetrahedra_options* options, const obc_host* host,
                               obc_tetrahedra** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const capi::SurfaceView s(surface);
    const obc_tetrahedra_options o = capi::copy_versioned(options, default_options());
    auto made = std::make_unique<obc_tetrahedra>(host);
    const auto sizes = sizes_of(o, made->adapter.host().memory);
    made->solid = tetrahedra::fill(s.positions, s.triangles,
                                   {.quality = o.quality,
                                    .max_volume = o.max_volume,
                                    .edge_length = o.edge_length,
                                    .sizes = sizes,
                                    .size_growth = o.size_growth,
                                    .keep_surface = o.keep_surface != 0},
                                   made->adapter.host());
    *out = made.release();
  });
}

obc_status obc_tetrahedra_fill_mesh(const obc_surface* surface, double max_volume, const obc_host* host, obc_mesh** out,
                                    obc_error* error, void* /*user*/) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const capi::SurfaceView s(surface);
    const capi::HostAdapter adapter(host);
    const tetrahedra::Solid solid =
        tetrahedra::fill(s.positions, s.triangles, {.max_volume = max_volume}, adapter.host());
    obc_mesh_cells cells{};
    obc_mesh_cells_init(&cells, sizeof cells);
    cells.positions = reinterpret_cast<const double*>(solid.positions.data());
    cells.vertex_count = solid.positions.size();
    cells.tetrahedra = reinterpret_cast<const std::uint32_t*>(solid.tetrahedra.data());
    cells.tetrahedron_count = solid.tetrahedra.size();
    obc_error failed{};
    if (obc_mesh_create(&cells, host, out, &failed) != OBC_OK)
      throw base::Error(base::known_kind(failed.kind, static_cast<base::Status>(failed.status)), failed.message);
  });
}

void obc_tetrahedra_destroy(obc_tetrahedra* solid) {
  delete solid;
}

size_t obc_tetrahedra_vertex_count(const obc_tetrahedra* solid) {
  return solid != nullptr ? solid->solid.positions.size() : 0;
}

size_t obc_tetrahedra_count(const obc_tetrahedra* solid) {
  return solid != nullptr ? solid->solid.tetrahedra.size() : 0;
}

size_t obc_tetrahedra_boundary_count(const obc_tetrahedra* solid) {
  return solid != nullptr ? solid->solid.boundary.size() : 0;
}

size_t obc_tetrahedra_part_count(const obc_tetrahedra* solid) {
  return solid != nullptr ? solid->solid.parts : 0;
}

size_t obc_tetrahedra_cavity_count(const obc_tetrahedra* solid) {
  return solid != nullptr ? solid->solid.cavities : 0;
}

obc_status obc_tetrahedra_copy(const obc_tetrahedra* solid, double* positions, uint32_t* tetrahedra, uint32_t* boundary,
                               uint32_t* boundary_source, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(solid != nullptr, "solid is NULL");
    copy(solid->solid.positions, positions);
    copy(solid->solid.tetrahedra, tetrahedra);
    copy(solid->solid.boundary, boundary);
    copy(solid->solid.boundary_source, boundary_source);
  });
}

obc_status obc_tetrahedra_check_surface(const obc_surface* surface, const obc_host* host, uint32_t* pairs,
                                        size_t capacity, size_t* count, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(count != nullptr, "count is NULL");
    *count = 0;
    const capi::SurfaceView s(surface);
    capi::require(pairs != nullptr || capacity == 0, "pairs is NULL");
    const capi::HostAdapter adapter(host);
    const auto found = tetrahedra::self_intersections(s.positions, s.triangles, adapter.host());
    copy(std::span(found).first(std::min(capacity, found.size())), pairs);
    *count = found.size();
    tetrahedra::require_none(found);
  });
}

uint32_t obc_tetrahedra_version(void) {
  return static_cast<uint32_t>(base::version_major * 10000 + base::version_minor * 100 + base::version_patch);
}
