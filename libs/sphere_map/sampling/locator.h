// The inverse of a map to the sphere: which triangle a direction lies in, and where in it.
//
// A walk from triangle to triangle (Devillers, Pion and Teillaud, Walking in a triangulation, 2002) that starts near
// the direction: a grid over the six faces of a cube, whose cells are cut in four for as long as they have more than a
// few vertices, says where. Each turn of the walk is the exact sign of a determinant, so that what is returned does not
// depend on the way there. The walk turns at pseudo-random edges; one that is too long after all gives way to a look at
// each triangle.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/topology/connectivity.h"
#include "sphere_map/optimization/pieces.h"
#include "sphere_map/sampling/triangle_walk.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

// Throws Error "invalid-argument" unless the direction is finite and not zero; `what` and the number go to the message.
void require_direction(const Vector3& direction, const char* what, std::size_t number);

// Where the ray along a direction meets the flat triangle of the map: at the corners' directions with these weights,
// which are not negative and sum up to 1.
struct Location {
  Index triangle;
  Vector3 weights;
};

// Queries may be made from several threads at once.
class Locator {
 public:
  // Keeps views of both arrays. The map must be a bijection: every triangle positive, exactly, or every triangle
  // negative. Directions are near unit length (between 0.5 and 2). Vertices in no triangle take no part.
  // O(n) time for maps that are not uneven beyond measure; about 30 bytes a vertex.
  // Throws Error: "invalid-argument" for an index out of range, a direction that is zero or not finite, or a map that
  // is no bijection; "not-closed"; those of mesh::Connectivity; "cancelled".
  Locator(std::span<const Triangle> triangles, std::span<const Vector3> directions, const base::Host& host);

  // Every direction lies in exactly one triangle: of those that it is in or on the border of, the lowest. The direction
  // is finite, not zero, of any length, and taken as exactly what it is; a weight is 0 when it lies exactly on the
  // opposite edge's plane. O(1) on average for directions spread like the vertices or evenly.
  Location locate(const Vector3& direction) const;

  // visit(i, locate(queries[i])) for each query, on the threads of the host. Throws Error "invalid-argument" for a
  // query that is zero or not finite, "cancelled".
  template <class Visit>
  void for_each_location(std::span<const Vector3> queries, const base::Host& host, const Visit& visit) const {
    for_each_in_pieces(queries.size(), "locating", host, [&](std::size_t i) {
      require_direction(queries[i], "query", i);
      visit(i, locate(queries[i]));
    });
  }

  // Whether triangles are counter-clockwise on the sphere; a mirrored map has them clockwise.
  bool positive() const { return orientation_ > 0; }
  std::span<const Triangle> triangles() const { return triangles_; }
  std::span<const Vector3> directions() const { return directions_; }

  // A place on the cube from -1 to 1: the face, and coordinates on it from 0 to 2^52.
  struct CubePoint {
    unsigned face;
    std::uint64_t x, y;
  };

 private:
  struct Leaf {
    Index cell;
    Vector3 middle;
  };

  // A cell 2^bits wide, and which of the sorted vertices it holds.
  struct Cell {
    Index number;
    CubePoint corner;
    unsigned bits;
    std::size_t begin, end;
  };

  void require_bijection(const base::Host& host);
  void make_grid(std::size_t count);
  void build_cells(const base::Host& host);
  void split(const Cell& at, std::span<CubePoint> sorted, Array<Cell>& open);
  void fill_leaves(std::span<const Leaf> leaves, const base::Host& host);
  std::size_t cell_of(const CubePoint& p) const;
  Index start_near(const Vector3& direction) const;
  int side(Index half_edge, const Vector3& direction) const;
  WalkEnd walk(const Vector3& direction, Index start) const;
  Index lowest(const WalkEnd& found) const;

  std::span<const Triangle> triangles_;
  std::span<const Vector3> directions_;
  mesh::Connectivity connectivity_;
  int orientation_ = 1;  // -1 when every triangle is negative
  std::size_t longest_walk_;

  unsigned level_ = 0;  // each face of the cube has 2^level_ x 2^level_ cells
  // A triangle to start from or, with the highest bit, the place of the first of four children.
  Array<Index> cells_;
};

}  // namespace orbicube::sphere_map
