// Files of fields: `.frames`, a line `w x y z` a tetrahedron with digits that read as the same doubles, and legacy VTK
// with the frames' axes as vectors of the cells, for viewers.
#pragma once

#include <filesystem>
#include <span>

#include "base/host.h"
#include "frame_field/graph/dual_graph.h"

namespace orbicube::frame_field {

// Whole or not at all (mesh/files/file.h). Throws Error "io", "cancelled". O(n).
void write_frames(const std::filesystem::path& path, std::span<const Quaternion> field, const base::Host& host);

// A field of `count` frames, scaled to length 1. Empty lines and what follows a # are passed over. Throws Error "io";
// "parse", "non-finite", "truncated", "trailing-data" with the line; "degenerate-geometry" for a frame of length 0;
// "cancelled". O(n).
Field read_frames(const std::filesystem::path& path, std::size_t count, const base::Host& host);

// The tetrahedra with their frames' axes as the cell vectors axis_1, axis_2 and axis_3, in text. Throws Error "io",
// "cancelled". O(n).
void write_vtk(const std::filesystem::path& path, std::span<const Vector3> positions,
               std::span<const Tetrahedron> tetrahedra, std::span<const Quaternion> field, const base::Host& host);

}  // namespace orbicube::frame_field
