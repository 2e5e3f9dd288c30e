#include "orbicube/mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <string>

#include "base/version.h"
#include "capi/src/entry.h"
#include "mesh/files/read.h"
#include "mesh/files/write.h"
#include "mesh/mesh.h"
#include "mesh/search/distances.h"
#include "mesh/search/intersections.h"
#include "mesh/search/nearest.h"
#include "mesh/search/predicates.h"
#include "mesh/search/tetrahedron_quality.h"
#include "mesh/search/vertex_measures.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/orient.h"
#include "mesh/topology/surface_check.h"
#include "mesh/topology/topology.h"
#include "mesh/topology/weld.h"

using namespace orbicube;
using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

struct obc_mesh {
  explicit obc_mesh(const obc_host* host) : adapter(host), mesh(adapter.host().memory) {}
  capi::HostAdapter adapter;
  mesh::Mesh mesh;
  mesh::ReadReport report;
};

struct obc_mesh_search {
  obc_mesh_search(const obc_host* host, std::span<const Vector3> x, std::span<const Triangle> t)
      : adapter(host),
        positions(x.begin(), x.end(), adapter.host().memory),
        triangles(t.begin(), t.end(), adapter.host().memory),
        vertex_search(positions, adapter.host()),
        surface_search(positions, triangles, adapter.host()) {}
  capi::HostAdapter adapter;
  mesh::Array<Vector3> positions;
  mesh::Array<Triangle> triangles;
  mesh::VertexSearch vertex_search;
  mesh::SurfaceSearch surface_search;
};

namespace {

// The caller's array as the C++ side takes it: numbers have the layout of its vectors and cells.
template <class Element, class Number>
std::span<const Element> view(const Number* numbers, std::size_t count, const char* what) {
  static_assert(sizeof(Element) % sizeof(Number) == 0 && alignof(Element) == alignof(Number));
  if (count > 0 && numbers == nullptr) throw base::Error("invalid-argument", std::string(what) + " is NULL");
  if (count > PTRDIFF_MAX / sizeof(Element)) throw base::Error("invalid-argument", std::string(what) + ": too many");
  return {reinterpret_cast<const Element*>(numbers), count};
}

struct Surface {
  std::span<const Vector3> positions;
  std::span<const Triangle> triangles;

  explicit Surface(const obc_surface* from) {
    capi::require(from != nullptr, "surface is NULL");
    positions = view<Vector3>(from->positions, from->vertex_count, "surface->positions");
    triangles = view<Triangle>(from->triangles, from->triangle_count, "surface->triangles");
  }
};

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

const obc_mesh_search& checked(const obc_mesh_search* search) {
  capi::require(search != nullptr, "search is NULL");
  return *search;
}

template <class Element, class Number>
void copy(const mesh::Array<Element>& from, Number* to) {
  if (to != nullptr && !from.empty()) std::memcpy(to, from.data(), from.size() * sizeof(Element));
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

obc_mesh_topology_report to_report(const mesh::Topology& t) {
  obc_mesh_topology_report r{};
  r.closed = t.closed();
  r.manifold = t.manifold();
  r.orientable = t.orientable;
  r.vertices = t.vertices;
  r.unreferenced_vertices = t.unreferenced_vertices;
  r.triangles = t.triangles;
  r.edges = t.edges;
  r.components = t.components;
  r.boundary_edges = t.boundary_edges;
  r.boundary_loops = t.boundary_loops;
  r.longest_boundary_loop = t.longest_boundary_loop;
  r.non_manifold_edges = t.non_manifold_edges;
  r.non_manifold_vertices = t.non_manifold_vertices;
  r.inconsistent_edges = t.inconsistent_edges;
  r.degenerate_faces = t.degenerate_faces;
  r.duplicate_faces = t.duplicate_faces;
  r.zero_area_faces = t.zero_area_faces;
  r.coincident_vertices = t.coincident_vertices;
  r.euler_characteristic = t.euler_characteristic;
  r.genus = t.genus.value_or(-1);
  std::copy(t.low.begin(), t.low.end(), r.low);
  std::copy(t.high.begin(), t.high.end(), r.high);
  r.area = t.area;
  r.volume = t.volume;
  std::ranges::copy(t.first_boundary_edge, r.first_boundary_edge);
  std::ranges::copy(t.first_non_manifold_edge, r.first_non_manifold_edge);
  std::ranges::copy(t.first_inconsistent_edge, r.first_inconsistent_edge);
  std::ranges::copy(t.first_duplicate_faces, r.first_duplicate_faces);
  std::ranges::copy(t.first_coincident_vertices, r.first_coincident_vertices);
  r.first_non_manifold_vertex = t.first_non_manifold_vertex;
  r.first_vertex_apart = t.first_vertex_apart;
  r.first_degenerate_face = t.first_degenerate_face;
  r.first_zero_area_face = t.first_zero_area_face;
  return r;
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

// Finite points to look for.
// Squares of distances must be in the range of double.
constexpr double max_searched = 1e150;

std::span<const Vector3> queries(const double* points, std::size_t count) {
  const auto result = view<Vector3>(points, count, "points");
  for (const Vector3& p : result)
    capi::require(p.allFinite() && p.cwiseAbs().maxCoeff() <= max_searched, "a point is not finite, or beyond 1e150");
  return result;
}

// The sign that `predicate` returns for the points, or 2 when it cannot.
template <int dimension, class Predicate, class... Points>
int32_t sign_or_failure(const Predicate& predicate, const Points*... points) noexcept {
  using Point = Eigen::Matrix<double, dimension, 1>;
  if ((... || (points == nullptr))) return 2;
  const auto apply = [&](const auto&... p) { return (... && p.allFinite()) ? predicate(p...) : 2; };
  try {
    return apply(Point(points)...);
  } catch (const std::bad_alloc&) {
    return 2;
  }
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
                               (row->cells ? OBC_MESH_HOLDS_CELLS : 0) | (row->binary ? OBC_MESH_HOLDS_BINARY : 0));
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
    const Surface s(surface);
    const capi::HostAdapter adapter(host);
    const mesh::WriteOptions settings = to_write_options(options);
    mesh::require_valid_surface(s.positions, s.triangles, adapter.host());
    mesh::Mesh copied(adapter.host().memory);
    copied.positions.assign(s.positions.begin(), s.positions.end());
    copied.triangles.assign(s.triangles.begin(), s.triangles.end());
    capi::on_file(path, [&] { mesh::write_mesh(path, copied, settings, adapter.host()); });
  });
}

obc_status obc_mesh_topology_report_init(obc_mesh_topology_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, obc_mesh_topology_report{});
}

obc_status obc_mesh_topology(const obc_surface* surface, const obc_host* host, obc_mesh_topology_report* report,
                             obc_error* error) {
  return capi::guarded(error, [&] {
    const Surface s(surface);
    capi::require(report != nullptr, "report is NULL");
    const capi::HostAdapter adapter(host);
    capi::write_versioned(report, to_report(mesh::topology(s.positions, s.triangles, adapter.host())));
  });
}

obc_status obc_mesh_check_closed_genus_zero(const obc_surface* surface, const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    const Surface s(surface);
    const capi::HostAdapter adapter(host);
    mesh::require_closed_genus_zero(mesh::topology(s.positions, s.triangles, adapter.host()));
  });
}

obc_status obc_mesh_orient_report_init(obc_mesh_orient_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, obc_mesh_orient_report{});
}

obc_status obc_mesh_orient(const double* positions, size_t vertex_count, uint32_t* triangles, size_t triangle_count,
                           const obc_host* host, obc_mesh_orient_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    const auto x = view<Vector3>(positions, vertex_count, "positions");
    const auto t = view<Triangle>(triangles, triangle_count, "triangles");
    const capi::HostAdapter adapter(host);
    mesh::require_valid_surface(x, t, adapter.host());
    // On a copy: the caller's array is whole or untouched, also when the host cancels in the middle.
    mesh::Array<Triangle> turned(t.begin(), t.end(), adapter.host().memory);
    const mesh::OrientReport done = mesh::orient(x, turned, adapter.host());
    if (report != nullptr) {
      obc_mesh_orient_report result{};
      result.turned_outward = done.turned_outward;
      result.triangles_turned = done.triangles_turned;
      capi::write_versioned(report, result);
    }
    copy(turned, triangles);
  });
}

obc_status obc_mesh_first_at_same_position(const double* positions, size_t vertex_count, const obc_host* host,
                                           uint32_t* first, obc_error* error) {
  return capi::guarded(error, [&] {
    const auto x = view<Vector3>(positions, vertex_count, "positions");
    capi::require(first != nullptr || x.empty(), "first is NULL");
    const capi::HostAdapter adapter(host);
    mesh::require_valid_surface(x, {}, adapter.host());
    copy(mesh::first_at_same_position(x, adapter.host()), first);
  });
}

obc_status obc_mesh_intersections(const obc_surface* surface, const obc_host* host, uint32_t* pairs, size_t capacity,
                                  size_t* count, obc_error* error) {
  return capi::guarded(error, [&] {
    const Surface s(surface);
    capi::require(count != nullptr, "count is NULL");
    *count = 0;
    capi::require(pairs != nullptr || capacity == 0, "pairs is NULL");
    const capi::HostAdapter adapter(host);
    mesh::require_valid_surface(s.positions, s.triangles, adapter.host());
    const auto found = mesh::intersecting_triangles(s.positions, s.triangles, adapter.host(), capacity);
    copy(found, pairs);
    *count = found.size();
  });
}

obc_status obc_mesh_vertex_normals(const obc_surface* surface, const obc_host* host, double* normals,
                                   obc_error* error) {
  return capi::guarded(error, [&] {
    const Surface s(surface);
    capi::require(normals != nullptr || s.positions.empty(), "normals is NULL");
    const capi::HostAdapter adapter(host);
    mesh::require_valid_surface(s.positions, s.triangles, adapter.host());
    copy(mesh::vertex_normals(s.positions, s.triangles, adapter.host()), normals);
  });
}

obc_status obc_mesh_vertex_areas(const obc_surface* surface, const obc_host* host, double* areas, obc_error* error) {
  return capi::guarded(error, [&] {
    const Surface s(surface);
    capi::require(areas != nullptr || s.positions.empty(), "areas is NULL");
    const capi::HostAdapter adapter(host);
    mesh::require_valid_surface(s.positions, s.triangles, adapter.host());
    const auto all = mesh::vertex_areas(s.positions, s.triangles, adapter.host());
    for (const double area : all)
      capi::require(std::isfinite(area), "an area is beyond the range of double");
    copy(all, areas);
  });
}

obc_status obc_mesh_distance_init(obc_mesh_distance* distance, size_t struct_size) {
  return capi::init_versioned(distance, struct_size, obc_mesh_distance{});
}

obc_status obc_mesh_surface_distance(const obc_surface* first, const obc_surface* second, const obc_host* host,
                                     obc_mesh_distance* distance, obc_error* error) {
  return capi::guarded(error, [&] {
    const Surface a(first), b(second);
    capi::require(distance != nullptr, "distance is NULL");
    const capi::HostAdapter adapter(host);
    const auto d = mesh::surface_distance(a.positions, a.triangles, b.positions, b.triangles, adapter.host());
    obc_mesh_distance result{};
    result.first_mean = d.from_first.mean;
    result.first_root_mean_square = d.from_first.root_mean_square;
    result.first_max = d.from_first.largest;
    result.second_mean = d.from_second.mean;
    result.second_root_mean_square = d.from_second.root_mean_square;
    result.second_max = d.from_second.largest;
    capi::write_versioned(distance, result);
  });
}

obc_status obc_mesh_mean_distance(const double* a, size_t a_count, const double* b, size_t b_count,
                                  const obc_host* host, double* distance, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(distance != nullptr, "distance is NULL");
    const capi::HostAdapter adapter(host);
    *distance = mesh::mean_distance(view<Vector3>(a, a_count, "a"), view<Vector3>(b, b_count, "b"), adapter.host());
  });
}

obc_status obc_mesh_search_create(const obc_surface* surface, const obc_host* host, obc_mesh_search** out,
                                  obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const Surface s(surface);
    mesh::require_valid_surface(s.positions, s.triangles, capi::HostAdapter(host).host());
    for (const Vector3& p : s.positions)
      capi::require(p.cwiseAbs().maxCoeff() <= max_searched, "a coordinate is beyond 1e150");
    *out = new obc_mesh_search(host, s.positions, s.triangles);
  });
}

void obc_mesh_search_destroy(obc_mesh_search* search) {
  delete search;
}

obc_status obc_mesh_search_vertices(const obc_mesh_search* search, const double* points, size_t count,
                                    uint32_t* vertices, obc_error* error) {
  return capi::guarded(error, [&] {
    const obc_mesh_search& in = checked(search);
    const auto at = queries(points, count);
    capi::require(vertices != nullptr || count == 0, "vertices is NULL");
    capi::require(!in.positions.empty() || count == 0, "there are no vertices");
    for (std::size_t i = 0; i < count; ++i)
      vertices[i] = in.vertex_search.nearest(at[i]);
  });
}

obc_status obc_mesh_search_surface(const obc_mesh_search* search, const double* points, size_t count,
                                   uint32_t* triangles, double* weights, double* positions, double* distances,
                                   obc_error* error) {
  return capi::guarded(error, [&] {
    const obc_mesh_search& in = checked(search);
    const auto at = queries(points, count);
    capi::require(!in.triangles.empty() || count == 0, "there are no triangles");
    for (std::size_t i = 0; i < count; ++i) {
      const mesh::SurfacePoint found = in.surface_search.nearest(at[i]);
      if (triangles != nullptr) triangles[i] = found.triangle;
      if (weights != nullptr) std::copy(found.weights.begin(), found.weights.end(), weights + 3 * i);
      if (positions != nullptr) std::copy(found.position.begin(), found.position.end(), positions + 3 * i);
      if (distances != nullptr) distances[i] = found.distance;
    }
  });
}

int32_t obc_mesh_orientation_2d(const double* a, const double* b, const double* c) {
  return sign_or_failure<2>(mesh::orientation_2d, a, b, c);
}

int32_t obc_mesh_orientation_3d(const double* a, const double* b, const double* c, const double* d) {
  return sign_or_failure<3>(mesh::orientation_3d, a, b, c, d);
}

int32_t obc_mesh_orientation_from_origin(const double* p, const double* q, const double* r) {
  return sign_or_failure<3>(mesh::orientation_from_origin, p, q, r);
}

uint32_t obc_mesh_version(void) {
  return base::version_number;
}
