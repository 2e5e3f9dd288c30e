#include "orbicube/mesh.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "base/version.h"
#include "capi/src/entry.h"
#include "capi/src/surface_view.h"
#include "mesh/files/read.h"
#include "mesh/files/write.h"
#include "mesh/mesh.h"
#include "mesh/search/tetrahedron_quality.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/surface_check.h"

using namespace orbicube;
using capi::copy;
using capi::view;
using mesh::Triangle;
using mesh::Vector3;

struct obc_mesh {
  explicit obc_mesh(const obc_host* host) : adapter(host), mesh(adapter.host().memory) {}
  capi::HostAdapter adapter;
  mesh::Mesh mesh;
  mesh::ReadReport report;
};

namespace {

// NULL where the number is no format's.
const mesh::FormatRow* format_row(int32_t format) {
  const auto rows = mesh::formats();
  const bool exists = format >= 0 && static_cast<std::size_t>(format) < rows.size();
  return exists ? &rows[static_cast<std::size_t>(format)] : nullptr;
}

const mesh::Mesh& checked(const obc_mesh* from) {
  capi::require(from != nullptr, "mesh is NULL");
  return from->mesh;
}

// Runs `fill` on a new mesh and hands it out when that succeeds.
template <class Fill>
obc_status make(const obc_host* host, obc_mesh** out, obc_error* error, const Fill& fill) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    auto made = std::make_unique<obc_mesh>(host);
    fill(*made);
    *out = made.release();
  });
}

template <class Cell>
void append(std::span<const Cell> from, std::size_t vertex_count, const char* what, mesh::Array<Cell>& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (std::ranges::max(from[i]) >= vertex_count) {
      throw base::Error("invalid-argument", std::string(what) + " " + std::to_string(i) + " has vertex " +
                                                std::to_string(std::ranges::max(from[i])) + " of " +
                                                std::to_string(vertex_count));
    }
  }
  to.assign(from.begin(), from.end());
}

// Numbers that are all 0 say nothing.
void take_regions(const int32_t* from, std::size_t count, mesh::Array<std::int32_t>& to) {
  if (from == nullptr || std::all_of(from, from + count, [](int32_t region) { return region == 0; })) return;
  to.assign(from, from + count);
}

void copy_regions(const mesh::Array<std::int32_t>& regions, std::size_t count, int32_t* to) {
  if (regions.empty() && to != nullptr)
    std::fill_n(to, count, 0);
  else
    copy(regions, to);
}

obc_mesh_read_options default_read_options() {
  obc_mesh_read_options options{};
  options.struct_size = sizeof options;
  options.weld_identical = mesh::ReadOptions().weld_identical;
  return options;
}

mesh::ReadOptions to_read_options(const obc_mesh_read_options* given) {
  mesh::ReadOptions options;
  options.weld_identical = capi::copy_versioned(given, default_read_options()).weld_identical != 0;
  return options;
}

obc_mesh_write_options default_write_options() {
  obc_mesh_write_options options{};
  options.struct_size = sizeof options;
  options.binary = mesh::WriteOptions().binary;
  return options;
}

mesh::WriteOptions to_write_options(const obc_mesh_write_options* given) {
  mesh::WriteOptions options;
  options.binary = capi::copy_versioned(given, default_write_options()).binary != 0;
  return options;
}

obc_mesh_tetrahedron_quality_report to_report(const mesh::TetrahedronQuality& q) {
  obc_mesh_tetrahedron_quality_report r{};
  r.struct_size = sizeof r;
  r.worst = q.worst;
  r.tetrahedra = q.tetrahedra;
  r.positive = q.positive;
  r.flat = q.flat;
  r.inverted = q.inverted;
  r.volume = q.volume;
  r.min_volume = q.min_volume;
  r.max_volume = q.max_volume;
  r.min_dihedral = q.min_dihedral;
  r.max_dihedral = q.max_dihedral;
  r.mean_min_dihedral = q.mean_min_dihedral;
  r.min_radius_ratio = q.min_radius_ratio;
  r.mean_radius_ratio = q.mean_radius_ratio;
  r.max_radius_edge = q.max_radius_edge;
  r.mean_radius_edge = q.mean_radius_edge;
  r.min_edge_length = q.min_edge_length;
  r.max_edge_length = q.max_edge_length;
  std::ranges::copy(q.dihedral_histogram, r.dihedral_histogram);
  std::ranges::copy(q.radius_ratio_histogram, r.radius_ratio_histogram);
  return r;
}

}  // namespace

obc_status obc_mesh_cells_init(obc_mesh_cells* cells, size_t struct_size) {
  return capi::init_versioned(cells, struct_size, obc_mesh_cells{});
}

obc_status obc_mesh_create(const obc_mesh_cells* cells, const obc_host* host, obc_mesh** out, obc_error* error) {
  return make(host, out, error, [&](obc_mesh& made) {
    capi::require(cells != nullptr, "cells is NULL");
    obc_mesh_cells defaults{};
    defaults.struct_size = sizeof defaults;
    const obc_mesh_cells from = capi::copy_versioned(cells, defaults);
    const auto positions = view<Vector3>(from.positions, from.vertex_count, "positions");
    const auto triangles = view<Triangle>(from.triangles, from.triangle_count, "triangles");
    const auto tetrahedra = view<mesh::Tetrahedron>(from.tetrahedra, from.tetrahedron_count, "tetrahedra");
    const auto hexahedra = view<mesh::Hexahedron>(from.hexahedra, from.hexahedron_count, "hexahedra");
    mesh::require_valid_surface(positions, triangles, made.adapter.host());
    made.mesh.positions.assign(positions.begin(), positions.end());
    made.mesh.triangles.assign(triangles.begin(), triangles.end());
    append(tetrahedra, positions.size(), "tetrahedron", made.mesh.tetrahedra);
    append(hexahedra, positions.size(), "hexahedron", made.mesh.hexahedra);
    take_regions(from.triangle_regions, triangles.size(), made.mesh.regions.triangles);
    take_regions(from.tetrahedron_regions, tetrahedra.size(), made.mesh.regions.tetrahedra);
    take_regions(from.hexahedron_regions, hexahedra.size(), made.mesh.regions.hexahedra);
  });
}

obc_status obc_mesh_make(const char* shape, size_t triangle_count, uint64_t seed, const obc_host* host, obc_mesh** out,
                         obc_error* error) {
  return make(host, out, error, [&](obc_mesh& made) {
    capi::require(shape != nullptr, "shape is NULL");
    made.mesh = mesh::make_shape(shape, {triangle_count, seed}, made.adapter.host());
  });
}

const char* obc_mesh_shape_name(size_t index) {
  const auto known = mesh::shapes();
  return index < known.size() ? known[index].name : nullptr;
}

void obc_mesh_destroy(obc_mesh* mesh) {
  delete mesh;
}

size_t obc_mesh_vertex_count(const obc_mesh* mesh) {
  return mesh != nullptr ? mesh->mesh.positions.size() : 0;
}

size_t obc_mesh_triangle_count(const obc_mesh* mesh) {
  return mesh != nullptr ? mesh->mesh.triangles.size() : 0;
}

size_t obc_mesh_tetrahedron_count(const obc_mesh* mesh) {
  return mesh != nullptr ? mesh->mesh.tetrahedra.size() : 0;
}

size_t obc_mesh_hexahedron_count(const obc_mesh* mesh) {
  return mesh != nullptr ? mesh->mesh.hexahedra.size() : 0;
}

obc_status obc_mesh_copy(const obc_mesh* mesh, double* positions, uint32_t* triangles, uint32_t* tetrahedra,
                         uint32_t* hexahedra, obc_error* error) {
  return capi::guarded(error, [&] {
    const mesh::Mesh& from = checked(mesh);
    copy(from.positions, positions);
    copy(from.triangles, triangles);
    copy(from.tetrahedra, tetrahedra);
    copy(from.hexahedra, hexahedra);
  });
}

uint32_t obc_mesh_region_kinds(const obc_mesh* mesh) {
  if (mesh == nullptr) return 0;
  const mesh::Regions& regions = mesh->mesh.regions;
  return static_cast<uint32_t>((regions.triangles.empty() ? 0 : OBC_MESH_TRIANGLE_REGIONS) |
                               (regions.tetrahedra.empty() ? 0 : OBC_MESH_TETRAHEDRON_REGIONS) |
                               (regions.hexahedra.empty() ? 0 : OBC_MESH_HEXAHEDRON_REGIONS));
}

obc_status obc_mesh_copy_regions(const obc_mesh* mesh, int32_t* triangles, int32_t* tetrahedra, int32_t* hexahedra,
                                 obc_error* error) {
  return capi::guarded(error, [&] {
    const mesh::Mesh& from = checked(mesh);
    copy_regions(from.regions.triangles, from.triangles.size(), triangles);
    copy_regions(from.regions.tetrahedra, from.tetrahedra.size(), tetrahedra);
    copy_regions(from.regions.hexahedra, from.hexahedra.size(), hexahedra);
  });
}

obc_status obc_mesh_surface(const obc_mesh* mesh, obc_surface* surface, obc_error* error) {
  return capi::guarded(error, [&] {
    const mesh::Mesh& from = checked(mesh);
    capi::require(surface != nullptr, "surface is NULL");
    surface->positions = reinterpret_cast<const double*>(from.positions.data());
    surface->vertex_count = from.positions.size();
    surface->triangles = reinterpret_cast<const uint32_t*>(from.triangles.data());
    surface->triangle_count = from.triangles.size();
  });
}

obc_status obc_mesh_check_cells(const obc_mesh* mesh, const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    const capi::HostAdapter adapter(host);
    mesh::require_valid_cells(checked(mesh), adapter.host());
  });
}

obc_status obc_mesh_boundary(const obc_mesh* mesh, const obc_host* host, obc_mesh** out, obc_error* error) {
  return make(host, out, error, [&](obc_mesh& made) {
    const mesh::Mesh& from = checked(mesh);
    made.mesh.triangles = mesh::boundary_triangles(from, made.adapter.host());
    made.mesh.positions = from.positions;
  });
}

obc_status obc_mesh_tetrahedron_quality_report_init(obc_mesh_tetrahedron_quality_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, to_report(mesh::TetrahedronQuality{}));
}

obc_status obc_mesh_tetrahedron_quality(const obc_mesh* mesh, const obc_host* host,
                                        obc_mesh_tetrahedron_quality_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    const mesh::Mesh& from = checked(mesh);
    capi::require(report != nullptr, "report is NULL");
    const capi::HostAdapter adapter(host);
    capi::write_versioned(report,
                          to_report(mesh::tetrahedron_quality(from.positions, from.tetrahedra, adapter.host())));
  });
}

obc_status obc_mesh_read_options_init(obc_mesh_read_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_read_options());
}

obc_status obc_mesh_read(const char* path, const obc_mesh_read_options* options, const obc_host* host, obc_mesh** out,
                         obc_error* error) {
  return make(host, out, error, [&](obc_mesh& made) {
    const mesh::ReadOptions settings = to_read_options(options);
    capi::on_file(path, [&] { made.mesh = mesh::read_mesh(path, settings, made.adapter.host(), &made.report); });
  });
}

obc_status obc_mesh_read_memory(const void* bytes, size_t size, int32_t format, const obc_mesh_read_options* options,
                                const obc_host* host, obc_mesh** out, obc_error* error) {
  return make(host, out, error, [&](obc_mesh& made) {
    capi::require(format_row(format) != nullptr, "format is none of OBC_MESH_...");
    const auto content = view<std::byte>(static_cast<const std::byte*>(bytes), size, "bytes");
    made.mesh = mesh::read_mesh(static_cast<mesh::Format>(format), content, to_read_options(options),
                                made.adapter.host(), &made.report);
  });
}

const char* obc_mesh_format_ending(int32_t format) {
  const mesh::FormatRow* row = format_row(format);
  return row != nullptr ? row->ending : nullptr;
}

const char* obc_mesh_format_name(int32_t format) {
  const mesh::FormatRow* row = format_row(format);
  return row != nullptr ? row->name : nullptr;
}

uint32_t obc_mesh_format_contents(int32_t format) {
  const mesh::FormatRow* row = format_row(format);
  if (row == nullptr) return 0;
  return static_cast<uint32_t>(OBC_MESH_HOLDS_SURFACES | (row->polygons ? OBC_MESH_HOLDS_POLYGONS : 0) |
                               (row->cells ? OBC_MESH_HOLDS_CELLS : 0) | (row->binary ? OBC_MESH_HOLDS_BINARY : 0) |
                               (row->regions ? OBC_MESH_HOLDS_REGIONS : 0));
}

const char* obc_mesh_format(const obc_mesh* mesh) {
  return mesh != nullptr ? mesh->report.format.c_str() : "";
}

size_t obc_mesh_polygon_count(const obc_mesh* mesh) {
  return mesh != nullptr ? mesh->report.polygons : 0;
}

size_t obc_mesh_welded_vertex_count(const obc_mesh* mesh) {
  return mesh != nullptr ? mesh->report.welded_vertices : 0;
}

const char* obc_mesh_note(const obc_mesh* mesh, size_t index) {
  return mesh != nullptr && index < mesh->report.notes.size() ? mesh->report.notes[index].c_str() : nullptr;
}

obc_status obc_mesh_write_options_init(obc_mesh_write_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_write_options());
}

obc_status obc_mesh_write(const char* path, const obc_mesh* mesh, const obc_mesh_write_options* options,
                          const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    const capi::HostAdapter adapter(host);
    const mesh::Mesh& from = checked(mesh);
    const mesh::WriteOptions settings = to_write_options(options);
    capi::on_file(path, [&] { mesh::write_mesh(path, from, settings, adapter.host()); });
  });
}

obc_status obc_mesh_write_surface(const char* path, const obc_surface* surface, const obc_mesh_write_options* options,
                                  const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    const capi::SurfaceView s(surface);
    const capi::HostAdapter adapter(host);
    const mesh::WriteOptions settings = to_write_options(options);
    mesh::require_valid_surface(s.positions, s.triangles, adapter.host());
    mesh::Mesh copied(adapter.host().memory);
    copied.positions.assign(s.positions.begin(), s.positions.end());
    copied.triangles.assign(s.triangles.begin(), s.triangles.end());
    capi::on_file(path, [&] { mesh::write_mesh(path, copied, settings, adapter.host()); });
  });
}

uint32_t obc_mesh_version(void) {
  return base::version_number;
}
