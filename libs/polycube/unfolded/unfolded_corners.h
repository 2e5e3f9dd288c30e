// Corners of the polycube moved from vertex to vertex of an unfolded map.
#pragma once

#include "polycube/unfolded/unfolded_star.h"

namespace orbicube::polycube {

// Each corner that is not fixed goes to the neighbor at which the distortion of the triangles around both is minimum,
// as long as that is better: the neighbor takes its place on the polycube, and the vertex that was there becomes one
// like others, which moves into the ring that is left. Triangles stay positive. Returns how many moves were
// made. Throws Error "cancelled".
std::size_t move_corners(UnfoldedMap& map, const TriangleWeights& weights, const base::Host& host);

// The corner walks to a vertex from neighbor to neighbor, whatever that costs, around other corners and vertices that
// are fixed or tied; those around it give way. Whether it has come there: where triangles leave no room it stops.
bool walk_corner(UnfoldedMap& map, const TriangleWeights& weights, Index corner, Index vertex, const base::Host& host);

// The corner leaves its vertex for the neighbor where that costs least. Whether there was one.
bool leave_vertex(UnfoldedMap& map, const TriangleWeights& weights, Index corner, const base::Host& host);

}  // namespace orbicube::polycube
