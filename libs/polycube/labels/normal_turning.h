// Normals turned towards the axes by a rotation that changes slowly over the surface: protrusions that lean or bend get
// the labels of straight ones.
#pragma once

#include "polycube/surface/surface.h"

namespace orbicube::polycube {

// Minimizes over rotations R, one a triangle, the integral of x^2 y^2 + y^2 z^2 + z^2 x^2 for (x, y, z) = R n, which
// is 0 where R n is along an axis (Fang, Xu, Bao and Huang 2016), plus length^2 |grad R|^2. What bends over more than
// `length` is straightened, smaller features keep their shape (Gregson, Sheffer and Zhang 2011 deform the surface so).
// The surface has about unit area. Rotations start from the identity.
Array<Vector3> turned_normals(const Surface& surface, double length, const base::Host& host);

}  // namespace orbicube::polycube
