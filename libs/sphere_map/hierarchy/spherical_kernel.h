// The spherical kernel of a ring: the points of the sphere that see the whole ring counter-clockwise.
#pragma once

#include <optional>
#include <span>

#include "base/array.h"
#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;
using mesh::Vector3;

// A convex polygon in a tangent plane of the sphere. Kept between calls, so that no call allocates once it has grown.
class KernelPolygon {
 public:
  explicit KernelPolygon(std::pmr::memory_resource* memory) : corners_(memory), clipped_(memory) {}

  // Room for the kernels of rings of up to the given number of vertices.
  void reserve(std::size_t ring_size) {
    corners_.reserve(ring_size + 4);
    clipped_.reserve(ring_size + 4);
  }

  // Cuts the kernel of `ring` out of the tangent plane at `origin` by the great circles of the ring's edges, which are
  // lines there. `through` is a vertex of the ring that lies at the origin, or no_index. Returns false when nothing is
  // left.
  bool cut(std::span<const Index> ring, std::span<const Vector3> directions, const Vector3& origin, Index through);

  // Of the polygon, as unit vectors; after cut() has returned true. The centroid of a polygon without area is nothing.
  std::optional<Vector3> area_centroid() const;
  // The mean of the corners, pulled towards the origin of the chart by `factor`.
  Vector3 corner_mean(double factor) const;

 private:
  void clip(double offset, const Eigen::Vector2d& slope);
  Vector3 lift(const Eigen::Vector2d& x) const;

  Vector3 origin_, first_, second_;  // of the chart
  double reach_ = 1;                 // chart coordinates are in units of this
  Array<Eigen::Vector2d> corners_;
  Array<Eigen::Vector2d> clipped_;
};

// A point of the kernel of `ring`, near its centroid, for a vertex that is split from `kept`, a vertex of the ring
// (Praun and Hoppe 2003). Every triangle that it makes with the ring is safely positive (distortion.h). Nothing is
// returned when no such point was found.
std::optional<Vector3> kernel_centroid(std::span<const Index> ring, Index kept, std::span<const Vector3> directions,
                                       KernelPolygon& polygon);

}  // namespace orbicube::sphere_map
