#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/binary_scanner.h"
#include "mesh/files/text_scanner.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

// Behind the triangles: tags, of which one has the geometry of the volume as lines of text, "cras = x y z". Coordinates
// are kept in the space of surfaces, which programs for them share; that of the scanner is elsewhere by c_ras.
void note_scanner_space(std::string_view text, ReadReport& report) {
  constexpr std::string_view valid_key = "valid = 1", key = "cras ";
  const std::size_t at = text.find(key);
  if (at == std::string_view::npos || text.find(valid_key) > at) return;
  std::string_view line = text.substr(at, text.substr(at, 200).find('\n'));
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos || line.size() > 200) return;
  line = trimmed(line.substr(equals + 1));
  const bool is_text = line.find_first_not_of("0123456789+-.eE \t") == std::string_view::npos;
  const bool is_zero = line.find_first_of("123456789") == std::string_view::npos;
  if (line.empty() || !is_text || is_zero) return;
  report.notes.push_back(
      "coordinates are kept in FreeSurfer's surface space; those of the scanner are larger by c_ras = " +
      std::string(line) + ", which is left out");
}

Mesh read_binary_surface(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  report.format = "FreeSurfer, binary";
  BinaryScanner scanner(bytes, 0, std::endian::big, host);
  scanner.skip(3);
  // A line of who made the file and when, and an empty one.
  scanner.line();
  if (scanner.line().size() > 1) scanner.fail("parse", "an empty line expected behind the line of who made the file");
  scanner.require(8, "the numbers of vertices and triangles");
  const auto vertices = scanner.next<std::int32_t>(), triangles = scanner.next<std::int32_t>();
  if (vertices < 0 || triangles < 0) {
    scanner.fail("parse", "a negative number of vertices or triangles: " + std::to_string(vertices) + ", " +
                              std::to_string(triangles));
  }
  const auto vertex_count = static_cast<std::size_t>(vertices), triangle_count = static_cast<std::size_t>(triangles);
  scanner.require_room(std::uint64_t{vertex_count} + triangle_count, 12, "vertices and triangles");
  Mesh mesh(host.memory);
  mesh.positions.reserve(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    Vector3 p;
    for (double& x : p)
      x = static_cast<double>(scanner.next<float>());
    if (!p.allFinite()) scanner.fail("non-finite", "the position of vertex " + std::to_string(v) + " is not finite");
    mesh.positions.push_back(p);
    scanner.progress();
  }
  mesh.triangles.reserve(triangle_count);
  for (std::size_t t = 0; t < triangle_count; ++t) {
    Triangle corners;
    for (Index& v : corners) {
      v = scanner.next<std::uint32_t>();
      if (v >= vertex_count) {
        scanner.fail("index-range",
                     "vertex index " + std::to_string(v) + " of " + base::counted(vertex_count, "vertex", "vertices"));
      }
    }
    mesh.triangles.push_back(corners);
    scanner.progress();
  }
  note_scanner_space({reinterpret_cast<const char*>(scanner.rest().data()), scanner.left()}, report);
  return mesh;
}

// "#!ascii" and a name, the numbers of vertices and triangles, and three numbers and a flag for each of them.
Mesh read_text(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  report.format = "FreeSurfer, text";
  TextScanner scanner(bytes, 0, host);
  scanner.next_line();
  const auto count = [&](const char* what) {
    scanner.skip_space();
    return scanner.count(what);
  };
  const std::uint64_t vertex_count = count("the number of vertices"), triangle_count = count("the number of triangles");
  scanner.require_room(vertex_count, 8, "vertices");
  scanner.require_room(triangle_count, 8, "triangles");
  Mesh mesh(host.memory);
  mesh.positions.reserve(vertex_count);
  for (std::uint64_t v = 0; v < vertex_count; ++v) {
    mesh.positions.push_back(scanner.point_after_space());
    scanner.skip_word("the flag of a vertex");
    scanner.progress();
  }
  mesh.triangles.reserve(triangle_count);
  for (std::uint64_t t = 0; t < triangle_count; ++t) {
    Triangle corners;
    for (Index& v : corners) {
      scanner.skip_space();
      v = scanner.index(0, vertex_count);
    }
    scanner.skip_word("the flag of a triangle");
    mesh.triangles.push_back(corners);
    scanner.progress();
  }
  return mesh;
}

}  // namespace

Mesh read_freesurfer(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xFF\xFF\xFE")) return read_binary_surface(bytes, host, report);
  if (text.starts_with("#!ascii")) return read_text(bytes, host, report);
  if (text.starts_with("\xFF\xFF\xFF") || text.starts_with("\xFF\xFF\xFD")) {
    throw base::Error("unsupported-version",
                      "byte 0: FreeSurfer's old format of quadrangles; mris_convert writes it with triangles");
  }
  throw base::Error("bad-magic",
                    "byte 0: FreeSurfer's surfaces start with the bytes FF FF FE, or with #!ascii where they are text");
}

}  // namespace orbicube::mesh
