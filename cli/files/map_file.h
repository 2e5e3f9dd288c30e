// The sphere map of a surface, read from a file that `orbicube sphere` has written.
#pragma once

#include <filesystem>
#include <string>

#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

// The map as a mesh, positions not scaled to length 1: a mesh file as it is; of a glTF file the morph target "sphere",
// where it has one. Throws Failure unless it has the vertices and triangles of the shape, in that order (triangles may
// be turned round: a map of a surface that is inward-oriented is outward-oriented).
mesh::Mesh read_map(const mesh::Mesh& shape, const std::string& shape_path, const std::filesystem::path& path,
                    Session& session);

}  // namespace orbicube::cli
