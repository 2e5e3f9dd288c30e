// How much a polycube map changes angles and areas.
#pragma once

#include <span>

#include "base/host.h"
#include "polycube/surface_map.h"

namespace orbicube::polycube {

// Both are 1 for an isometry and more otherwise, measured after scaling the polycube to the area of the surface:
// angle (cot a |a|^2 + cot b |b|^2 + cot c |c|^2) / (4 area), angles of the surface and sides on the polycube; area
// (r + 1/r) / 2 for the ratio r of areas. Means over triangles, and over the surface. Triangles without area are left
// out.
struct Distortion {
  double angle_mean = 0, area_mean = 0;
  double angle_weighted_mean = 0, area_weighted_mean = 0;
};

// What the means are of, for one triangle. `angle` is 0 where one of the areas is.
struct TriangleChange {
  double area, area_on_polycube, angle;
};
TriangleChange measure_triangle(const SurfaceMap& map, const Triangle& t);

Distortion measure_distortion(const SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::polycube
