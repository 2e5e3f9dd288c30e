// The reader and the writer of each format, as the table of formats (formats.cpp) has them. Readers: bytes in, mesh
// out. They check all that a file can get wrong by itself; welding vertices and turning and checking cells is left to
// read_mesh (files/read.h), which also says what errors mean. `report` gets the format's variant, the number of
// polygons and notes: what was passed over, and one of all that decorates a shape. Writers write what they are given;
// what a format cannot hold is refused before (files/write.h).
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/files/file.h"
#include "mesh/files/read.h"
#include "mesh/files/write.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// Wavefront OBJ (Alias 1989): v and f lines; textures, normals, groups, materials, lines and points are passed over.
Mesh read_obj(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// Geomview OFF, with the prefixes C, N and ST for colors, normals and texture coordinates, which are passed over.
Mesh read_off(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// Stanford PLY (Turk 1994): ASCII and binary of either byte order, any properties; faces and triangle strips.
Mesh read_ply(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// STL, ASCII and binary: loose triangles. ASCII as many programs write it.
Mesh read_stl(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// MEDIT .mesh (Frey 2001), ASCII: triangles, quadrilaterals, tetrahedra and hexahedra, prisms and pyramids cut into
// tetrahedra; reference numbers are regions. Cells of other kinds are refused, other sections passed over.
Mesh read_medit(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// Legacy VTK, ASCII and binary, versions 1 to 5: PolyData and unstructured grids of triangles, quads, polygons,
// triangle strips, tetrahedra, hexahedra and voxels; prisms and pyramids, cut into tetrahedra. Data on cells with a
// usual name (vtk_data.h) has regions, other data is passed over. Cells of other kinds are refused.
Mesh read_vtk(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// Gmsh .msh, versions 2.0 to 2.2 and 4.1, ASCII and binary of either byte order: triangles, quadrangles, tetrahedra and
// hexahedra, prisms and pyramids cut into tetrahedra; lines and points are tags. Physical groups, or geometric entities
// where there are none, are regions. Elements of other types are refused, data on nodes and elements is passed over.
Mesh read_msh(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// FreeSurfer's surfaces of triangles, binary and text. Coordinates are kept as they are, in the space of surfaces; the
// offset to the scanner's is noted.
Mesh read_freesurfer(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// Abaqus and CalculiX .inp: linear solid elements and shells, membranes and plane elements as faces; beams and trusses
// of two nodes are tags, element sets are regions (inp_sets.h). Elements of other types are refused, as files of
// several parts and included files are; springs, masses and all else is passed over.
Mesh read_inp(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// XML files of VTK, PolyData and unstructured grids, with numbers as text or bytes, inside or appended, compressed by
// zlib or not; the same cells as legacy files.
Mesh read_vtk_xml(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

// GIFTI: one array of points and one of triangles, as text or bytes, compressed or not. Coordinates are kept as they
// are.
Mesh read_gifti(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report);

void write_obj(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);
void write_off(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);

// With doubles; binary files are little-endian.
void write_ply(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);

// Coordinates rounded to float32; facets with their normals.
void write_stl(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);

void write_medit(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);

// Version 2.2, ASCII, which all programs that know Gmsh's format read.
void write_msh(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);

// With coordinates rounded to float32 in binary files.
void write_freesurfer(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);

// Elements S3, S4, C3D4 and C3D8, an element set each, and sets of their regions.
void write_inp(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);

// With doubles, as text or as bytes in base64, which are compressed in builds with zlib.
void write_vtp(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);
void write_vtu(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);

// With coordinates rounded to float32 but for text.
void write_gifti(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);

// Version 3.0: PolyData for surfaces, an unstructured grid for meshes with cells; binary files are big-endian.
void write_vtk(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host);

}  // namespace orbicube::mesh
