// One triangulation of the sphere with the vertices of several maps: that of the first map, into whose triangles the
// vertices of the others are inserted one by one.
//
// The edges of the first stay, so that its surface does; inside of its triangles edges are flipped until they are
// Delaunay (Lawson 1977), and then to be edges of the other maps wherever the two triangles at an edge allow that.
// Signs of determinants are exact: each triangle is positive. Edges of the first may be halved, which leaves its
// surface as it is.
#pragma once

#include <functional>
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

  // Those of the first map come first, in its order; those of refinement come last.
  Array<Vector3> directions;
  Array<Triangle> triangles;
  Array<Array<Index>> vertex_of;  // one a further map: where each of its vertices is; no_index for one in no triangle
  std::size_t edges_of_others;    // of the further maps,
  std::size_t edges_present;      // and how many of these are edges of the result
};

// Where edges miss something of what the triangulation is for, they are halved.
struct Refinement {
  // How much the edge between two directions misses; more than 1 is too much.
  std::function<double(const Vector3& a, const Vector3& b)> error;
  std::size_t max_vertices;  // that there may be in the end
};

// Vertices at exactly one direction become one. O(n log n) for n vertices in all, as a rule.
// Throws Error: what Locator does for the first map; "invalid-argument" for a direction that is zero or not finite, or
// an index that is out of range; "cancelled".
Overlay overlay(const PlacedMap& first, std::span<const PlacedMap> others, const base::Host& host,
                const Refinement* refinement = nullptr);

}  // namespace orbicube::sphere_map
