// Quadrilateral meshes as files: OBJ and OFF with faces of four corners; other formats get two triangles a quad.
#pragma once

#include <array>
#include <filesystem>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::cli {

// Whole or not at all. Throws Error "io", "unsupported-format", "cancelled".
void write_quads(const std::filesystem::path& path, std::span<const mesh::Vector3> positions,
                 std::span<const std::array<mesh::Index, 4>> quads, const base::Host& host);

}  // namespace orbicube::cli
