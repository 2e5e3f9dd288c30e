// The boundary of a mesh of hexahedra as quads with half-edges, and the hexahedron behind each quad.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"
#include "mesh/topology/circulate.h"

namespace orbicube::hexmesh {

// A face of a hexahedron, as seen from outside of the first, and the hexahedron beyond it.
struct HexFace {
  Quad quad{};
  Index first = no_index, second = no_index;  // no second one on the boundary
};

// Returns the faces of the chosen hexahedra (all, where `chosen` is empty), each once; faces that they share with
// others count as boundary. In ascending order of the lowest vertex. O(n).
Array<HexFace> faces_of(std::span<const Hexahedron> hexahedra, std::size_t vertices, std::span<const Index> chosen,
                        const base::Host& host);

// Half-edge 4 q + k goes from corner k of quad q to the next.
class BoundaryQuads {
 public:
  // Throws Error "no-valid-result" where the boundary is no manifold.
  BoundaryQuads(std::span<const Hexahedron> hexahedra, std::size_t vertices, const base::Host& host);

  std::span<const Quad> quads() const { return quads_; }
  Index owner(Index quad) const { return owners_[quad]; }
  std::span<const Index> vertices() const { return vertices_; }  // of the boundary, ascending
  std::size_t vertex_limit() const { return outgoing_.size(); }

  Index start(Index h) const { return quads_[h / 4][h % 4]; }
  Index end(Index h) const { return quads_[h / 4][(h + 1) % 4]; }
  Index opposite(Index h) const { return opposite_[h]; }
  // The next half-edge out of the same vertex, counter-clockwise seen from outside: beyond the quad of `h`.
  Index turned(Index h) const { return opposite_[h % 4 == 0 ? h + 3 : h - 1]; }
  // The half-edge from one vertex to a neighbor; no_index where there is none.
  Index find(Index from, Index to) const;

  // Calls visit(half_edge) for those out of a vertex, counter-clockwise.
  template <class Visit>
  void for_each_outgoing(Index vertex, const Visit& visit) const {
    mesh::circulate(
        outgoing_[vertex], [&](Index h) { return turned(h); }, visit);
  }
  std::size_t valence(Index vertex) const {
    std::size_t count = 0;
    for_each_outgoing(vertex, [&](Index) { ++count; });
    return count;
  }

 private:
  Array<Quad> quads_;
  Array<Index> owners_, vertices_;
  Array<Index> opposite_, outgoing_;
};

}  // namespace orbicube::hexmesh
