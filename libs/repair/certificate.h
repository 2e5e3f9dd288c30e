// What a surface is after its repair, and how far it is from the one before.
#pragma once

#include <cstdint>
#include <span>

#include "repair/types.h"

namespace orbicube::repair {

struct Certificate {
  bool closed = false;
  bool manifold = false;
  bool oriented = false;  // each edge is passed once in each direction
  std::size_t parts = 0;
  std::int64_t genus = 0;  // sum over the parts of a closed, oriented manifold; else 0
  std::size_t boundary_loops = 0;
  std::size_t non_manifold_edges = 0, non_manifold_vertices = 0;
  std::size_t inconsistent_edges = 0;
  std::size_t zero_area_faces = 0;
  // Pairs of triangles that have a point in common besides what they share, by exact arithmetic; at most max_pairs are
  // counted, and none where the search was not requested.
  std::size_t self_intersections = 0;
  Index first_intersection = no_index;  // the lower triangle of the first pair
  double area = 0, volume = 0;

  bool is_solid() const { return closed && manifold && oriented; }
};

inline constexpr std::size_t max_pairs = 10'000;

// O(n log n). Throws Error "cancelled".
Certificate certify(std::span<const Vector3> positions, std::span<const Triangle> triangles, bool intersections,
                    const base::Host& host);

struct Move {
  double from_input = 0;   // largest distance of triangles that are gone or moved from the result
  double from_result = 0;  // largest distance of triangles that moved from the input
  double patches = 0;      // largest distance of triangles without source, those of patches, from the input
};

// Measures the two-sided distance from the triangles that are in one surface only to the other surface, at their
// vertices and centroids: 0 where nothing changed. `counted`: for each triangle of the input, whether it counts. O(n
// log n). Throws Error "cancelled".
Move measure_move(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                  std::span<const std::uint8_t> counted, const Soup& result, const base::Host& host);

}  // namespace orbicube::repair
