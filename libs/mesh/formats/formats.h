// The table of mesh file formats: the only place that lists their endings. Readers, writers, help texts, messages and
// the C interface query it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "base/host.h"
#include "mesh/files/file.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

struct ReadReport;    // read.h
struct WriteOptions;  // write.h

// Numbers the rows of the table, and OBC_MESH_... of the C interface.
enum class Format { obj, off, ply, stl, medit, vtk, msh, freesurfer, inp, vtp, vtu, gifti };

// What a file can hold. Polygons: faces that share vertices, whose coordinates read back bit-identically. Cells:
// tetrahedra and hexahedra. Regions: of triangles and cells.
enum class Holds { surfaces, polygons, cells, regions };

struct FormatRow {
  Format format;
  const char* ending;  // as ".ply", lower case
  const char* name;    // as "PLY"; in lower case the word for it in other languages
  bool polygons;       // whether it has Holds::polygons
  bool cells;          // whether it has Holds::cells
  bool regions;        // whether it has Holds::regions
  bool binary;         // whether files are written in binary, too; all may be text
  Mesh (*read)(std::span<const std::byte>, const base::Host&, ReadReport&);
  void (*write)(OutputFile&, const Mesh&, const WriteOptions&, const base::Host&);
};

// All rows, in the order of Format.
std::span<const FormatRow> formats();

const FormatRow& row_of(Format format);

// Returns the ending of a path in lower case, as ".ply".
std::string ending_of(const std::filesystem::path& path);

// Returns the format that a path's ending, or another one that its files have, stands for, in upper or lower case, if
// any.
std::optional<Format> format_of_path(const std::filesystem::path& path);

bool holds(Format format, Holds what);

// Returns whether the path's ending stands for a format that holds this.
bool holds(const std::filesystem::path& path, Holds what);

// Returns the endings of the formats that hold this, separated by spaces, for messages and help texts.
std::string format_endings(Holds what = Holds::surfaces);

}  // namespace orbicube::mesh
