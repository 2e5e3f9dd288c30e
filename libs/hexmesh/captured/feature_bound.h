// The scaled Jacobian that the corners and curves of a surface allow, known before there is a mesh.
#pragma once

#include "hexmesh/captured/feature_surface.h"

namespace orbicube::hexmesh {

// Returns the largest minimum that hexahedra at the features can have, where each sector between two curves at a corner
// has two of them, as rings along the patches give it: along a curve the sine of half the dihedral angle; at a corner
// the largest, over the directions d of the inner edge, of the minimum over the sectors of -n d sin(t / 2), with the
// sector's mean normal n and angle t. 0: no direction sees all sectors. O(n).
double scaled_jacobian_bound(const FeatureSurface& surface, const base::Host& host);

// Whether the surface turns by 70 to 110 degrees along all arcs, and there are corners that are not soft, where three
// of them meet: what the edges of a polycube can follow. Of parts with closed arcs alone, such as flanges, it hardly
// ever follows these. O(n).
bool has_right_angles(const FeatureSurface& surface, const base::Host& host);

// Returns the distance of the origin from the convex hull of vectors, which is the largest minimum over them of v d
// for unit directions d; 0 where the hull has the origin. O(n^3).
double distance_of_hull(std::span<const Vector3> vectors);

}  // namespace orbicube::hexmesh
