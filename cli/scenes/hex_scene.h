// A hexahedral mesh to look at: its quads with their edges, a part cut away, what is then seen of the inside colored
// by quality.
#pragma once

#include <filesystem>
#include <string>

#include "hexmesh/certificate/hex_mesh.h"
#include "session/session.h"

namespace orbicube::cli {

// What is left out: hexahedra whose center is above the middle of the box and in front of it (+y, +z), in front of it,
// or none.
enum class Cut { quarter, half, none };

// Writes glTF (.gltf, or GLB): quads as flat pairs of triangles with vertices of their own, the edges of the quads as
// lines. COLOR_0 of the surface is light brown, that of quads inside goes from red (scaled Jacobian of their hexahedron
// 0.5 or less) to blue (1). Coordinates are rounded to float32. Returns figures for the report. Throws what gltf::write
// throws. O(n log n).
Json write_hex_scene(const std::filesystem::path& path, const hexmesh::HexMesh& mesh, Cut cut, const std::string& name,
                     const base::Host& host);

}  // namespace orbicube::cli
