// Surfaces for the tests of constructions.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "mesh/shapes/make_shape.h"

namespace orbicube::test {

inline mesh::Mesh shape(const char* name, std::size_t triangles) {
  return mesh::make_shape(name, {.triangles = triangles}, base::Host());
}

inline double area_of(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles) {
  double area = 0;
  for (const mesh::Triangle& t : triangles)
    area += 0.5 * (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm();
  return area;
}

}  // namespace orbicube::test
