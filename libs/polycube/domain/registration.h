// How one shape is bent to another of its kind: points spread over both move together as a smooth field moves one
// set (coherent point drift, Myronenko and Song 2010, "Point Set Registration: Coherent Point Drift"). A guide for
// drawings, no map of surfaces.
#pragma once

#include <span>

#include "polycube/layout/scattered_map.h"

namespace orbicube::polycube {

// A surface by references to the caller's arrays.
struct SurfaceSpan {
  std::span<const Vector3> positions;
  std::span<const mesh::Triangle> triangles;
};

// Points of two shapes that belong together.
struct PointPair {
  Vector3 first, second;
};

// The map of space that takes `from` to about `to`: turned by quarter turns, of coordinates or of principal axes, where
// that fits better, or, with four pairs and more, by the map through these; then drift. Deterministic. O(points^3) for
// some hundred points. Throws Error "cancelled".
ScatteredMap bend_shape(const SurfaceSpan& from, const SurfaceSpan& to, std::span<const PointPair> pairs,
                        const base::Host& host);

}  // namespace orbicube::polycube
