// Writes mesh files: the format by the file's ending, whole or not at all (file.h).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>

#include "base/host.h"
#include "mesh/files/read.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

using Quad = std::array<Index, 4>;

struct WriteOptions {
  bool binary = true;  // PLY, STL, VTK, VTK XML, FreeSurfer and GIFTI; the others are text. Text holds 17 digits,
                       // binary PLY and VTK doubles
  // Quadrilaterals, such as the boundary of hexahedra, written behind the triangles in formats that hold cells, and
  // their regions, one each or none. They are read as two triangles each.
  std::span<const Quad> quads = {};
  std::span<const std::int32_t> quad_regions = {};
};

// Writes triangles, tetrahedra and hexahedra in formats that hold cells, and regions in those that hold them. A file
// that is read again is the same mesh, bit for bit, but for binary STL, FreeSurfer and GIFTI, whose coordinates are
// rounded to float32. Throws Error "unsupported-format" for an ending that is none of ours, "unsupported" for cells
// that the format cannot hold and for a surface that float32 cannot (it would move vertices by a thousandth of the
// size), "invalid-argument" for an index that is out of range and a wrong number of regions, "non-finite", "io",
// "cancelled". O(n log n) with regions, else O(n).
void write_mesh(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options,
                const base::Host& host);

}  // namespace orbicube::mesh
