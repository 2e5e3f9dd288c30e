// The reader of each format: bytes in, mesh out. They check all that a file can get wrong by itself; joining vertices
// and checking cells is left to read_mesh (read.h), which also says what errors mean. `report` gets the format's
// variant, the number of polygons and notes.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/read.h"

namespace orbicube::mesh {

// Wavefront OBJ (Alias 1989): v and f lines; textures, normals, groups, materials, lines and points are passed over.
Mesh read_obj(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// Geomview OFF, with the prefixes C, N and ST for colours, normals and texture coordinates, which are passed over.
Mesh read_off(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// Stanford PLY (Turk 1994): ASCII and binary of either byte order, any properties; faces and triangle strips.
Mesh read_ply(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// STL, ASCII and binary: loose triangles.
Mesh read_stl(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// MEDIT .mesh (Frey 2001), ASCII: triangles, quadrilaterals, tetrahedra and hexahedra; other sections are passed over.
Mesh read_medit(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// Legacy VTK, ASCII and binary, versions 1 to 5: PolyData and unstructured grids of triangles, quads, polygons,
// triangle strips, tetrahedra, hexahedra and voxels. Data on points and cells is passed over.
Mesh read_vtk(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

}  // namespace orbicube::mesh
