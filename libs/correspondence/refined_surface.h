// Points of a surface whose triangles a map has split: from the triangles as they were given to their pieces, and back.
#pragma once

#include <span>

#include "base/grouping.h"
#include "base/host.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::correspondence {

// A point of a triangle, by its weights at the corners: not negative, sum 1.
struct TrianglePoint {
  mesh::Index triangle = mesh::no_index;
  mesh::Vector3 weights = mesh::Vector3::Zero();
};

// Returns the point in space.
inline mesh::Vector3 position_of(const TrianglePoint& point, std::span<const mesh::Triangle> triangles,
                                 std::span<const mesh::Vector3> positions) {
  const mesh::Triangle& t = triangles[point.triangle];
  return point.weights[0] * positions[t[0]] + point.weights[1] * positions[t[1]] + point.weights[2] * positions[t[2]];
}

class RefinedSurface {
 public:
  // `given` are the triangles of the caller; `pieces` are those of the map, each with the number of the given one that
  // it lies in, and each vertex with its source (polycube/surface/surface_map.h). A given triangle and its pieces may
  // be oriented differently. Copies everything.
  RefinedSurface(std::span<const mesh::Triangle> given, std::span<const mesh::Triangle> pieces,
                 std::span<const mesh::Index> piece_sources, std::span<const polycube::VertexSource> vertex_sources,
                 const base::Host& host);

  // Returns the same point in a piece. Throws Error "invalid-argument" for no triangle of the given ones, weights that
  // are negative or not finite, or whose sum is not 1 within 1e-6.
  TrianglePoint piece_of(const TrianglePoint& point) const;
  // Returns the same point in a given triangle.
  TrianglePoint given_of(const TrianglePoint& point) const;

  std::span<const mesh::Triangle> given() const { return given_; }
  std::span<const mesh::Triangle> pieces() const { return pieces_; }

 private:
  mesh::Vector3 weights_in(mesh::Index given, mesh::Index vertex) const;

  base::Array<mesh::Triangle> given_, pieces_;
  base::Array<mesh::Index> piece_sources_;
  base::Array<polycube::VertexSource> vertex_sources_;
  base::Groups<mesh::Index, mesh::Index> pieces_of_;  // of each given triangle
};

}  // namespace orbicube::correspondence
