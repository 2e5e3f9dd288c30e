// Reads mesh files: the format by the file's ending, polygons cut into triangles, nothing in the file trusted.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/host.h"
#include "mesh/files/feature_tags.h"
#include "mesh/formats/formats.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

struct ReadOptions {
  // Welds vertices at identical positions when the surface is not closed as it stands, and those of solids in any case.
  // STL, which has no shared vertices, is always joined so.
  bool weld_identical = false;
  // Keeps marked edges and vertices: VTK's lines and vertices, OBJ's l and p, and those of MEDIT's sections Ridges,
  // RequiredEdges (Edges, where there is neither), Corners and RequiredVertices. Otherwise they are passed over.
  bool feature_tags = false;
};

// What a reader of surface files found besides the mesh. Also used by the glTF reader.
struct ReadReport {
  std::string format;               // as "PLY, binary, big-endian"
  std::size_t polygons = 0;         // faces of more than three corners, before they were cut into triangles
  std::size_t welded_vertices = 0;  // joined to others at the same position
  std::optional<FeatureTags> tags;  // of ReadOptions::feature_tags
  std::vector<std::string> notes;   // what was changed or left out, one line each and each thing once
};

// Reads the file at `path`. Vertices keep their number and order unless they are joined. Tetrahedra that are all
// inverted, or hexahedra, are turned. `report` may be null.
// Throws Error "unsupported-format" for an ending that is none of ours, "io" when the file cannot be read, the kinds of
// malformed files (libs/base/error.cpp) with line or byte of the place (the caller names the file), "cancelled".
// O(size of the file) time; memory is bounded by a multiple of the file's size whatever counts it claims.
Mesh read_mesh(const std::filesystem::path& path, const ReadOptions& options, const base::Host& host,
               ReadReport* report = nullptr);

// The same from bytes in memory.
Mesh read_mesh(Format format, std::span<const std::byte> bytes, const ReadOptions& options, const base::Host& host,
               ReadReport* report = nullptr);

// turn_inverted_cells (cells.h), with a note of those that were reversed.
void note_turned_cells(Mesh& mesh, std::vector<std::string>& notes, const base::Host& host);

}  // namespace orbicube::mesh
