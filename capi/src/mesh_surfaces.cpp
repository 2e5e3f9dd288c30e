// C functions of surfaces: topology, orientation, intersections, normals, areas and distances.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "capi/src/surface_view.h"
#include "mesh/search/distances.h"
#include "mesh/search/intersections.h"
#include "mesh/search/vertex_measures.h"
#include "mesh/topology/orient.h"
#include "mesh/topology/surface_check.h"
#include "mesh/topology/topology.h"
#include "mesh/topology/weld.h"
#include "orbicube/mesh.h"

using namespace orbicube;
using capi::copy;
using capi::view;
using mesh::Triangle;
using mesh::Vector3;

namespace {

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

}  // namespace

obc_status obc_mesh_topology_report_init(obc_mesh_topology_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, obc_mesh_topology_report{});
}

obc_status obc_mesh_topology(const obc_surface* surface, const obc_host* host, obc_mesh_topology_report* report,
                             obc_error* error) {
  return capi::guarded(error, [&] {
    const capi::SurfaceView s(surface);
    capi::require(report != nullptr, "report is NULL");
    const capi::HostAdapter adapter(host);
    capi::write_versioned(report, to_report(mesh::topology(s.positions, s.triangles, adapter.host())));
  });
}

obc_status obc_mesh_check_closed_genus_zero(const obc_surface* surface, const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    const capi::SurfaceView s(surface);
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
      result.inward_oriented = done.inward_oriented;
      result.reversed_triangles = done.reversed_triangles;
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
    const capi::SurfaceView s(surface);
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
    const capi::SurfaceView s(surface);
    capi::require(normals != nullptr || s.positions.empty(), "normals is NULL");
    const capi::HostAdapter adapter(host);
    mesh::require_valid_surface(s.positions, s.triangles, adapter.host());
    copy(mesh::vertex_normals(s.positions, s.triangles, adapter.host()), normals);
  });
}

obc_status obc_mesh_vertex_areas(const obc_surface* surface, const obc_host* host, double* areas, obc_error* error) {
  return capi::guarded(error, [&] {
    const capi::SurfaceView s(surface);
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
    const capi::SurfaceView a(first), b(second);
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
