#include "volume_map/frames/field_refusal.h"

#include <algorithm>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "frame_field/singularities/meshability.h"
#include "mesh/topology/place_text.h"

namespace orbicube::volume_map {

using quaternion::CubeClass;

void require_meshable(const FramedSolid& solid, const mesh::TetrahedralConnectivity& connectivity,
                      const mesh::EdgeRings& rings, std::span<const std::uint8_t> matchings, const base::Host& host) {
  const frame_field::SingularGraph graph =
      frame_field::singular_graph(solid.positions, connectivity, rings, solid.frames, matchings, host);
  const frame_field::Meshability local =
      frame_field::meshability(graph, connectivity.boundary_vertices(host.memory), host.memory);
  const auto curve_of = [&](Index edge) {
    for (std::size_t c = 0; c < graph.curves(); ++c) {
      const auto edges = graph.curve(c);
      if (std::find(edges.begin(), edges.end(), edge) != edges.end()) return std::to_string(c);
    }
    return std::string("?");
  };
  if (!local.edges.empty()) {
    const frame_field::SingularEdge& edge = graph.edges[local.edges.front()];
    const auto [p, q] = edge.vertices;
    const char* turn = edge.kind() == CubeClass::face_half   ? "by half a turn about an axis"
                       : edge.kind() == CubeClass::edge_half ? "by half a turn about a diagonal"
                                                             : "by a third of a turn";
    throw base::Error("no-valid-result", base::counted(local.edges.size(), "singular edge is", "singular edges are") +
                                             " those of no hexahedral mesh; around edge " + std::to_string(p) + "-" +
                                             std::to_string(q) + " of curve " + curve_of(local.edges.front()) +
                                             ", at " + mesh::place_text(solid.positions[p]) + ", frames turn " + turn);
  }
  if (local.vertices.empty()) return;
  const Index v = local.vertices.front();
  const bool node = std::binary_search(graph.nodes.begin(), graph.nodes.end(), v);
  std::string curve;
  for (Index i = 0; i < graph.edges.size() && curve.empty(); ++i) {
    if (graph.edges[i].vertices[0] == v || graph.edges[i].vertices[1] == v) curve = curve_of(i);
  }
  throw base::Error("no-valid-result", base::counted(local.vertices.size(), "vertex is", "vertices are") +
                                           " those of no hexahedral mesh; at vertex " + std::to_string(v) + ", " +
                                           mesh::place_text(solid.positions[v]) +
                                           (node ? ", singular curves meet that cannot, among them curve "
                                                 : ", edges with three cells become edges with five, on curve ") +
                                           curve);
}

}  // namespace orbicube::volume_map
