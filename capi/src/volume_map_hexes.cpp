// The C functions of volume_map for solids on polycubes and hexahedral meshes.
#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "capi/src/entry.h"
#include "capi/src/polycube_surface.h"
#include "mesh/search/measures.h"
#include "mesh/topology/cells.h"
#include "orbicube/volume_map.h"
#include "volume_map/frames/frame_hexes.h"
#include "volume_map/meshing/coarse_surface.h"
#include "volume_map/meshing/hex_pieces.h"
#include "volume_map/solid/solid_boundary.h"
#include "volume_map/solid/solid_pieces.h"
#include "volume_map/solid/solid_polycube.h"
#include "volume_map/solid/volume_map.h"

using namespace orbicube;
using mesh::Tetrahedron;
using mesh::Triangle;
using mesh::Vector3;

struct obc_volume_map_solid {
  explicit obc_volume_map_solid(const obc_host* host) : adapter(host), map(adapter.host().memory) {}

  capi::HostAdapter adapter;
  volume_map::VolumeMap map;
};

struct obc_volume_map_hexes {
  explicit obc_volume_map_hexes(const obc_host* host) : adapter(host), made(adapter.host().memory) {}

  capi::HostAdapter adapter;
  volume_map::HexResult made;
};

namespace {

obc_volume_map_solid_options default_solid_options() {
  obc_volume_map_solid_options o{};
  o.struct_size = sizeof o;
  o.corners = 100;
  return o;
}

obc_volume_map_hexes_options default_hexes_options() {
  const volume_map::HexOptions defaults;
  obc_volume_map_hexes_options o{};
  o.struct_size = sizeof o;
  o.padding = static_cast<std::int32_t>(defaults.padding);
  o.cells = defaults.cells;
  o.corners = 100;
  o.triangles = 6000;
  o.rounds = defaults.rounds;
  o.max_hausdorff_percent = defaults.distance;
  o.max_cells = defaults.max_cells;
  o.feature_angle = defaults.feature_angle;
  return o;
}

obc_volume_map_frame_options default_frame_options() {
  const volume_map::FrameHexOptions defaults;
  obc_volume_map_frame_options o{};
  o.struct_size = sizeof o;
  o.rounds = defaults.rounds;
  o.cells = defaults.cells;
  o.max_hausdorff_percent = defaults.distance;
  o.max_cells = defaults.max_cells;
  return o;
}

// The caller's tetrahedra, of which no more is known than their numbers.
mesh::Mesh solid_of(const double* positions, size_t vertex_count, const uint32_t* tetrahedra, size_t tetrahedron_count,
                    const base::Host& host) {
  capi::require(positions != nullptr || vertex_count == 0, "positions is NULL");
  capi::require(tetrahedra != nullptr || tetrahedron_count == 0, "tetrahedra is NULL");
  constexpr std::size_t most = UINT32_MAX / 4;
  capi::require(vertex_count < most && tetrahedron_count < most, "too many vertices or tetrahedra");
  mesh::Mesh solid(host.memory);
  const auto* const places = reinterpret_cast<const Vector3*>(positions);
  const auto* const cells = reinterpret_cast<const Tetrahedron*>(tetrahedra);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (!places[v].allFinite())
      throw base::Error("invalid-argument", "the position of vertex " + std::to_string(v) + " is not finite");
  }
  solid.positions.assign(places, places + vertex_count);
  solid.tetrahedra.assign(cells, cells + tetrahedron_count);
  return solid;
}

// The surface of a piece, cavities included, with its polycube.
struct PieceOfSurface {
  mesh::Mesh surface;
  polycube::Construction made;
  volume_map::WorkingSpace space;  // of both
  bool coarser = false;            // the polycube is that of a coarser surface

  volume_map::PolycubeSurface mapped() const {
    if (!coarser && !made.map.triangles.empty()) return {.map = made.map, .space = &space};
    return {made.map, surface.positions, surface.triangles, &space};
  }
};

base::Array<PieceOfSurface> pieces_of(const capi::SurfaceView& s, const obc_volume_map_hexes_options& o,
                                      const base::Host& host) {
  capi::require_closed_surfaces(s, host);
  mesh::Mesh whole(host.memory);
  whole.positions.assign(s.positions.begin(), s.positions.end());
  whole.triangles.assign(s.triangles.begin(), s.triangles.end());
  const volume_map::SurfacePieces pieces = volume_map::surface_pieces(whole.positions, whole.triangles, host);
  volume_map::require_cells_for_pieces(pieces.count, o.cells);
  const bool parts = pieces.count + pieces.cavities > 1;
  if (parts) volume_map::refuse_self_intersections(whole.positions, whole.triangles, 1, host);
  const auto wrong = std::find(pieces.wrong_side.begin(), pieces.wrong_side.end(), std::uint8_t{1});
  if (parts && wrong != pieces.wrong_side.end()) {
    throw base::Error("inconsistent-orientation",
                      "triangles look into the solid, the first is " +
                          std::to_string(wrong - pieces.wrong_side.begin()) +
                          "; outer components must be outward-oriented, boundaries of cavities into these");
  }
  base::Array<PieceOfSurface> result(host.memory);
  const int exponent = volume_map::size_exponent(whole.positions);
  std::optional<volume_map::PieceCutter> cutter;
  if (pieces.count > 1) cutter.emplace(whole, pieces, host);
  for (std::size_t i = 0; i < pieces.count; ++i) {
    mesh::Mesh surface = cutter ? cutter->piece(i) : std::move(whole);
    const volume_map::WorkingSpace space(surface.positions, surface.triangles, exponent);
    space.take(surface.positions);
    capi::require_outward(mesh::measures(surface.positions, surface.triangles, host).volume);
    polycube::Construction made(host.memory);
    if (o.method == OBC_VOLUME_MAP_METHOD_GRID) {
      result.push_back({std::move(surface), std::move(made), space});
      continue;
    }
    const bool coarser = o.triangles > 0 && surface.triangles.size() / 2 > o.triangles;
    const volume_map::CoarseSurface coarse = volume_map::coarse_surface(
        surface.positions, surface.triangles, coarser ? o.triangles : surface.triangles.size(), host);
    try {
      made = volume_map::construct_polycube(coarse.positions, coarse.triangles,
                                            {.corners = o.corners, .preferred_corners = 60, .seed = o.seed}, host);
    } catch (const base::Error& error) {
      const bool grid_may = o.method == OBC_VOLUME_MAP_METHOD_AUTO && o.padding != OBC_VOLUME_MAP_PADDING_WITHOUT;
      if (!grid_may || error.status() != base::Status::no_valid_result) throw;
      host.log(error.what());
    }
    const bool of_coarse = coarse.triangles.size() < surface.triangles.size();
    result.push_back({std::move(surface), std::move(made), space, of_coarse});
  }
  return result;
}

// A connected solid, with the polycube of its boundary.
struct MappedSolid {
  volume_map::BoundaryFirst solid;
  polycube::Construction made;
};

template <class From>
void copy_out(const From& from, void* to) {
  if (to != nullptr && !from.empty()) std::memcpy(to, from.data(), from.size() * sizeof from[0]);
}

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
    const mesh::Mesh whole = solid_of(positions, vertex_count, tetrahedra, tetrahedron_count, h);
    // What is wrong is reported with the caller's numbers.
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
    copy_out(solid->map.source, positions);
    copy_out(solid->map.image, polycube);
    copy_out(solid->map.tetrahedra, tetrahedra);
  });
}

obc_status obc_volume_map_hexes_options_init(obc_volume_map_hexes_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_hexes_options());
}

obc_status obc_volume_map_hexes_compute(const obc_surface* surface, const obc_volume_map_hexes_options* options,
                                        const obc_host* host, obc_volume_map_hexes_report* report,
                                        obc_volume_map_hexes** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const capi::SurfaceView s(surface);
    const obc_volume_map_hexes_options o = capi::copy_versioned(options, default_hexes_options());
    capi::require(o.padding >= OBC_VOLUME_MAP_PADDING_AUTO && o.padding <= OBC_VOLUME_MAP_PADDING_WITHOUT,
                  "options->padding is none of the constants");
    capi::require(o.method >= OBC_VOLUME_MAP_METHOD_AUTO && o.method <= OBC_VOLUME_MAP_METHOD_GRID,
                  "options->method is none of the constants");
    auto made = std::make_unique<obc_volume_map_hexes>(host);
    const base::Host& h = made->adapter.host();
    const base::Array<PieceOfSurface> pieces = pieces_of(s, o, h);
    base::Array<volume_map::PolycubeSurface> mapped(h.memory);
    std::size_t corners = 0;
    for (const PieceOfSurface& piece : pieces) {
      mapped.push_back(piece.mapped());
      corners += piece.made.certificate.corners;
    }
    made->made = volume_map::make_hexahedra_of_pieces(mapped,
                                                      {.method = static_cast<volume_map::HexMethod>(o.method),
                                                       .cells = o.cells,
                                                       .padding = static_cast<volume_map::Padding>(o.padding),
                                                       .rounds = o.rounds,
                                                       .distance = o.max_hausdorff_percent,
                                                       .max_cells = o.max_cells,
                                                       .feature_angle = o.feature_angle},
                                                      h);
    obc_volume_map_hexes_report r{};
    r.struct_size = sizeof r;
    r.padded = made->made.padded ? 1 : 0;
    r.min_scaled_jacobian = made->made.quality.min_scaled_jacobian;
    r.mean_scaled_jacobian = made->made.quality.mean_scaled_jacobian;
    r.volume = made->made.quality.volume;
    r.polycube_corners = corners;
    r.off_surface = made->made.off_surface;
    r.hausdorff_percent = made->made.distance;
    r.volume_error_percent = made->made.volume_error;
    r.follows_sharp_edges = made->made.follows_sharp_edges ? 1 : 0;
    r.grid_based = made->made.grid_based ? 1 : 0;
    capi::write_versioned(report, r);
    *out = made.release();
  });
}

obc_status obc_volume_map_frame_options_init(obc_volume_map_frame_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_frame_options());
}

obc_status obc_volume_map_frame_hexes_compute(const double* positions, size_t vertex_count, const uint32_t* tetrahedra,
                                              size_t tetrahedron_count, const double* frames,
                                              const obc_volume_map_frame_options* options, const obc_host* host,
                                              obc_volume_map_frame_report* report, obc_volume_map_hexes** out,
                                              obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const obc_volume_map_frame_options o = capi::copy_versioned(options, default_frame_options());
    capi::require(o.feature_angle >= 0 && o.feature_angle <= 180, "options->feature_angle is out of range");
    auto made = std::make_unique<obc_volume_map_hexes>(host);
    const base::Host& h = made->adapter.host();
    mesh::Mesh given = solid_of(positions, vertex_count, tetrahedra, tetrahedron_count, h);
    if (given.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
    mesh::require_valid_cells(given, h);
    const auto make = [&] {
      const volume_map::FrameHexOptions how = {
          .cells = o.cells, .rounds = o.rounds, .distance = o.max_hausdorff_percent, .max_cells = o.max_cells};
      if (frames == nullptr)
        return volume_map::make_hexahedra_along_frames(given.positions, given.tetrahedra,
                                                       o.feature_angle * std::numbers::pi / 180, how, h);
      volume_map::FramedSolid solid(h.memory);
      solid.positions = std::move(given.positions);
      solid.tetrahedra = std::move(given.tetrahedra);
      const auto* const first = reinterpret_cast<const quaternion::Quaternion*>(frames);
      solid.frames.assign(first, first + tetrahedron_count);
      for (quaternion::Quaternion& q : solid.frames) {
        const double square = dot(q, q);
        capi::require(square > 1e-12 && square < 1e12, "a frame is zero or not finite");
        q = quaternion::normalized(q);
      }
      return volume_map::make_hexahedra_by_frames(solid, how, h);
    };
    volume_map::FrameHexes result = make();
    obc_volume_map_frame_report r{};
    r.struct_size = sizeof r;
    r.integers_optimal = result.map.integers_optimal ? 1 : 0;
    r.min_scaled_jacobian = result.result.quality.min_scaled_jacobian;
    r.mean_scaled_jacobian = result.result.quality.mean_scaled_jacobian;
    r.volume = result.result.quality.volume;
    r.off_surface = result.result.off_surface;
    r.singular_edges = result.map.singular_edges;
    r.irregular_edges = result.inner_irregular_edges;
    r.integers = result.map.integers;
    r.tetrahedra = result.map.solid.tetrahedra.size();
    r.inverted_at_start = result.map.inverted_at_start;
    r.steps = result.map.steps;
    r.hausdorff_percent = result.result.distance;
    r.volume_error_percent = result.result.volume_error;
    capi::write_versioned(report, r);
    made->made = std::move(result.result);
    *out = made.release();
  });
}

void obc_volume_map_hexes_destroy(obc_volume_map_hexes* hexes) {
  delete hexes;
}

size_t obc_volume_map_hexes_vertex_count(const obc_volume_map_hexes* hexes) {
  return hexes != nullptr ? hexes->made.mesh.positions.size() : 0;
}

size_t obc_volume_map_hexes_count(const obc_volume_map_hexes* hexes) {
  return hexes != nullptr ? hexes->made.mesh.hexahedra.size() : 0;
}

size_t obc_volume_map_hexes_quad_count(const obc_volume_map_hexes* hexes) {
  return hexes != nullptr ? hexes->made.mesh.quads.size() : 0;
}

obc_status obc_volume_map_hexes_copy(const obc_volume_map_hexes* hexes, double* positions, uint32_t* hexahedra,
                                     uint32_t* quads, uint32_t* quad_patches, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(hexes != nullptr, "hexes is NULL");
    const volume_map::HexMesh& mesh = hexes->made.mesh;
    copy_out(mesh.positions, positions);
    copy_out(mesh.hexahedra, hexahedra);
    copy_out(mesh.quads, quads);
    copy_out(mesh.quad_patches, quad_patches);
  });
}
