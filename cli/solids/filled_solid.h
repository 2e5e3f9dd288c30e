// A surface filled with tetrahedra for a map of the solid: made coarser where it is fine, and fine enough inside.
#pragma once

#include "tetrahedra/tetrahedra.h"
#include "volume_map/meshing/coarse_surface.h"

namespace orbicube::cli {

struct FilledSolid {
  tetrahedra::Solid solid;              // the vertices of the surface first
  base::Array<mesh::Triangle> surface;  // its boundary
};

// Of a closed surface. If it has more than twice `triangles` triangles, the surface of the solid has about that many,
// or more where that few would meet themselves; fewer where all of them do. Throws what tetrahedra::fill does with all
// of them.
FilledSolid filled_solid(const mesh::Mesh& surface, std::size_t triangles, const base::Host& host);

}  // namespace orbicube::cli
