// A mesh of triangles or tetrahedra whose edges, faces or elements are split at new vertices (stellar subdivision). It
// stays conforming, each element lies in one of the mesh before, its parent, and so does each vertex, at weights of
// that one's vertices.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "untangle/types.h"

namespace orbicube::untangle {

// Where a vertex lies in the mesh before: a mean of some vertices of one element; no_index with weight 0 for the rest.
template <std::size_t corners>
struct Origin {
  std::array<Index, corners> vertices;
  std::array<double, corners> weights;

  // The same mean of what the vertices have.
  template <class Vector>
  Vector mean(std::span<const Vector> of) const {
    Vector sum = weights[0] * of[vertices[0]];
    for (std::size_t k = 1; k < corners && vertices[k] != no_index; ++k)
      sum += weights[k] * of[vertices[k]];
    return sum;
  }
};

template <std::size_t corners>
class SplitMesh {
 public:
  using Element = std::array<Index, corners>;

  SplitMesh(std::span<const Element> elements, std::size_t vertices, std::pmr::memory_resource* memory);

  // Adds a vertex in the middle of an edge, a face or an element with these vertices and splits all elements around it.
  // One part of each keeps its number, others are added at the end. Returns the vertex. Takes time in proportion to the
  // elements at that one of the vertices that has the fewest.
  Index split(std::span<const Index> simplex);

  std::span<const Element> elements() const { return elements_; }
  std::span<const Index> parents() const { return parents_; }
  std::span<const Origin<corners>> origins() const { return origins_; }
  std::size_t vertices() const { return origins_.size(); }
  std::span<const Index> around(Index vertex) const { return around_[vertex]; }  // elements

 private:
  Origin<corners> middle_of(std::span<const Index> simplex) const;

  Array<Element> elements_;
  Array<Index> parents_;
  Array<Origin<corners>> origins_;
  std::pmr::vector<Array<Index>> around_;
};

extern template class SplitMesh<3>;
extern template class SplitMesh<4>;

// Splits edges, then faces, then elements that are not in the boundary and of which all vertices are marked: no
// positions of the other vertices change them. Returns how many. O(n log n).
template <std::size_t corners>
std::size_t split_marked(SplitMesh<corners>& mesh, std::span<const std::uint8_t> marked, const base::Host& host);

// Splits those edges of the given elements that are not in the boundary. Returns how many. O(n log n).
template <std::size_t corners>
std::size_t split_edges_of(SplitMesh<corners>& mesh, std::span<const Index> elements, const base::Host& host);

// Edges with ascending vertices that are not in the boundary, sorted. O(n log n).
template <std::size_t corners>
Array<std::array<Index, 2>> inner_edges(std::span<const std::array<Index, corners>> elements, const base::Host& host);

extern template std::size_t split_marked<3>(SplitMesh<3>&, std::span<const std::uint8_t>, const base::Host&);
extern template std::size_t split_marked<4>(SplitMesh<4>&, std::span<const std::uint8_t>, const base::Host&);
extern template std::size_t split_edges_of<3>(SplitMesh<3>&, std::span<const Index>, const base::Host&);
extern template std::size_t split_edges_of<4>(SplitMesh<4>&, std::span<const Index>, const base::Host&);
extern template Array<std::array<Index, 2>> inner_edges<3>(std::span<const Triangle>, const base::Host&);
extern template Array<std::array<Index, 2>> inner_edges<4>(std::span<const Tetrahedron>, const base::Host&);

}  // namespace orbicube::untangle
