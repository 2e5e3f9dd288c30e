// Where the polycube of a cavity belongs within the polycube of the surface around it.
#pragma once

#include "polycube/surface/surface_map.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

// A turn of the cube, then lengths and a shift along each axis.
struct CavityPlacement {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vector3 scale = Vector3::Ones(), shift = Vector3::Zero();

  // Planes across an axis stay such planes, to the bit.
  Vector3 operator()(const Vector3& p) const { return scale.cwiseProduct(turn * p) + shift; }
};

// The map of the outer surface is carried into the solid by mean value coordinates (Ju, Schaefer and Warren 2005, "Mean
// value coordinates for closed triangular meshes"), and the placement is the one that is nearest to that on points of
// the cavity's surface: least squares, the best of the 24 turns. Both maps are certified. O(triangles), of `outer`.
CavityPlacement place_cavity(const polycube::SurfaceMap& outer, const polycube::SurfaceMap& cavity,
                             const base::Host& host);

}  // namespace orbicube::volume_map
