#include "hexmesh/captured/feature_surface.h"

#include "mesh/topology/cells.h"
#include "volume_map/input/polycube_pieces.h"

namespace orbicube::hexmesh {
namespace {

// Leaves out vertices that no triangle has; `number` gets the new number of each.
void take_used(std::span<const Vector3> positions, FeatureSurface& surface, Array<Index>& number) {
  number.assign(positions.size(), no_index);
  for (mesh::Triangle& t : surface.triangles) {
    for (Index& v : t) {
      if (number[v] == no_index) {
        number[v] = static_cast<Index>(surface.positions.size());
        surface.positions.push_back(positions[v]);
      }
      v = number[v];
    }
  }
}

void take_boundary(const mesh::Mesh& input, FeatureSurface& surface, const base::Host& host) {
  if (!input.tetrahedra.empty()) {
    surface.triangles = mesh::boundary_triangles(input, host);
    surface.pieces = volume_map::pieces_of(input.tetrahedra, input.positions.size(), host).count;
    return;
  }
  mesh::Mesh copy(host.memory);
  copy.positions.assign(input.positions.begin(), input.positions.end());
  copy.triangles.assign(input.triangles.begin(), input.triangles.end());
  volume_map::InputFindings findings;
  surface.pieces = volume_map::pieces_of_surface(copy, volume_map::Inside::nothing, 0, findings, host).count;
  surface.triangles = std::move(copy.triangles);
}

}  // namespace

FeatureSurface feature_surface(const mesh::Mesh& input, const FeatureRequest& request, const base::Host& host) {
  FeatureSurface surface(host.memory);
  take_boundary(input, surface, host);
  Array<Index> number(host.memory);
  take_used(input.positions, surface, number);
  Array<std::uint8_t> on_line(number.size(), 0, host.memory);
  for (const auto& [from, end] : request.tagged_edges) {
    if (number[from] == no_index || number[end] == no_index) continue;
    surface.lines.push_back({number[from], number[end]});
    on_line[from] = on_line[end] = 1;
  }
  const bool all_tags = request.features == Features::tags;
  // The ends of curves of a CAD model cut others that are sharp there; only of curves that are all kept are they
  // corners.
  for (const Index v : request.tagged_vertices) {
    if (number[v] != no_index && (all_tags || on_line[v] == 0)) surface.ends.push_back(number[v]);
  }
  surface.graph = graph_without(surface, request, {}, host);
  return surface;
}

mesh::FeatureGraph graph_without(const FeatureSurface& surface, const FeatureRequest& request,
                                 std::span<const mesh::Edge> edges, const base::Host& host) {
  const bool all_tags = request.features == Features::tags;
  mesh::FeatureOptions options;
  options.sharp = !all_tags && request.angle > 0;
  if (request.angle > 0) options.angle = request.angle;
  if (all_tags) options.edges = surface.lines;
  options.lines = surface.lines;
  options.weak_lines = request.features == Features::automatic;
  options.without = edges;
  options.shortest_side = request.shortest_side;
  if (request.features != Features::angles) options.corners = surface.ends;
  return mesh::feature_graph(surface.positions, surface.triangles, options, host);
}

}  // namespace orbicube::hexmesh
