// Mesh files of every format that the libraries know, by their ending.
#pragma once

#include <filesystem>

#include "mesh/mesh.h"
#include "mesh/read.h"
#include "session.h"

namespace orbicube::cli {

// The endings, for help texts.
inline constexpr const char* surface_endings = ".obj .off .ply .stl .glb .gltf .mesh .vtk";

bool is_gltf(const std::filesystem::path& path);
bool is_json(const std::filesystem::path& path);

struct InputMesh {
  mesh::Mesh mesh;
  mesh::ReadReport report;
  double seconds = 0;
};

// Reads a mesh. Vertices at one position are joined on request, in glTF files that are not closed as they stand, and in
// STL. What the reader changed becomes notes of the session.
InputMesh read_input(const std::filesystem::path& path, bool weld, Session& session);

// Throws Failure "unsupported-format" unless files with such an ending can be written, and "io" when the folder is not
// there: before long work, not after it.
void require_writable(const std::filesystem::path& path);

// The second of these alone, for files of other kinds.
void require_folder(const std::filesystem::path& path);

// Writes the mesh, whole or not at all; glTF in float32.
void write_output(const std::filesystem::path& path, const mesh::Mesh& mesh, bool binary, const base::Host& host);

}  // namespace orbicube::cli
