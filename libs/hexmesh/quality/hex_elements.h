// The elements of a mesh of hexahedra while it is smoothed: the tetrahedra at the corners of each, those along the
// edges of twisted ones, and the shapes and weights of them all.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"
#include "untangle/tetrahedra/elements.h"

namespace orbicube::hexmesh {

using untangle::Element;

class HexElements {
 public:
  // Keeps references. Shapes must be set before the elements are used.
  HexElements(const HexMesh& mesh, const base::Host& host);

  std::size_t size() const { return elements_.size(); }
  const Array<Element>& all() const { return elements_; }

  // Makes a box the target shape of every hexahedron: a cube of edges 1 where `own` is 0, one of its own mean lengths
  // where `own` is 1. The last `padding` hexahedra are the layer at the boundary, which is thinner.
  void set_shapes(double own, std::size_t padding);
  // Raises the weights of elements that are not good enough, up to `max_weight`, and lowers them again once they are.
  void set_weights(double max_weight);

  // Returns the hexahedra without elements along edges whose determinant is at most `least` somewhere.
  Array<Index> find_twisted(double least) const;
  // Adds the elements along the edges of these hexahedra, without shapes.
  void add_edges(std::span<const Index> twisted);
  // Takes the elements again of those hexahedra that were added last whose elements are not all positive.
  void keep_positive_edges(std::span<const Index> twisted);

 private:
  template <class Body>
  void for_tetrahedra(std::size_t hexahedron, const Body& body);

  const HexMesh& mesh_;
  const base::Host& host_;
  Array<Element> elements_;  // eight a hexahedron, then those of edges
  Array<Index> edges_;       // of each hexahedron, where those begin if they count
};

}  // namespace orbicube::hexmesh
