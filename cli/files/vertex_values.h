// Values of the vertices of a mesh: read from its own file or from a table, and written with another mesh.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::cli {

struct VertexValues {
  explicit VertexValues(std::pmr::memory_resource* memory) : values(memory), corners(memory) {}

  std::size_t channels() const { return names.size(); }

  std::vector<std::string> names;
  std::vector<bool> bytes;              // of each channel: integers from 0 to 255, as colors of PLY are
  base::Array<double> values;           // rows of one number a channel
  base::Array<mesh::Triangle> corners;  // rows of the corners of each triangle, where texture coordinates have seams;
                                        // empty: row v is that of vertex v
};

// Reads what the file of a mesh holds of its vertices besides their positions. Throws Error "unsupported" for formats
// whose values are not read, and for a mesh with other vertices than the file, "parse", "truncated", "io".
VertexValues read_mesh_values(const std::filesystem::path& path, const mesh::Mesh& mesh, const base::Host& host);

// Reads a text table: lines of as many numbers each, between blanks, commas or semicolons; the first line may have
// names. Throws Error "parse" with the line, "io".
VertexValues read_value_table(const std::filesystem::path& path, const base::Host& host);

// Writes the values as text, one line a vertex with the names in the first; as PLY, with the positions and triangles.
// Throws Error "io", "cancelled".
void write_values(const std::filesystem::path& path, const mesh::Mesh& mesh, const VertexValues& values,
                  const base::Host& host);

}  // namespace orbicube::cli
