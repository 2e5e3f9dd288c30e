// The C functions for what is made of a map: the polycube as a graph, meshes of quads, and texture atlases.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "capi/src/polycube_handle.h"
#include "polycube/outputs/atlas_texels.h"
#include "polycube/outputs/patch_graph.h"
#include "polycube/outputs/quad_mesh.h"

using namespace orbicube;
using capi::copy;

struct obc_polycube_graph {
  explicit obc_polycube_graph(const obc_host* host) : adapter(host), graph(adapter.host().memory) {}
  capi::HostAdapter adapter;
  polycube::PatchGraph graph;
};

struct obc_polycube_quads {
  explicit obc_polycube_quads(const obc_host* host) : adapter(host), mesh(adapter.host().memory) {}
  capi::HostAdapter adapter;
  polycube::QuadMesh mesh;
};

struct obc_polycube_atlas {
  explicit obc_polycube_atlas(const obc_host* host) : adapter(host), corners(adapter.host().memory) {}
  capi::HostAdapter adapter;
  std::uint32_t size = 0;
  double texels_per_unit = 0, coverage = 0;
  polycube::Array<polycube::TexelCorners> corners;
};

namespace {

obc_polycube_quads_options default_quads_options() {
  const polycube::GridOptions defaults;
  obc_polycube_quads_options o{};
  o.struct_size = sizeof o;
  o.quads = defaults.quads;
  o.edge_length = defaults.edge_length;
  return o;
}

obc_polycube_atlas_options default_atlas_options() {
  const polycube::AtlasOptions defaults;
  obc_polycube_atlas_options o{};
  o.struct_size = sizeof o;
  o.size = defaults.size;
  o.padding = defaults.padding;
  return o;
}

// Copies from the graph, which must be there.
template <class Copy>
obc_status from(const obc_polycube_graph* graph, obc_error* error, const Copy& work) {
  return capi::guarded(error, [&] {
    capi::require(graph != nullptr, "graph is NULL");
    work(graph->graph);
  });
}

}  // namespace

obc_status obc_polycube_graph_create(const obc_polycube* map, const obc_host* host, obc_polycube_graph** out,
                                     obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    capi::require(map != nullptr, "map is NULL");
    auto made = std::make_unique<obc_polycube_graph>(host);
    made->graph = polycube::make_patch_graph(map->map, made->adapter.host());
    *out = made.release();
  });
}

void obc_polycube_graph_destroy(obc_polycube_graph* graph) {
  delete graph;
}

size_t obc_polycube_graph_corner_count(const obc_polycube_graph* graph) {
  return graph != nullptr ? graph->graph.corners.size() : 0;
}

size_t obc_polycube_graph_edge_count(const obc_polycube_graph* graph) {
  return graph != nullptr ? graph->graph.edges() : 0;
}

size_t obc_polycube_graph_patch_count(const obc_polycube_graph* graph) {
  return graph != nullptr ? graph->graph.patches() : 0;
}

size_t obc_polycube_graph_loop_count(const obc_polycube_graph* graph) {
  return graph != nullptr ? graph->graph.loop_begin.size() - 1 : 0;
}

size_t obc_polycube_graph_link_count(const obc_polycube_graph* graph) {
  return graph != nullptr ? graph->graph.neighbors.size() : 0;
}

obc_status obc_polycube_graph_copy_corners(const obc_polycube_graph* graph, double* positions, uint32_t* vertices,
                                           obc_error* error) {
  return from(graph, error, [&](const polycube::PatchGraph& g) {
    copy(g.corners, positions);
    copy(g.corner_vertices, vertices);
  });
}

obc_status obc_polycube_graph_copy_edges(const obc_polycube_graph* graph, uint32_t* corners, uint32_t* patches,
                                         uint8_t* convex, obc_error* error) {
  return from(graph, error, [&](const polycube::PatchGraph& g) {
    copy(g.dart_origin, corners);
    copy(g.dart_left, patches);
    copy(g.convex, convex);
  });
}

obc_status obc_polycube_graph_copy_patches(const obc_polycube_graph* graph, uint8_t* labels, double* coordinates,
                                           uint32_t* loop_starts, obc_error* error) {
  return from(graph, error, [&](const polycube::PatchGraph& g) {
    copy(g.labels, labels);
    copy(g.coordinates, coordinates);
    copy(g.loops_of_patch, loop_starts);
  });
}

obc_status obc_polycube_graph_copy_loops(const obc_polycube_graph* graph, uint32_t* starts, uint32_t* darts,
                                         obc_error* error) {
  return from(graph, error, [&](const polycube::PatchGraph& g) {
    copy(g.loop_begin, starts);
    copy(g.loops, darts);
  });
}

obc_status obc_polycube_graph_copy_dual(const obc_polycube_graph* graph, uint32_t* starts, uint32_t* neighbors,
                                        obc_error* error) {
  return from(graph, error, [&](const polycube::PatchGraph& g) {
    copy(g.neighbor_begin, starts);
    copy(g.neighbors, neighbors);
  });
}

obc_status obc_polycube_quads_options_init(obc_polycube_quads_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_quads_options());
}

obc_status obc_polycube_quads_create(const obc_polycube* map, const obc_polycube_quads_options* options,
                                     const obc_host* host, obc_polycube_quads** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    capi::require(map != nullptr, "map is NULL");
    const obc_polycube_quads_options o = capi::copy_versioned(options, default_quads_options());
    auto made = std::make_unique<obc_polycube_quads>(host);
    const base::Host& on = made->adapter.host();
    const polycube::PatchGraph graph = polycube::make_patch_graph(map->map, on);
    const polycube::PolycubeGrid grid =
        polycube::make_grid(graph, {.edge_length = o.edge_length, .quads = o.quads}, on);
    made->mesh = polycube::mesh_grid(graph, grid, on);
    polycube::sample_grid(map->map, made->mesh, on);
    for (const mesh::Vector3& p : made->mesh.positions)
      capi::require(p.allFinite(), "coordinates of the surface are too large for points between them");
    *out = made.release();
  });
}

void obc_polycube_quads_destroy(obc_polycube_quads* quads) {
  delete quads;
}

size_t obc_polycube_quads_vertex_count(const obc_polycube_quads* quads) {
  return quads != nullptr ? quads->mesh.positions.size() : 0;
}

size_t obc_polycube_quads_quad_count(const obc_polycube_quads* quads) {
  return quads != nullptr ? quads->mesh.quads.size() : 0;
}

obc_status obc_polycube_quads_copy(const obc_polycube_quads* quads, double* positions, double* polycube,
                                   uint32_t* corners, uint32_t* patches, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(quads != nullptr, "quads is NULL");
    copy(quads->mesh.positions, positions);
    copy(quads->mesh.polycube, polycube);
    copy(quads->mesh.quads, corners);
    copy(quads->mesh.patches, patches);
  });
}

obc_status obc_polycube_quads_copy_sources(const obc_polycube_quads* quads, uint32_t* triangles, double* weights,
                                           obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(quads != nullptr, "quads is NULL");
    copy(quads->mesh.triangles, triangles);
    copy(quads->mesh.weights, weights);
  });
}

obc_status obc_polycube_atlas_options_init(obc_polycube_atlas_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_atlas_options());
}

obc_status obc_polycube_atlas_create(const obc_polycube* map, const obc_polycube_atlas_options* options,
                                     const obc_host* host, obc_polycube_atlas** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    capi::require(map != nullptr, "map is NULL");
    const obc_polycube_atlas_options o = capi::copy_versioned(options, default_atlas_options());
    auto made = std::make_unique<obc_polycube_atlas>(host);
    const base::Host& on = made->adapter.host();
    const polycube::PatchGraph graph = polycube::make_patch_graph(map->map, on);
    const polycube::Atlas atlas = polycube::make_atlas(graph, {.size = o.size, .padding = o.padding}, on);
    made->size = o.size;
    made->texels_per_unit = atlas.scale;
    made->coverage = atlas.coverage;
    made->corners = polycube::texel_corners(atlas, graph, map->map, on);
    *out = made.release();
  });
}

void obc_polycube_atlas_destroy(obc_polycube_atlas* atlas) {
  delete atlas;
}

uint32_t obc_polycube_atlas_size(const obc_polycube_atlas* atlas) {
  return atlas != nullptr ? atlas->size : 0;
}

size_t obc_polycube_atlas_triangle_count(const obc_polycube_atlas* atlas) {
  return atlas != nullptr ? atlas->corners.size() : 0;
}

obc_status obc_polycube_atlas_copy(const obc_polycube_atlas* atlas, double* coordinates, double* texels_per_unit,
                                   double* coverage, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(atlas != nullptr, "atlas is NULL");
    if (texels_per_unit != nullptr) *texels_per_unit = atlas->texels_per_unit;
    if (coverage != nullptr) *coverage = atlas->coverage;
    if (coordinates == nullptr) return;
    for (const polycube::TexelCorners& triangle : atlas->corners)
      for (const auto& corner : triangle)
        for (const double texels : corner)
          *coordinates++ = texels / atlas->size;
  });
}

obc_status obc_polycube_atlas_sample(const obc_polycube_atlas* atlas, const obc_host* host, uint32_t* triangles,
                                     double* weights, uint8_t* covered, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(atlas != nullptr, "atlas is NULL");
    const capi::HostAdapter adapter(host);
    const base::Host& on = adapter.host();
    const polycube::AtlasTexels texels = polycube::covered_texels(atlas->size, atlas->corners, on);
    for (std::size_t i = 0; i < texels.shown.size(); ++i) {
      if (i % base::items_between_reports == 0) on.report("samples", i, texels.shown.size());
      const polycube::Index shown = texels.shown[i];
      const bool shows = shown != mesh::no_index;
      if (triangles != nullptr) triangles[i] = shows ? texels.triangles[shown] : mesh::no_index;
      if (covered != nullptr) covered[i] = shown == i ? 1 : 0;
      if (weights == nullptr) continue;
      mesh::Vector3 at(0, 0, 0);
      if (shows) at = polycube::weights_at(atlas->corners, texels, shown);
      std::copy_n(at.data(), 3, weights + 3 * i);
    }
  });
}
