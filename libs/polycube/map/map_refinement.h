// A map of a coarse surface brought to the fine one that it was decimated from, vertex by vertex.
//
// A vertex that comes back has a place in the kernel of its ring, whatever the map: beside the vertex that it was
// merged into. Vertices along arcs stay on them. So a positive map of the coarse surface becomes one of the fine
// surface without anything to untangle. Vertices are moved to where the energy of their triangles (planar_triangles.h,
// with eps = 0) is least: in one vertex that energy is convex, the sum of a square over a positive linear function and
// of functions of the latter, so Newton's method finds the place.
#pragma once

#include "polycube/surface/decimation.h"

namespace orbicube::polycube {

// `polycube` are positions of all vertices of `surface`, of which those that `decimation` left are set and their
// triangles positive; sets the others. Positions on the polycube have about the scale of the surface. Undoes the
// decimation. `sweeps` go over all vertices of the fine surface at the end. Throws Error "no-valid-result" when
// rounding leaves a vertex no place.
void refine_map(const Surface& surface, std::span<const AxisLabel> labels, Decimation& decimation, double area_weight,
                int sweeps, std::span<Vector3> polycube, const base::Host& host);

}  // namespace orbicube::polycube
