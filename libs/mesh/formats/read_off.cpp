#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/files/left_out.h"
#include "mesh/files/polygons.h"
#include "mesh/files/text_scanner.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

// The header keyword: ST, C and N in this order, each or not, then OFF.
void read_magic(TextScanner& scanner) {
  const std::string_view magic = scanner.word_after_space();
  const std::array known = {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
  const bool is_known = std::find(known.begin(), known.end(), magic) != known.end();
  if (is_known || in_small_letters(magic) == "off" || in_small_letters(magic) == "coff") return;
  if (magic.ends_with("4OFF") || magic.ends_with("nOFF")) {
    throw base::Error("unsupported-format", "line 1: " + std::string(magic) + " files are not of three dimensions");
  }
  throw base::Error("bad-magic", "line 1: an OFF file starts with OFF (or COFF, NOFF, STOFF)");
}

}  // namespace

Mesh read_off(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  TextScanner scanner(bytes, '#', host);
  Mesh mesh(host.memory);
  if (!scanner.skip_space()) return mesh;
  read_magic(scanner);
  if (scanner.starts_with("BINARY")) {
    throw base::Error("unsupported-format", "line 1: binary OFF files are not read");
  }
  const auto count = [&](const char* what) {
    scanner.skip_space();
    return scanner.count(what);
  };
  const std::uint64_t vertex_count = count("the number of vertices");
  const std::uint64_t face_count = count("the number of faces");
  if (!scanner.at_end_of_line()) scanner.count("the number of edges");
  scanner.require_room(vertex_count, 6, "vertices");
  scanner.require_room(face_count, 4, "faces");

  std::size_t of_vertices = 0, of_faces = 0;
  mesh.positions.reserve(vertex_count);
  for (std::uint64_t v = 0; v < vertex_count; ++v) {
    mesh.positions.push_back(scanner.point_after_space());
    of_vertices += !scanner.at_end_of_line();
    scanner.next_line();  // colors, normals and the like
    scanner.progress();
  }
  Polygons faces(host.memory);
  faces.reserve_triangles(face_count);
  Array<Index> face(host.memory);
  for (std::uint64_t f = 0; f < face_count; ++f) {
    scanner.skip_space();
    const std::uint64_t corners = scanner.count("a face's number of corners");
    scanner.require_room(corners, 2, "corners of a face");
    face.clear();
    for (std::uint64_t i = 0; i < corners; ++i) {
      if (scanner.at_end_of_line()) scanner.skip_space();
      face.push_back(scanner.index(0, mesh.positions.size()));
    }
    faces.add(face, scanner);
    of_faces += !scanner.at_end_of_line();
    scanner.next_line();
    scanner.progress();
  }
  report.format = "OFF";
  report.polygons = faces.larger_than_triangles();
  faces.to_triangles(mesh.positions, mesh.triangles, host);
  note_left_out({{of_vertices, "color, normal or texture coordinate of a vertex",
                  "colors, normals or texture coordinates of vertices"},
                 {of_faces, "color of a face", "colors of faces"}},
                report.notes);
  return mesh;
}

}  // namespace orbicube::mesh
