// Mesh files of every format that the libraries know, by their ending.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "gltf/kept/kept.h"
#include "gltf/writing/form.h"
#include "mesh/files/read.h"
#include "mesh/formats/formats.h"
#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

// The endings, for help texts and messages: of all files with surfaces, those of glTF alone, and those of formats that
// hold cells, or polygons and exact coordinates.
inline const std::string gltf_endings = gltf::form_endings();
inline const std::string surface_endings = mesh::format_endings() + " " + gltf_endings;
inline const std::string cell_endings = mesh::format_endings(mesh::Holds::cells);
inline const std::string polygon_endings = mesh::format_endings(mesh::Holds::polygons);

bool is_gltf(const std::filesystem::path& path);
bool is_json(const std::filesystem::path& path);

struct InputMesh {
  mesh::Mesh mesh;
  mesh::ReadReport report;
  double seconds = 0;
  std::shared_ptr<const gltf::Kept> kept;  // what a glTF file has besides, if it is to be kept and can be
};

// What of a glTF file is kept besides its surface, for an output: nothing, so that a note counts materials, textures,
// skins and so on; what the surface can be written with; or everything, for a file that is written as it is.
enum class Keep { surface, decoration, file };

// The same if an output of that name can hold it, else Keep::surface.
Keep keep_for(const std::filesystem::path& output, Keep wanted);

// Reads a mesh. Vertices at one position are welded on request, in glTF files that are not closed as they stand, and in
// STL. What the reader changed becomes notes of the session. `tags`: the report has what the file marks. Throws Failure
// "unsupported-format" for other endings.
InputMesh read_input(const std::filesystem::path& path, bool weld, Session& session, Keep keep = Keep::surface,
                     bool tags = false);

// Throws Failure "unsupported-format" unless files with such an ending can be written, and "io" when the folder is not
// there: before long work, not after it.
void require_writable(const std::filesystem::path& path);

// The same for a file that is to hold tetrahedra or hexahedra.
void require_cells_writable(const std::filesystem::path& path);

// Throws Failure "unsupported" if float32, which glTF holds, ends before the size of the positions that triangles have.
// Does nothing for other formats.
void require_float_range(const std::filesystem::path& path, std::span<const mesh::Vector3> positions,
                         std::span<const mesh::Triangle> triangles);

// The second of these alone, for files of other kinds.
void require_folder(const std::filesystem::path& path);

// Writes a glTF file again as an output of the session, with everything in it.
void write_output(const std::filesystem::path& path, const gltf::Kept& kept, Session& session);

// Writes the mesh as an output of the session; glTF in float32.
void write_output(const std::filesystem::path& path, const mesh::Mesh& mesh, bool binary, Session& session);

}  // namespace orbicube::cli
