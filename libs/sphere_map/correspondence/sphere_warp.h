// A smooth bijection of the sphere onto itself that carries landmarks onto landmarks.
//
// The landmarks travel on great circles, and take the sphere along in the smooth field of minimum energy that has their
// velocities: a flow, which can flip nothing (Joshi and Miller, Landmark matching via large deformation
// diffeomorphisms, 2000; Glaunes, Vaillant and Miller for the sphere, 2004). It is followed on the vertices of an
// icosphere, some of which are moved onto the landmarks before; between them the warp is the projection of the flat
// triangles. Every triangle is positive before and after, by exact arithmetic: the warp is a bijection whatever was
// rounded.
#pragma once

#include <memory>
#include <span>

#include "base/host.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sampling/grids.h"
#include "sphere_map/sampling/locator.h"

namespace orbicube::sphere_map {

class SphereWarp {
 public:
  // from[i] goes to to[i], to the last bits. Directions of any length.
  // O(vertices of the icosphere * landmarks * steps + landmarks^3 * steps) time.
  // Throws Error: "invalid-argument" for sizes, no landmark, vectors that are zero or not finite, and landmarks nearer
  // than 0.01 to each other; "no-valid-result" when their ways meet; "cancelled".
  SphereWarp(std::span<const Vector3> from, std::span<const Vector3> to, const base::Host& host);

  SphereWarp(const SphereWarp&) = delete;
  SphereWarp& operator=(const SphereWarp&) = delete;

  // Where a direction goes, and where it came from: unit vectors.
  Vector3 forward(const Vector3& direction) const { return through(*at_rest_, moved_, direction); }
  Vector3 backward(const Vector3& direction) const { return through(*when_moved_, rest_.directions, direction); }

  // The warp as a map of the icosphere: what it does to angles and areas, all of them positive.
  Measurement distortion(const base::Host& host) const;
  std::span<const Vector3> rest() const { return rest_.directions; }
  std::span<const Vector3> moved() const { return moved_; }
  std::span<const Triangle> triangles() const { return rest_.triangles; }

 private:
  static Vector3 through(const Locator& locator, std::span<const Vector3> image, const Vector3& direction);

  Grid rest_;
  Array<Vector3> moved_;
  std::unique_ptr<const Locator> at_rest_, when_moved_;  // have views of the arrays above
};

}  // namespace orbicube::sphere_map
