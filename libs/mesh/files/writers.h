// The writer of each format. They write what they are given; what a format cannot hold is refused before (write.h).
#pragma once

#include "base/host.h"
#include "mesh/files/file.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

void write_obj(OutputFile& file, const Mesh& mesh, const base::Host& host);
void write_off(OutputFile& file, const Mesh& mesh, const base::Host& host);

// With doubles; binary files are little-endian.
void write_ply(OutputFile& file, const Mesh& mesh, bool binary, const base::Host& host);

// Coordinates rounded to float32; facets with their normals.
void write_stl(OutputFile& file, const Mesh& mesh, bool binary, const base::Host& host);

void write_medit(OutputFile& file, const Mesh& mesh, const base::Host& host);

// Version 3.0: PolyData for surfaces, an unstructured grid for meshes with cells; binary files are big-endian.
void write_vtk(OutputFile& file, const Mesh& mesh, bool binary, const base::Host& host);

}  // namespace orbicube::mesh
