// Positions on the way to formats that hold float32 only.
#pragma once

#include <string>

#include "mesh/mesh.h"

namespace orbicube::mesh {

// Returns the nearest float32. Throws Error "unsupported" for what is too large; `format` names the format.
float to_float(double x, const char* format);

// Refuses surfaces that float32 would turn into others, far from the origin or tiny: throws Error "unsupported" where a
// corner of a triangle would move by a thousandth of the size. `others` names formats for the message, as "OBJ holds
// them". O(n).
void require_float_resolution(const Mesh& mesh, const char* format, const std::string& others);

}  // namespace orbicube::mesh
