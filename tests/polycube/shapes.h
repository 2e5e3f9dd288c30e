// Surfaces for the tests of constructions.
#pragma once

#include "mesh/shapes/make_shape.h"

namespace orbicube::test {

inline mesh::Mesh shape(const char* name, std::size_t triangles) {
  return mesh::make_shape(name, {.triangles = triangles}, base::Host());
}

}  // namespace orbicube::test
