// A patch refined to the density of its surroundings (Liepa 2003, section 4): triangles split at their centroids where
// the edges around are shorter, and edges flipped to the locally Delaunay ones.
#pragma once

#include <span>

#include "repair/types.h"

namespace orbicube::repair {

struct Patch {
  explicit Patch(std::pmr::memory_resource* memory) : points(memory), scales(memory), triangles(memory) {}

  std::size_t loop_size = 0;  // the first points: those of the hole's boundary
  Array<Vector3> points;
  Array<double> scales;  // the mean length of edges to have at each point
  Array<Triangle> triangles;
};

// Splits and flips; the points of the loop and its edges stay. `connected`: pairs i, j of points of the loop, i < j,
// that an edge outside of the patch connects; sorted. At most 100 points more than the loop has, times its own number,
// are added. Throws Error "cancelled".
void refine(Patch& patch, std::span<const std::array<Index, 2>> connected, const base::Host& host);

}  // namespace orbicube::repair
