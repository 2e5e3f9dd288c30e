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

// What a direction becomes when vertex `vertex` is stored and loaded again. Must be deterministic.
using Store = std::function<Vector3(Index vertex, const Vector3& direction)>;

struct RoundedMap {
  Array<Vector3> directions;     // what to store, one a vertex: near unit vectors
  std::size_t moved = 0;         // vertices that had to be moved
  std::size_t not_positive = 0;  // triangles that could not be repaired: 0 when the map is valid as stored
};

// Rounds each direction with `store` and repairs the triangles that rounding turned over or flattened, by moving their
// vertices to nearby points of the grid. Valid (exactly, after storing) when not_positive is 0.
RoundedMap round_and_repair(std::span<const Triangle> triangles, std::span<const Vector3> directions,
                            const Store& store, const base::Host& host);

}  // namespace orbicube::sphere_map
