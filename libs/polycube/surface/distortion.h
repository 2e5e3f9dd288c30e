// How much a polycube map changes angles and areas.
#pragma once

#include <span>

#include "base/host.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

// Both are 1 for an isometry and more otherwise, measured after scaling the polycube to the area of the surface:
// angle (cot a |a|^2 + cot b |b|^2 + cot c |c|^2) / (4 area), angles of the surface and sides on the polycube; area
// (r + 1/r) / 2 for the ratio r of areas. Means over triangles, and over the surface. Triangles that are degenerate in
// space (mesh/topology/degenerate_triangles.h) or have no area on the polycube are left out: the angles of the former
// are those of rounding, and so is how much of the polycube they cover, so that their areas do not enter the scale
// either. Scaling both by powers of two changes no bit.
struct Distortion {
  double angle_mean = 0, area_mean = 0;
  double angle_weighted_mean = 0, area_weighted_mean = 0;
  std::size_t left_out = 0;  // triangles
};

// What the means are of, for one triangle. `angle` is 0 for triangles that are left out, and all is 0 for those that
// are degenerate in space.
struct TriangleChange {
  double area, area_on_polycube, angle;
};

// The rounding unit (mesh/topology/degenerate_triangles.h) of the vertices of the input; what was added has more
// digits.
double rounding_of_input(const SurfaceMap& map);

// Measures triangles of a map, which is kept, in units in which both of its surfaces are about 1 wide.
class TriangleMeasure {
 public:
  explicit TriangleMeasure(const SurfaceMap& map);
  TriangleChange operator()(const Triangle& t) const;

 private:
  const SurfaceMap& map_;
  double scale_in_space_, scale_on_polycube_;
  double rounding_;  // of the coordinates of the input
};

Distortion measure_distortion(const SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::polycube
