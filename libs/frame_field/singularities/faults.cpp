#include "frame_field/singularities/faults.h"

#include <utility>

#include "frame_field/singularities/meshability.h"

namespace orbicube::frame_field {
namespace {

constexpr std::size_t longest_loop = 6, longest_fragment = 1;  // in edges

}  // namespace

FaultFinder::FaultFinder(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                         const base::Host& host)
    : positions_(positions),
      connectivity_(connectivity),
      host_(host),
      rings_(connectivity, host),
      boundary_(connectivity.boundary_vertices(host.memory)) {}

Structure FaultFinder::find(std::span<const Quaternion> field) const {
  Structure s(host_.memory);
  s.matchings = matchings(connectivity_, field, host_);
  s.graph = singular_graph(positions_, connectivity_, rings_, field, s.matchings, host_);
  const Meshability local = meshability(s.graph, boundary_, host_.memory);
  s.faults = {local.edges.size(), local.vertices.size(), 0};
  for (const Index e : local.edges) {
    const mesh::Edge& v = s.graph.edges[e].vertices;
    s.vertices.insert(s.vertices.end(), v.begin(), v.end());
    s.places.push_back({v[0], 1, 0});
  }
  for (const Index v : local.vertices) {
    s.vertices.push_back(v);
    s.places.push_back({v, 1, 0});
  }
  for (std::size_t c = 0; c < s.graph.curves(); ++c) {
    const auto curve = s.graph.curve(c);
    if (curve.size() > (s.graph.curve_closed[c] != 0 ? longest_loop : longest_fragment)) continue;
    ++s.faults.fragments;
    for (const Index e : curve) {
      const mesh::Edge& v = s.graph.edges[e].vertices;
      s.vertices.insert(s.vertices.end(), v.begin(), v.end());
    }
    s.places.push_back({s.graph.edges[curve[0]].vertices[0], 0, 1});
  }
  return s;
}

Array<std::uint8_t> FaultFinder::around(std::span<const Index> vertices, std::uint32_t rings) const {
  const auto tetrahedra = connectivity_.tetrahedra();
  Array<std::uint8_t> inside(tetrahedra.size(), 0, host_.memory);
  Array<std::uint8_t> reached(positions_.size(), 0, host_.memory);
  for (const Index v : vertices)
    reached[v] = 1;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    host_.report("parts to repair", ring, rings);
    for (Index t = 0; t < inside.size(); ++t) {
      for (const Index v : tetrahedra[t])
        inside[t] |= reached[v];
    }
    for (Index t = 0; t < inside.size(); ++t) {
      if (inside[t] == 0) continue;
      for (const Index v : tetrahedra[t])
        reached[v] = 1;
    }
  }
  return inside;
}

Parts::Parts(const mesh::TetrahedralConnectivity& connectivity, std::span<const std::uint8_t> marked,
             const base::Host& host)
    : sets_(connectivity.vertex_count(), host.memory), change_(connectivity.vertex_count(), Change{}, host.memory) {
  for (Index t = 0; t < marked.size(); ++t) {
    if (marked[t] == 0) continue;
    const Tetrahedron& corners = connectivity.tetrahedra()[t];
    for (const Index v : corners)
      sets_.unite(corners[0], v);
  }
}

void Parts::count(const Structure& before, const Structure& after) {
  for (const auto& [structure, sign] : {std::pair(&before, -1), std::pair(&after, 1)}) {
    for (const Structure::Place& place : structure->places) {
      Change& change = at(place.vertex);
      change.unmeshable += sign * place.unmeshable;
      change.fragments += sign * place.fragments;
    }
  }
}

}  // namespace orbicube::frame_field
