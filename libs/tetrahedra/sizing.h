// How long edges should be where: lengths given at some points, from each of which they grow in proportion to the
// distance. The minimum of what all points allow is as smooth as that growth, whatever was given.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/search/bounding_volume_tree.h"

namespace orbicube::tetrahedra {

// A length that edges should have at a place.
struct SizePoint {
  mesh::Vector3 position;
  double length;
};

class Sizing {
 public:
  // `growth` is how much longer edges may get in each unit of distance. Points and lengths must be finite, lengths
  // positive, squares of the coordinates in the range of double. O(n log n).
  Sizing(std::span<const SizePoint> points, double growth, std::pmr::memory_resource* memory);

  bool empty() const { return points_.empty(); }

  // The minimum length + growth * distance over all points; infinite without points. O(log n) where lengths differ by
  // about what growth allows.
  double length_at(const mesh::Vector3& place) const;

 private:
  // Of a tree in which the first child follows its parent.
  struct Node {
    mesh::Box box;
    double shortest;    // of the lengths below
    mesh::Index begin;  // of the points of a leaf, else the second child
    mesh::Index count;  // of the points; 0 where there are children
  };
  mesh::Index add_node(mesh::Index begin, mesh::Index end);
  double least(const Node& node, const mesh::Vector3& place) const;

  base::Array<SizePoint> points_;
  base::Array<Node> nodes_;
  double growth_;
};

}  // namespace orbicube::tetrahedra
