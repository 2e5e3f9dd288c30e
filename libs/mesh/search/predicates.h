// Exact signs of determinants of coordinates. A floating-point filter with a proven bound returns nearly always; what
// it leaves open is decided exactly, for every finite double. All throw no-valid-result for a coordinate that is not
// finite.
#pragma once

#include "mesh/mesh.h"

namespace orbicube::mesh {

// Sign (-1, 0, 1) of det[p q r] = p . (q x r): on which side of the plane through the origin, p and q the point r lies.
// Positive when p, q, r are counter-clockwise seen from outside the sphere that they lie on.
int orientation_from_origin(const Vector3& p, const Vector3& q, const Vector3& r);

// Sign of det[b-a, c-a, d-a]: positive when the tetrahedron a, b, c, d has positive volume.
int orientation_3d(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

// Sign of the signed area of the triangle a, b, c in the plane: positive when counter-clockwise.
int orientation_2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace orbicube::mesh
