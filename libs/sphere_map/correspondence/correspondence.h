// A shape on a triangulation of the common sphere: where each of its vertices is on the shape.
#pragma once

#include <span>

#include "base/host.h"
#include "sphere_map/correspondence/alignment.h"
#include "sphere_map/sampling/locator.h"

namespace orbicube::sphere_map {

struct CarriedShape {
  explicit CarriedShape(std::pmr::memory_resource* memory) : positions(memory), directions(memory) {}

  Array<Vector3> positions;   // of the shape, one a vertex of the triangulation
  Array<Vector3> directions;  // on the shape's own sphere
  std::size_t flipped = 0;    // triangles that are not positive there, exactly: 0 where the warp is resolved
};

// `own_vertex` says which vertices of the triangulation are vertices of the shape, whose positions are then taken as
// they are: one a vertex, no_index for the others, or nothing. On the threads of the host.
// Throws Error "invalid-argument" on sizes and for directions that are zero or not finite, "cancelled".
CarriedShape carry_over(const Locator& map, std::span<const Vector3> positions, const Alignment& alignment,
                        std::span<const Vector3> common, std::span<const Triangle> common_triangles,
                        std::span<const Index> own_vertex, const base::Host& host);

// The directions of a shape's map on the common sphere. On the threads of the host. Throws Error "invalid-argument",
// "cancelled".
Array<Vector3> place(std::span<const Vector3> directions, const Alignment& alignment, const base::Host& host);

// How much an edge of a triangulation of the common sphere misses of the shapes on it, for overlay.h: how far what
// shapes have along it lies from the straight line between what they have at its ends.
class EdgeError {
 public:
  struct Shape {
    const Locator* map;
    std::span<const Vector3> positions;
    const Alignment* alignment;
  };
  // Errors are in parts of the diagonal of each shape's bounding box, over `tolerance`. Keeps views.
  EdgeError(std::span<const Shape> shapes, double tolerance);

  // The largest of three points between a and b, directions on the common sphere, and of all shapes.
  double operator()(const Vector3& a, const Vector3& b) const;

 private:
  Array<Shape> shapes_;
  Array<double> scale_;
};

}  // namespace orbicube::sphere_map
