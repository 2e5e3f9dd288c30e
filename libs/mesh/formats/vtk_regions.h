// Regions as both kinds of VTK files have them: one number for each cell, in the order of the cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "mesh/files/write.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// Puts the numbers one by one; 0 where cells of a kind have none.
template <class Out>
void put_regions_of_cells(Out& out, const Mesh& mesh, const WriteOptions& options) {
  const auto put = [&](std::span<const std::int32_t> regions, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      out.put(regions.empty() ? 0 : regions[i]);
      out.end_item();
    }
  };
  put(mesh.regions.triangles, mesh.triangles.size());
  put(options.quad_regions, options.quads.size());
  put(mesh.regions.tetrahedra, mesh.tetrahedra.size());
  put(mesh.regions.hexahedra, mesh.hexahedra.size());
}

}  // namespace orbicube::mesh
