// The flow of sphere_warp.h: smooth velocities on the sphere that move landmarks along great circles.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;
using mesh::Vector3;

class LandmarkFlow {
 public:
  // Unit vectors, from[i] to to[i], during the times 0 to 1. Throws Error "no-valid-result" when two landmarks come so
  // near to each other on the way that no smooth field keeps them apart, "cancelled".
  LandmarkFlow(std::span<const Vector3> from, std::span<const Vector3> to, const base::Host& host);

  // Moves the points (unit vectors) from time 0 to 1, by Runge and Kutta's method of order four. On the threads of the
  // host. O(points * landmarks * steps).
  void move(std::span<Vector3> points, const base::Host& host) const;

  std::size_t steps() const { return steps_; }

 private:
  struct Source {
    Vector3 at, strength;
  };

  Vector3 landmark(std::size_t i, double time) const;
  Vector3 landmark_velocity(std::size_t i, double time) const;
  Vector3 velocity(std::span<const Source> sources, const Vector3& point) const;
  double kernel(const Vector3& a, const Vector3& b) const;
  double nearest_on_the_way() const;
  void solve(double time, std::span<Source> sources) const;

  Array<Vector3> from_, along_;  // the great circles: from_ cos(angle t) + along_ sin(angle t)
  Array<double> angle_;
  double inverse_square_reach_ = 1;  // of the kernel's narrower part
  std::size_t steps_ = 0;
  Array<Source> sources_;  // at the times k / (2 steps), one after the other
};

}  // namespace orbicube::sphere_map
