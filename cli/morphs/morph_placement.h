// Shapes of a morph brought to where the first one stands, at its size.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

inline constexpr const char* placement_help =
    "pose of further shapes in the morph: kept, as in their files; turned, translated and rotated to the least-squares "
    "fit with the first; scaled, scaled as well [default: kept]";

// Places the further states as correspondence::place does. How: kept, turned or scaled. Figures of each shape get
// "placement" with scale, rotation (rows) and shift: a point x goes to scale * rotation * x + shift.
void place_states(const std::string& how, std::span<const mesh::Triangle> triangles,
                  std::span<base::Array<mesh::Vector3>> states, std::span<Json* const> figures);

// Rows of a matrix.
Json json_of(const Eigen::Matrix3d& rotation);

}  // namespace orbicube::cli
