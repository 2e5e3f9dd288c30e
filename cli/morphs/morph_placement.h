// Shapes of a morph brought to where the first one stands, at its size.
#pragma once

#include <span>
#include <string>

#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

inline constexpr const char* placement_help =
    "pose of further shapes in the morph: kept, as in their files; turned, translated and rotated to the least-squares "
    "fit with the first; scaled, scaled as well [default: kept]";

// Moves and rotates the further states (and scales them) so that the mean of the squared distances between points that
// correspond, weighted by area, is minimum (Umeyama 1991). How: kept, turned or scaled. Figures of each shape get
// "placement" with scale, rotation (rows) and shift: a point x goes to scale * rotation * x + shift.
void place(const std::string& how, std::span<const mesh::Triangle> triangles,
           std::span<base::Array<mesh::Vector3>> states, std::span<Json* const> figures);

}  // namespace orbicube::cli
