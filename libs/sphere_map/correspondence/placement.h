// A shape's map brought onto the common sphere, where it stays one to one.
//
// A smooth bijection of the sphere takes directions to directions one to one, but a triangle whose vertices it takes
// along may be flipped where it bends more than the triangle is small. Such triangles are cut in two at the middle
// of their longest edge, which leaves the surface as it is, until the pieces are small enough: the deviation from
// straight falls with the square of their size. What rounding still flips, is mended by moving vertices a little.
// Signs are exact.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

struct Placement {
  explicit Placement(std::pmr::memory_resource* memory)
      : positions(memory),
        own(memory),
        directions(memory),
        triangles(memory),
        triangle_sources(memory),
        parents(memory) {}

  // The same surface, the vertices that it had first, in their order.
  Array<Vector3> positions;
  Array<Vector3> own;         // directions on the shape's own sphere
  Array<Vector3> directions;  // on the common sphere; every triangle is positive
  Array<Triangle> triangles;
  Array<Index> triangle_sources;        // of each triangle, the one that it is a piece of
  Array<std::array<Index, 2>> parents;  // of each added vertex, in order: the ends of the edge that it halves
  std::size_t added = 0;                // vertices on edges that were cut
  std::size_t moved = 0;                // vertices that are not where the bijection takes them
};

// Takes directions, unit vectors, to where they are on the common sphere; each by itself, smoothly.
using SphereMove = std::function<void(std::span<Vector3> directions)>;

// Of a positive map with directions of length 1. Nothing when some triangle stays flipped: the bijection is then
// too much for this map. O(n), and in proportion to what has to be cut. Throws Error "invalid-argument" for sizes,
// "cancelled", and what `move` throws.
std::optional<Placement> placed_one_to_one(std::span<const Vector3> positions, std::span<const Vector3> directions,
                                           std::span<const Triangle> triangles, const SphereMove& move,
                                           const base::Host& host);

}  // namespace orbicube::sphere_map
