// An order of equally good steps that depends on geometry alone.
#pragma once

#include <span>

#include "sphere_map/hierarchy/vertex_rings.h"

namespace orbicube::sphere_map {

using mesh::Vector3;

// What decides among equally good steps: the numbers of the vertices, or geometry.
enum class Ties { by_number, by_geometry };

// A factor near 1 for each point of space, which turns and moves with a surface: quadratic about the centroid of the
// surface, along axes that the moments of third order determine. Where steps of a decimation cost the same, as on grids
// and on both sides of a mirror plane, the factors decide, and neither the numbers of the vertices nor rounding do.
// A surface with a center of symmetry has no such axes: its distances from the centroid decide.
class TieBreaker {
 public:
  TieBreaker() = default;  // 1 everywhere
  TieBreaker(std::span<const Vector3> positions, const VertexRings& rings, const base::Host& host);

  double operator()(const Vector3& position) const {
    const Vector3 x = position - centroid_;
    return 1 + x.dot(slope_) + curvature_ * x.squaredNorm();
  }

 private:
  Vector3 centroid_ = Vector3::Zero();
  Vector3 slope_ = Vector3::Zero();
  double curvature_ = 0;
};

}  // namespace orbicube::sphere_map
