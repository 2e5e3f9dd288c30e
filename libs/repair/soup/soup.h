// Triangles and vertices taken out of a soup.
#pragma once

#include <span>

#include "repair/types.h"

namespace orbicube::repair {

// Returns a copy with the numbers of the input as sources.
Soup soup_of(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host);

// Removes the triangles whose entry of `keep` is 0; the others stay in their order. O(n).
void keep_triangles(Soup& soup, std::span<const std::uint8_t> keep);

// Removes vertices in no triangle and returns their number; the others stay in their order. O(n).
std::size_t drop_unused_vertices(Soup& soup);

struct CleanFigures {
  std::size_t degenerate = 0;  // faces with a repeated corner
  std::size_t duplicate = 0;   // faces on the corners of an earlier one, in any order
};

// Removes such faces. O(n log n). Throws Error "cancelled".
CleanFigures drop_degenerate_and_duplicate(Soup& soup, const Context& context);

// Returns the centroid of a triangle.
Vector3 centroid(const Soup& soup, const Triangle& t);

}  // namespace orbicube::repair
