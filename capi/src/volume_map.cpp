#include "orbicube/volume_map.h"

#include <memory>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/version.h"
#include "capi/src/entry.h"
#include "capi/src/surface_view.h"
#include "capi/src/tetrahedral_input.h"
#include "mesh/topology/cells.h"
#include "volume_map/input/solid_boundary.h"
#include "volume_map/input/solid_pieces.h"
#include "volume_map/solid/solid_polycube.h"
#include "volume_map/solid/volume_map.h"

using namespace orbicube;
using capi::copy;

struct obc_volume_map_solid {
  explicit obc_volume_map_solid(const obc_host* host) : adapter(host), map(adapter.host().memory) {}

  capi::HostAdapter adapter;
  volume_map::VolumeMap map;
};

namespace {

obc_volume_map_solid_options default_solid_options() {
  obc_volume_map_solid_options o{};
  o.struct_size = sizeof o;
  o.corners = 100;
  return o;
}

// A connected solid, with the polycube of its boundary.
struct MappedSolid {
  volume_map::BoundaryFirst solid;
  polycube::Construction made;
};

}  // namespace

obc_status obc_volume_map_solid_options_init(obc_volume_map_solid_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_solid_options());
}

obc_status obc_volume_map_solid_compute(const double* positions, size_t vertex_count, const uint32_t* tetrahedra,
                                        size_t tetrahedron_count, const obc_volume_map_solid_options* options,
                                        const obc_host* host, obc_volume_map_solid** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const obc_volume_map_solid_options o = capi::copy_versioned(options, default_solid_options());
    auto made = std::make_unique<obc_volume_map_solid>(host);
    const base::Host& h = made->adapter.host();
    const mesh::Mesh whole = capi::solid_of(positions, vertex_count, tetrahedra, tetrahedron_count, h);
    // Errors name the caller's indices.
    if (whole.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
    mesh::require_valid_cells(whole, h);
    const volume_map::Pieces pieces = volume_map::pieces_of(whole.tetrahedra, whole.positions.size(), h);
    base::Array<MappedSolid> mapped(h.memory);
    std::optional<volume_map::PieceCutter> cutter;
    if (pieces.count > 1) cutter.emplace(whole, pieces, h);
    base::Array<volume_map::PolycubeSolid> solids(h.memory);
    for (std::size_t i = 0; i < pieces.count; ++i) {
      mesh::Mesh part(h.memory);
      if (cutter) part = cutter->piece(i);
      volume_map::BoundaryFirst first = volume_map::boundary_first(pieces.count > 1 ? part : whole, h);
      polycube::Construction found = volume_map::construct_polycube(
          first.outer_positions(), first.surface, {.corners = o.corners, .preferred_corners = 60, .seed = o.seed}, h);
      mapped.push_back({std::move(first), std::move(found)});
    }
    for (const MappedSolid& m : mapped)
      solids.push_back({m.solid.positions, m.solid.tetrahedra, m.solid.surface, m.made.map});
    made->map = volume_map::map_pieces_to_polycubes(solids, h);
    *out = made.release();
  });
}

void obc_volume_map_solid_destroy(obc_volume_map_solid* solid) {
  delete solid;
}

size_t obc_volume_map_solid_vertex_count(const obc_volume_map_solid* solid) {
  return solid != nullptr ? solid->map.source.size() : 0;
}

size_t obc_volume_map_solid_tetrahedron_count(const obc_volume_map_solid* solid) {
  return solid != nullptr ? solid->map.tetrahedra.size() : 0;
}

obc_status obc_volume_map_solid_copy(const obc_volume_map_solid* solid, double* positions, double* polycube,
                                     uint32_t* tetrahedra, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(solid != nullptr, "solid is NULL");
    copy(solid->map.source, positions);
    copy(solid->map.image, polycube);
    copy(solid->map.tetrahedra, tetrahedra);
  });
}

uint32_t obc_volume_map_version(void) {
  return static_cast<uint32_t>(base::version_major * 10000 + base::version_minor * 100 + base::version_patch);
}
