// One triangulation of the sphere with the vertices of several maps: that of the first map, into whose triangles the
// vertices of the others are inserted one by one.
//
// The edges of the first stay, so that its surface does; inside of its triangles edges are flipped until they are
// Delaunay (Lawson 1977), and then to be edges of the other maps wherever the two triangles at an edge allow that.
// Signs of determinants are exact: each triangle is positive.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

// A map on the common sphere, positive.
struct PlacedMap {
  std::span<const Vector3> directions;  // near unit length
  std::span<const Triangle> triangles;
};

struct Overlay {
  explicit Overlay(std::pmr::memory_resource* memory)
      : directions(memory), triangles(memory), vertex_of(memory), edges_of_others(0), edges_present(0) {}

  Array<Vector3> directions;  // those of the first map come first, in its order
  Array<Triangle> triangles;
  Array<Array<Index>> vertex_of;  // one a further map: where each of its vertices is; no_index for one in no triangle
  std::size_t edges_of_others;    // of the further maps,
  std::size_t edges_present;      // and how many of these are edges of the result
};

// Vertices at exactly one direction become one. O(n log n) for n vertices in all, as a rule.
// Throws Error: what Locator does for the first map; "invalid-argument" for a direction that is zero or not finite, or
// an index that is out of range; "cancelled".
Overlay overlay(const PlacedMap& first, std::span<const PlacedMap> others, const base::Host& host);

}  // namespace orbicube::sphere_map
