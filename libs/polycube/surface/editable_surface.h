// A closed surface as half-edges on flat arrays, whose edges and triangles can be split and whose vertices can be
// collapsed into a neighbor and split off again. The drawing of a layout is kept on it: which half-edges lie on which
// arc, which vertices are on arcs.
#pragma once

#include "mesh/topology/circulate.h"
#include "mesh/topology/connectivity.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

class EditableSurface {
 public:
  // The triangles must be a closed oriented manifold. Keeps vertices that are in no triangle.
  EditableSurface(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host);

  std::size_t vertices() const { return position.size(); }
  std::size_t faces() const { return triangle.size(); }
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index start(Index h) const { return triangle[h / 3][h % 3]; }
  Index end(Index h) const { return start(next(h)); }
  Index opposite(Index h) const { return opposite_[h]; }
  Index outgoing(Index v) const { return outgoing_[v]; }
  // The next half-edge out of the same vertex, counter-clockwise.
  Index turned(Index h) const { return opposite_[previous(h)]; }
  // The half-edge from a to b; no_index when there is none.
  Index between(Index a, Index b) const;
  double length(Index h) const { return (position[end(h)] - position[start(h)]).norm(); }
  bool alive(Index face) const { return !dead_[face]; }

  // visit(half_edge) for each half-edge out of the vertex, counter-clockwise.
  template <class Visit>
  void for_each_outgoing(Index v, const Visit& visit) const {
    mesh::circulate(
        outgoing_[v], [&](Index h) { return turned(h); }, visit);
  }

  void draw(Index h, Index on_arc) { arc[h] = arc[opposite_[h]] = on_arc; }

  // A new vertex on the edge, `part` of the way; its source is that of the triangles beside it. Returns the vertex.
  Index split_edge(Index h, double part);
  // A new vertex in the middle of the triangle.
  Index split_face(Index face);

  // start(h) goes into end(h). May be done when can_collapse(h); the conditions on arcs are the caller's business.
  bool can_collapse(Index h) const;
  void collapse(Index h);
  // Takes the last collapse that is not undone back.
  void undo_collapse(Index h);

  // Of each vertex.
  Array<Vector3> position;
  Array<VertexSource> source;
  Array<std::uint8_t> occupied;  // on an arc, or a node
  // Of each face.
  Array<Triangle> triangle;
  Array<Index> triangle_source;
  // Of each half-edge.
  Array<Index> arc;  // no_index when it is on none

 private:
  Index add_vertex(const Vector3& at, const VertexSource& from);
  Index add_face(const Triangle& corners, Index from);
  void join(Index a, Index b) {
    opposite_[a] = b;
    opposite_[b] = a;
  }

  Array<Index> opposite_, outgoing_;
  Array<std::uint8_t> dead_;
};

// Returns the map of the faces that are alive, with positions on the polycube of each vertex, patches of each face, and
// label_of(face). Vertices of the input stay where they are, those that were added close up.
template <class LabelOf>
SurfaceMap map_of(const EditableSurface& surface, std::span<const Vector3> on_polycube, std::span<const Index> patches,
                  const LabelOf& label_of, std::pmr::memory_resource* memory) {
  SurfaceMap map(memory);
  Array<Index> number(surface.vertices(), no_index, memory);
  for (Index v = 0; v < surface.vertices(); ++v) {
    if (surface.outgoing(v) == no_index && surface.source[v].corner[1] != no_index) continue;
    number[v] = static_cast<Index>(map.positions.size());
    map.positions.push_back(surface.position[v]);
    map.vertex_sources.push_back(surface.source[v]);
    map.polycube.push_back(on_polycube[v]);
  }
  for (Index f = 0; f < surface.faces(); ++f) {
    if (!surface.alive(f)) continue;
    const auto& [a, b, c] = surface.triangle[f];
    map.triangles.push_back({number[a], number[b], number[c]});
    map.triangle_sources.push_back(Index{surface.triangle_source[f]});
    map.labels.push_back(AxisLabel{label_of(f)});
    map.patches.push_back(Index{patches[f]});
  }
  return map;
}

// a and b are convex combinations within one triangle; so is what is `part` of the way from a to b.
VertexSource between_sources(const VertexSource& a, const VertexSource& b, double part);

}  // namespace orbicube::polycube
