// What is nearest to a point: a vertex of a point set, or a point of a surface.
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/search/bounding_volume_tree.h"

namespace orbicube::mesh {

// The point of a triangle that is nearest to p, with its weights at the three corners (none negative, sum 1).
struct TrianglePoint {
  Vector3 position;
  Vector3 weights;
};
// Flat triangles are fine. Coordinates must be so that their squares are in the range of double.
TrianglePoint nearest_on_triangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c);

// Searches among points. Keeps a view of them. Squares of the coordinates must be in the range of double. Queries may
// be made from several threads at once.
class VertexSearch {
 public:
  VertexSearch(std::span<const Vector3> positions, const base::Host& host);

  // The nearest vertex, the lowest of equals; no_index when there is none. O(log n) on average.
  Index nearest(const Vector3& p) const;

  // visit(vertex) for each vertex at most `radius` away, in no particular order.
  template <class Visit>
  void for_each_within(const Vector3& p, double radius, const Visit& visit) const {
    tree_.for_each_within(p, radius * radius, [&](Index v) {
      if ((positions_[v] - p).squaredNorm() <= radius * radius) visit(v);
    });
  }

 private:
  std::span<const Vector3> positions_;
  BoundingVolumeTree tree_;
};

struct SurfacePoint {
  Index triangle = no_index;  // none on a surface without triangles, or where the square of the distance overflows
  Vector3 position = Vector3::Zero();
  Vector3 weights = Vector3::Zero();  // at the corners of the triangle
  double distance = std::numeric_limits<double>::infinity();
};

// Searches a surface. Keeps views of both arrays; what is said of VertexSearch holds here too.
class SurfaceSearch {
 public:
  SurfaceSearch(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host);

  // The nearest point of the surface, in the lowest of the triangles that have it. O(log n) on average. Of a triangle
  // that may be near, as one of a nearby point's, less is looked at.
  SurfacePoint nearest(const Vector3& p, Index may_be_near = no_index) const;
  // The same among triangles with accept(triangle) only, and none beyond `limit`.
  template <class Accept>
  SurfacePoint nearest_of(const Vector3& p, const Accept& accept,
                          double limit = std::numeric_limits<double>::infinity()) const {
    double least = limit * limit;
    const auto distance = [&](Index t) {
      if (box_of(t).squared_distance(p) > least || !accept(t)) return std::numeric_limits<double>::infinity();
      const double d = squared_distance(t, p);
      least = std::min(least, d);
      return d;
    };
    return point_of(tree_.nearest(p, distance, {no_index, limit * limit}), p);
  }
  // How far a triangle is.
  double distance(Index triangle, const Vector3& p) const { return std::sqrt(squared_distance(triangle, p)); }

 private:
  TrianglePoint on(Index triangle, const Vector3& p) const;
  SurfacePoint point_of(const BoundingVolumeTree::Nearest& found, const Vector3& p) const;
  Box box_of(Index triangle) const;
  double squared_distance(Index triangle, const Vector3& p) const {
    return (on(triangle, p).position - p).squaredNorm();
  }

  std::span<const Vector3> positions_;
  std::span<const Triangle> triangles_;
  BoundingVolumeTree tree_;
};

// The boxes of the triangles, one each.
Array<Box> boxes_of(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host);

}  // namespace orbicube::mesh
