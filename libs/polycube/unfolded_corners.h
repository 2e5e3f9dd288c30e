// Corners of the polycube moved from vertex to vertex of an unfolded map.
#pragma once

#include "polycube/unfolded_star.h"

namespace orbicube::polycube {

// Each corner that is not held goes to the neighbour at which the triangles around both are least distorted, as long as
// that is better: the neighbour takes its place on the polycube, and the vertex that was there becomes one like others,
// which finds its place in the ring that is left. Triangles stay positive. Answers how many moves were made. Throws
// Error "cancelled".
std::size_t move_corners(UnfoldedMap& map, const TriangleWeights& weights, const base::Host& host);

// The corner walks to a vertex from neighbour to neighbour, whatever that costs, around other corners and vertices that
// are held or tied; those around it give way. Whether it has come there: where triangles leave no room it stops.
bool walk_corner(UnfoldedMap& map, const TriangleWeights& weights, Index corner, Index vertex, const base::Host& host);

// The corner leaves its vertex for the neighbour where that costs least. Whether there was one.
bool leave_vertex(UnfoldedMap& map, const TriangleWeights& weights, Index corner, const base::Host& host);

}  // namespace orbicube::polycube
