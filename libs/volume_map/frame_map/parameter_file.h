// Files of parameterizations.
#pragma once

#include <filesystem>

#include "volume_map/frame_map/parameterization.h"

namespace orbicube::volume_map {

// Writes a legacy VTK file as text: the tetrahedra, and as cell data the coordinates of the corners ("parameters", 12
// numbers), of the four faces whether they are cut, the rotation and the gap ("cut" 4, "rotation" 4, "gap" 12), and
// whether the tetrahedron is inverted. Faces are opposite corners. Numbers read as the same doubles. Throws Error "io".
void write_parameter_vtk(const std::filesystem::path& path, std::span<const Vector3> positions,
                         std::span<const Tetrahedron> tetrahedra, const Parameterization& map, const base::Host& host);

// Writes the format of the program HexEx (Lyon, Bommes and Kobbelt 2016): positions, then four vertices and twelve
// coordinates a tetrahedron. Throws Error "io".
void write_hexex(const std::filesystem::path& path, std::span<const Vector3> positions,
                 std::span<const Tetrahedron> tetrahedra, const Parameterization& map, const base::Host& host);

}  // namespace orbicube::volume_map
