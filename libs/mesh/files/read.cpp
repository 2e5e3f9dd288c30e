#include "mesh/files/read.h"

#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/file.h"
#include "mesh/files/text_scanner.h"
#include "mesh/files/wrapped_file.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/topology.h"
#include "mesh/topology/weld.h"

namespace orbicube::mesh {
namespace {

bool has_cells(const Mesh& mesh) {
  return !mesh.tetrahedra.empty() || !mesh.hexahedra.empty();
}

bool is_closed(const Mesh& mesh, const base::Host& host) {
  return topology(mesh.positions, mesh.triangles, host).closed();
}

}  // namespace

void note_turned_cells(Mesh& mesh, std::vector<std::string>& notes, const base::Host& host) {
  const CellTurnReport turned = turn_inverted_cells(mesh, host);
  const auto tell = [&](std::size_t count, const std::string& one, const char* many) {
    if (count == 1) notes.push_back("the only " + one + " was inverted, and was reversed");
    if (count > 1) notes.push_back("all " + std::to_string(count) + " " + many + " were inverted, and were reversed");
  };
  tell(turned.tetrahedra, "tetrahedron", "tetrahedra");
  tell(turned.hexahedra, "hexahedron", "hexahedra");
}

Mesh read_mesh(const std::filesystem::path& path, const ReadOptions& options, const base::Host& host,
               ReadReport* report) {
  const auto format = format_of_path(path);
  if (!format) {
    throw base::Error("unsupported-format",
                      "the ending " + in_quotes(path.extension().string()) + " is none of " + format_endings());
  }
  return read_mesh(*format, read_file(path, host), options, host, report);
}

Mesh read_mesh(Format format, std::span<const std::byte> bytes, const ReadOptions& options, const base::Host& host,
               ReadReport* report) {
  ReadReport own;
  ReadReport& r = report ? *report : own;
  r = {};
  if (options.feature_tags) r.tags.emplace();
  // No format holds a vertex in fewer bytes than three, so that indices of 32 bits count the vertices of any file
  // below.
  if (bytes.size() / 3 >= no_index) throw base::Error("unsupported", "files of 12 GB or more are not read");
  if (bytes.empty()) throw base::Error("empty-file", "the file has no bytes");
  // A binary STL file may begin with anything: its reader looks whether it is one.
  if (format != Format::stl) refuse_wrapped(bytes);
  Mesh mesh = row_of(format).read(bytes, host, r);
  if (mesh.triangles.empty() && !has_cells(mesh)) {
    throw base::Error("empty-mesh", mesh.positions.empty()
                                        ? "the file has no vertices and no faces"
                                        : "the file has " + base::counted(mesh.positions.size(), "vertex", "vertices") +
                                              ", but no faces");
  }
  note_turned_cells(mesh, r.notes, host);
  const bool asked = options.weld_identical && (has_cells(mesh) || !is_closed(mesh, host));
  if (format == Format::stl || asked) {
    if (r.tags) renumber_as_welded(*r.tags, mesh.positions, host);
    const WeldReport welded = weld(mesh, host);
    r.welded_vertices = welded.vertices;
    if (mesh.triangles.empty() && !has_cells(mesh)) {
      throw base::Error("degenerate-geometry",
                        "each of the " + base::counted(welded.triangles, "face") + " has two corners at one position");
    }
    if (welded.triangles > 0) {
      r.notes.push_back(base::counted(welded.triangles, "face with two corners at one position was",
                                      "faces with two corners at one position were") +
                        " left out");
    }
  }
  require_valid_cells(mesh, host);
  return mesh;
}

}  // namespace orbicube::mesh
