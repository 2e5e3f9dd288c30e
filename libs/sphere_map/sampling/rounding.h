// Makes a map survive being stored with fewer bits than it was computed with (float32 in GLB, a base plus a delta in a
// morph target): rounded vertices are moved on the coarse grid until every triangle is positive again.
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

// What a direction becomes when vertex `vertex` is stored and loaded again. Must be deterministic and near `direction`.
using Store = std::function<Vector3(Index vertex, const Vector3& direction)>;

// Each coordinate rounded to the nearest float32.
Vector3 rounded_to_float(const Vector3& direction);

struct RoundedMap {
  explicit RoundedMap(std::pmr::memory_resource* memory) : directions(memory) {}

  Array<Vector3> directions;     // as stored, one a vertex: near unit vectors
  std::size_t moved = 0;         // vertices that were moved by more than rounding
  std::size_t not_positive = 0;  // triangles that could not be repaired: 0 when the map is valid as stored
};

// Stores each direction of a valid map of a closed surface and repairs the triangles that this flipped or
// flattened, by moving their vertices to points of the grid where the smallest height of their star is largest. A
// triangle counts as positive when it stays so if each of its vertices moves by `slack` (distance, 0 or more): for
// readers that round again or less than `store` does. Cost: O(n), and then in proportion to what has to be
// repaired.
RoundedMap round_and_repair(std::span<const Triangle> triangles, std::span<const Vector3> directions,
                            const Store& store, double slack, const base::Host& host);

// The directions rounded to float32, as doubles, every triangle safely positive (or all negative, for a map that was).
// Throws Error no-valid-result when float32 cannot represent the map.
Array<Vector3> round_to_float(std::span<const Triangle> triangles, std::span<const Vector3> directions,
                              const base::Host& host);

}  // namespace orbicube::sphere_map
