// The two compared methods of the dissertation's chapter 3 that can be run here, for Tables 3.1 to 3.3 and 3.5. Neither
// prevents flips.
#pragma once

#include "base/host.h"
#include "mesh/mesh.h"
#include "sphere_map/sphere_map.h"

namespace orbicube::bench {

// Returns the harmonic map of Gu, Wang, Chan, Thompson and Yau 2004 ("Genus zero surface conformal mapping and its
// application to brain surface mapping"): the flow of the harmonic energy with cotangent weights, where after each step
// a Moebius transformation brings the center of mass of the surface back to the center of the sphere. The start is a
// bijection by latitude and longitude in place of one by normals, and steps are implicit: the same flow, fewer of them.
sphere_map::Array<mesh::Vector3> harmonic_baseline(const mesh::Mesh& surface, const base::Host& host);

// Returns a map after Zayer, Roessl and Seidel 2006 ("Curvilinear spherical parameterization"): two poles far from each
// other, a cut along the shortest path between them, quasi-harmonic latitude and longitude, whose conductivities follow
// the distortion of areas, and a tangential Laplacian where triangles are flipped. Negative weights are left out.
sphere_map::Array<mesh::Vector3> curvilinear_baseline(const mesh::Mesh& surface, const base::Host& host);

}  // namespace orbicube::bench
