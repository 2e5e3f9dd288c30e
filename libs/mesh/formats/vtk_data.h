// Data on cells behind the geometry of VTK files: the array that has the numbers of their regions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/formats/vtk_body.h"

namespace orbicube::mesh {

// Returns how far behind a name is among those that programs give to arrays of region numbers, in letters of any size;
// nothing for other names.
std::optional<std::size_t> region_rank(std::string_view name);

struct VtkRegionArray {
  std::string name;
  VtkNumber type = VtkNumber::int32;
  std::uint64_t count = 0;  // of numbers
  std::size_t begin = 0;    // of the numbers, in the text that was searched
};

struct VtkData {
  std::size_t arrays = 0;  // of points and cells, also in fields
  std::optional<VtkRegionArray> regions;
};

// Searches the rest of a legacy file behind its geometry: lines that begin as data arrays do. `cells`: of CELL_DATA, if
// the rest begins behind that line.
VtkData find_vtk_data(std::string_view text, std::optional<std::uint64_t> cells);

}  // namespace orbicube::mesh
