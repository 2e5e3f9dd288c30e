// How messages tell a place.
#pragma once

#include <string>

#include "mesh/mesh.h"

namespace orbicube::mesh {

// "(x, y, z)", to nine digits.
std::string place_text(const Vector3& p);

}  // namespace orbicube::mesh
