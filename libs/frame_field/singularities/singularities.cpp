#include "frame_field/singularities/singularities.h"

#include <algorithm>

#include "quaternion/frame_distance.h"

namespace orbicube::frame_field {
namespace {

using quaternion::cube_group;
using quaternion::CubeClass;

std::int8_t turn_about(std::span<const Index> ring, std::uint8_t rotation, const Vector3& along,
                       std::span<const Quaternion> field, std::span<const std::uint8_t> matchings) {
  const CubeClass kind = cube_group.conjugacy_class[rotation];
  if (kind == CubeClass::face_half) return 2;
  if (kind != CubeClass::face_quarter) return 0;
  const double cosine = turn_along(
      ring.size(), rotation, along,
      [&](std::size_t k) -> const Quaternion& { return field[mesh::TetrahedralConnectivity::tetrahedron_of(ring[k])]; },
      [&](std::size_t k) { return matchings[ring[k]]; });
  return cosine > 0 ? 1 : -1;
}

// Singular edges by vertex.
class Incidence {
 public:
  Incidence(const Array<SingularEdge>& edges, std::pmr::memory_resource* memory) : ends_(memory) {
    ends_.reserve(2 * edges.size());
    for (Index e = 0; e < edges.size(); ++e) {
      for (const Index v : edges[e].vertices)
        ends_.push_back({v, e});
    }
    std::ranges::sort(
        ends_, [](const End& a, const End& b) { return a.vertex != b.vertex ? a.vertex < b.vertex : a.edge < b.edge; });
  }
  struct End {
    Index vertex, edge;
  };
  std::span<const End> at(Index vertex) const {
    const auto begin =
        std::partition_point(ends_.begin(), ends_.end(), [&](const End& e) { return e.vertex < vertex; });
    auto end = begin;
    while (end != ends_.end() && end->vertex == vertex)
      ++end;
    return std::span(ends_).subspan(static_cast<std::size_t>(begin - ends_.begin()),
                                    static_cast<std::size_t>(end - begin));
  }
  // visit(vertex, ends)
  template <class Visit>
  void for_each_vertex(const Visit& visit) const {
    for (std::size_t i = 0; i < ends_.size();) {
      std::size_t end = i;
      while (end < ends_.size() && ends_[end].vertex == ends_[i].vertex)
        ++end;
      visit(ends_[i].vertex, std::span(ends_).subspan(i, end - i));
      i = end;
    }
  }

 private:
  Array<End> ends_;
};

void trace_curves(const Incidence& incidence, std::span<const std::uint8_t> on_boundary, SingularGraph& graph,
                  std::pmr::memory_resource* memory) {
  Array<std::uint8_t> used(graph.edges.size(), 0, memory);
  const auto passes = [&](Index v) { return on_boundary[v] == 0 && incidence.at(v).size() == 2; };
  const auto other_end = [&](Index e, Index v) {
    const mesh::Edge& edge = graph.edges[e].vertices;
    return edge[0] == v ? edge[1] : edge[0];
  };
  // From a vertex along an edge as far as vertices let pass.
  const auto trace = [&](Index vertex, Index edge) {
    while (used[edge] == 0) {
      used[edge] = 1;
      graph.curve_edges.push_back(edge);
      vertex = other_end(edge, vertex);
      if (!passes(vertex)) break;
      const auto ends = incidence.at(vertex);
      edge = ends[0].edge == edge ? ends[1].edge : ends[0].edge;
    }
    graph.curve_begin.push_back(graph.curve_edges.size());
  };
  graph.curve_begin.push_back(0);
  incidence.for_each_vertex([&](Index vertex, std::span<const Incidence::End> ends) {
    if (passes(vertex)) return;
    for (const Incidence::End& end : ends) {
      if (used[end.edge] != 0) continue;
      trace(vertex, end.edge);
      graph.curve_closed.push_back(0);
    }
  });
  for (Index e = 0; e < graph.edges.size(); ++e) {
    if (used[e] != 0) continue;
    trace(graph.edges[e].vertices[0], e);
    graph.curve_closed.push_back(1);
  }
}

}  // namespace

Array<std::uint8_t> matchings(const mesh::TetrahedralConnectivity& connectivity, std::span<const Quaternion> field,
                              const base::Host& host) {
  Array<std::uint8_t> result(connectivity.face_count(), 0, host.memory);
  for (Index face = 0; face < result.size(); ++face) {
    if (face % base::items_between_reports == 0) host.report("matching", face, result.size());
    const Index other = connectivity.opposite(face);
    if (other == no_index || other < face) continue;
    const std::uint32_t g = quaternion::symmetric_matching(field[mesh::TetrahedralConnectivity::tetrahedron_of(face)],
                                                           field[mesh::TetrahedralConnectivity::tetrahedron_of(other)]);
    result[face] = static_cast<std::uint8_t>(g);
    result[other] = cube_group.inverse[g];
  }
  return result;
}

SingularGraph singular_graph(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                             std::span<const Quaternion> field, std::span<const std::uint8_t> matchings,
                             const base::Host& host) {
  return singular_graph(positions, connectivity, mesh::EdgeRings(connectivity, host), field, matchings, host);
}

SingularGraph singular_graph(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                             const mesh::EdgeRings& rings, std::span<const Quaternion> field,
                             std::span<const std::uint8_t> matchings, const base::Host& host) {
  SingularGraph graph(host.memory);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (r % base::items_between_reports == 0) host.report("singular edges", r, rings.size());
    if (rings.on_boundary(r)) continue;
    const mesh::Edge edge = rings.vertices(r);
    const Vector3 along = positions[edge[1]] - positions[edge[0]];
    ++graph.inner_edges;
    const double length = along.norm();
    graph.inner_length += length;
    std::uint8_t rotation = 0;
    for (const Index face : rings.faces(r))
      rotation = cube_group.product[rotation][matchings[face]];
    if (rotation == 0) continue;
    const Index first = mesh::TetrahedralConnectivity::tetrahedron_of(rings.faces(r)[0]);
    graph.edges.push_back(
        {edge, first, rotation, turn_about(rings.faces(r), rotation, along, field, matchings), length});
    graph.singular_length += length;
    ++graph.by_class[static_cast<std::size_t>(graph.edges.back().kind())];
  }
  const auto on_boundary = connectivity.boundary_vertices(host.memory);
  const Incidence incidence(graph.edges, host.memory);
  incidence.for_each_vertex([&](Index vertex, std::span<const Incidence::End> ends) {
    if (on_boundary[vertex] != 0)
      ++graph.boundary_ends;
    else if (ends.size() == 1)
      graph.dead_ends.push_back(vertex);
    else if (ends.size() > 2)
      graph.nodes.push_back(vertex);
  });
  trace_curves(incidence, on_boundary, graph, host.memory);
  return graph;
}

}  // namespace orbicube::frame_field
