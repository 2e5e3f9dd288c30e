// Shapes of a morph brought to where the first one stands, at its size.
#pragma once

#include <span>
#include <string>

#include "mesh/mesh.h"
#include "session.h"

namespace orbicube::cli {

inline constexpr const char* placement_help =
    "where further shapes stand in the morph (kept): kept, where their files have them; turned, moved and rotated to "
    "agree with the first; scaled, and brought to its size";

// Moves and rotates the further states (and scales them) so that the mean of the squared distances between points that
// correspond, weighted by area, is least (Umeyama 1991). How: kept, turned or scaled. Figures of each shape get
// "placement" with scale, rotation (rows) and shift: a point x goes to scale * rotation * x + shift.
void place(const std::string& how, std::span<const mesh::Triangle> triangles,
           std::span<base::Array<mesh::Vector3>> states, std::span<Json* const> figures);

}  // namespace orbicube::cli
