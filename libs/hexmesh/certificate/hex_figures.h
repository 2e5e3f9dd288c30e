// How near a mesh of hexahedra is to the surface that it fills: the figures of reports.
#pragma once

#include <span>

#include "hexmesh/certificate/hex_mesh.h"

namespace orbicube::hexmesh {

struct HexFigures {
  double distance = 0;  // Hausdorff distance of boundary and surface, in percent of the diagonal of the surface's box
  double volume_error = 0;  // in percent of the volume of the surface
  double volume = 0;        // of the trilinear cells; beyond the range of double infinite, or 0
};

// Quads of the boundary count as two triangles, cut at their first vertices in the order that MEDIT and VTK give to the
// faces of a hexahedron. The distance is right to half a percent of itself. Coordinates may have any size. Throws Error
// "cancelled".
HexFigures figures_of(std::span<const Vector3> positions, std::span<const Hexahedron> hexahedra,
                      std::span<const Vector3> surface_positions, std::span<const mesh::Triangle> surface_triangles,
                      const base::Host& host);

}  // namespace orbicube::hexmesh
