// The readers of OBJ, OFF, PLY and STL: what is odd but right, what is wrong and where.
#include <doctest/doctest.h>

#include <bit>
#include <cstring>

#include "base/counted.h"
#include "read_text.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

const std::string corners_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string faces_obj = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const std::array<Triangle, 4> tetrahedron_triangles = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

bool is_tetrahedron(const Mesh& mesh) {
  return mesh.positions.size() == 4 && mesh.positions[3] == Vector3(0, 0, 1) &&
         std::equal(mesh.triangles.begin(), mesh.triangles.end(), tetrahedron_triangles.begin(),
                    tetrahedron_triangles.end());
}

std::string bytes_of(auto number, std::endian order = std::endian::little) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

}  // namespace

TEST_CASE("OBJ: every form of a corner, and lines that are of no interest") {
  CHECK(is_tetrahedron(read_text(Format::obj, corners_obj + faces_obj)));
  CHECK(is_tetrahedron(read_text(
      Format::obj, "mtllib a b.mtl\no x\n" + corners_obj +
                       "vt 0 0\nvn 0 0 1\ng\ns off\nf 1/1 3/1 2/1\nf 1//1 2//1 4//1\nl 1 2\nf 2/1/1 3/1/1 4/1/1\n"
                       "p 1\nf -4 -1 -2\n")));
}

TEST_CASE("OBJ: colors and weights after a vertex, comments, signs, exponents and blanks") {
  CHECK(is_tetrahedron(
      read_text(Format::obj, "# v 9 9 9\n\n \tv\t-0 0.0 0e5 1 0 0.5\nv +1 0 .0\nv 0 1.0E+0 0 1\n  v 0 0 1e0 # top\n" +
                                 faces_obj + "# f 1 2 3")));
}

TEST_CASE("OBJ: every kind of line end, a byte order mark, and lines that go on") {
  const std::string text = corners_obj + faces_obj;
  CHECK(is_tetrahedron(read_text(Format::obj, replaced(text, "\n", "\r\n"))));
  CHECK(is_tetrahedron(read_text(Format::obj, replaced(text, "\n", "\r"))));
  CHECK(is_tetrahedron(read_text(Format::obj, "\xEF\xBB\xBF" + text)));
  CHECK(is_tetrahedron(read_text(Format::obj, replaced(text, " 3 ", " \\\n 3 \\\r\n "))));
  CHECK(is_tetrahedron(read_text(Format::obj, text.substr(0, text.size() - 1))));
}

TEST_CASE("OBJ: faces before their vertices are read when the vertices come") {
  CHECK(is_tetrahedron(read_text(Format::obj, faces_obj + corners_obj)));
  CHECK(ends_as(Format::obj, "v 0 0 0\nf 1 2 3\nv 1 0 0\n", "index-range", "line 2: vertex index 3 of 2"));
}

TEST_CASE("OBJ: what is wrong is refused with its line") {
  const auto with = [](const char* line) { return corners_obj + line + "\n" + faces_obj; };
  CHECK(ends_as(Format::obj, with("v 1 2"), "parse", "line 5"));
  CHECK(ends_as(Format::obj, with("v 1 2 x"), "parse", "'x'"));
  CHECK(ends_as(Format::obj, with("v 1,5 2 3"), "parse", "line 5"));
  CHECK(ends_as(Format::obj, with("v 0x1p3 2 3"), "parse", "line 5"));
  CHECK(ends_as(Format::obj, with("v 1e999 2 3"), "non-finite", "line 5"));
  CHECK(ends_as(Format::obj, with("v 1 NaN 3"), "non-finite", "line 5"));
  CHECK(ends_as(Format::obj, with("v 1 2 -inf"), "non-finite", "line 5"));
  CHECK(ends_as(Format::obj, with("f 1 2"), "parse", "2 vertices"));
  CHECK(ends_as(Format::obj, with("f"), "parse", "0 vertices"));
  CHECK(ends_as(Format::obj, with("f 0 1 2"), "index-range", "count from 1"));
  CHECK(ends_as(Format::obj, with("f 1 2 5"), "index-range", "line 5: vertex index 5 of 4"));
  CHECK(ends_as(Format::obj, with("f -5 1 2"), "index-range", "-5 after 4"));
  CHECK(ends_as(Format::obj, with("f 4294967297 1 2"), "index-range", "line 5"));
  CHECK(ends_as(Format::obj, with("f 18446744073709551617 1 2"), "index-range", "line 5"));
  CHECK(ends_as(Format::obj, with("f 1.5 2 3"), "parse", "line 5"));
  CHECK(ends_as(Format::obj, with("f 1 2 3 1"), "degenerate-face", "line 5"));
  CHECK(ends_as(Format::obj, corners_obj, "empty-mesh", "4 vertices, but no faces"));
  CHECK(ends_as(Format::obj, "\n# nothing\n", "empty-mesh"));
  CHECK(ends_as(Format::obj, "", "empty-file"));
  CHECK(ends_as(Format::obj, corners_obj + std::string("f 1 2\0 3\n", 9), "parse", "line 5: a NUL"));
}

TEST_CASE("A triangle with a repeated corner is a fact of the shape, and stays in the mesh") {
  const Mesh mesh = read_text(Format::obj, corners_obj + faces_obj + "f 1 1 2\n");
  CHECK(mesh.triangles.size() == 5);
  CHECK(mesh.triangles[4] == Triangle{0, 0, 1});
}

TEST_CASE("OFF: prefixes, comments, colors, counts on the first line") {
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  CHECK(is_tetrahedron(read_text(Format::off, "OFF\n4 4 6\n" + corners + faces)));
  CHECK(is_tetrahedron(read_text(Format::off, "OFF 4 4 6\n" + corners + faces)));
  CHECK(is_tetrahedron(
      read_text(Format::off, "# a\nOFF # b\n\n# c\n4 4\n" + replaced(corners, "\n", " # d\n\n") + faces)));
  CHECK(is_tetrahedron(read_text(Format::off, "COFF\n4 4 6\n" + replaced(corners, "\n", " 255 0 0 255\n") +
                                                  replaced(faces, "\n", " 0.5 0.5 0.5\n"))));
  CHECK(is_tetrahedron(read_text(Format::off, "STCNOFF\n4 4 6\n" + corners + replaced(faces, "\n", "\r\n"))));

  CHECK(ends_as(Format::off, corners + faces, "bad-magic"));
  CHECK(ends_as(Format::off, "4OFF\n4 4 6\n", "unsupported-format"));
  CHECK(ends_as(Format::off, "OFF BINARY\n", "unsupported-format"));
  CHECK(ends_as(Format::off, "OFF\n0 0 0\n", "empty-mesh"));
  CHECK(ends_as(Format::off, "OFF\n4\n", "truncated"));
  CHECK(ends_as(Format::off, "OFF\n4 4 6\n" + corners + "3 0 2 1\n3 0 1", "truncated"));
  CHECK(ends_as(Format::off, "OFF\n-4 4 6\n" + corners + faces, "parse", "line 2"));
  CHECK(ends_as(Format::off, "OFF\n18446744073709551615 4 6\n", "parse"));
  CHECK(ends_as(Format::off, "OFF\n2147483648 4 6\n" + corners + faces, "truncated", "2147483648 vertices"));
  CHECK(ends_as(Format::off, "OFF\n4 4 6\n" + corners + replaced(faces, "3 1 2 3", "3 1 2 4"), "index-range",
                "line 9: vertex index 4 of 4"));
  CHECK(
      ends_as(Format::off, "OFF\n4 4 6\n" + corners + replaced(faces, "3 1 2 3", "3 1 2 -1"), "index-range", "line 9"));
  CHECK(ends_as(Format::off, "OFF\n4 4 6\n" + corners + replaced(faces, "3 1 2 3", "3 1 2 1.5"), "parse", "line 9"));
  CHECK(ends_as(Format::off, "OFF\n4 4 6\n" + corners + replaced(faces, "3 1 2 3", "4 1 2 3 1"), "degenerate-face",
                "line 9"));
}

TEST_CASE("PLY: elements and properties in any order and of any type, in all three forms") {
  const std::string head =
      "element odd 2\nproperty list uchar short a\nproperty double b\nelement vertex 4\nproperty uchar red\n"
      "property float x\nproperty list uint8 float tags\nproperty float64 y\nproperty short z\nelement face 4\n"
      "property int flags\nproperty list uchar uint vertex_index\nend_header\n";
  const Mesh text = read_text(Format::ply, "ply\nformat ascii 1.0\ncomment format binary_little_endian 1.0\n" + head +
                                               "2 5 6 0.5\n0 1.5\n"
                                               "9 0 0 0 0\n9 1 1 7 0 0\n9 0 2 7 8 1 0\n9 0 0 0 1\n"
                                               "1 3 0 2 1\n1 3 0 1 3\n1 3 1 2 3\n1 3 0 3 2\n");
  CHECK(is_tetrahedron(text));
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const auto put = [order](auto x) { return bytes_of(x, order); };
    std::string binary = std::string("ply\nformat ") +
                         (order == std::endian::little ? "binary_little_endian" : "binary_big_endian") + " 1.0\n" +
                         head;
    binary += put(std::uint8_t{2}) + put(std::int16_t{5}) + put(std::int16_t{6}) + put(0.5);
    binary += put(std::uint8_t{0}) + put(1.5);
    for (const Vector3& p : text.positions) {
      binary += put(std::uint8_t{9}) + put(static_cast<float>(p.x())) + put(std::uint8_t{1}) + put(7.0F) + put(p.y()) +
                put(static_cast<std::int16_t>(p.z()));
    }
    for (const Triangle& t : tetrahedron_triangles)
      binary += put(1) + put(std::uint8_t{3}) + put(t[0]) + put(t[1]) + put(t[2]);
    ReadReport report;
    CHECK(is_tetrahedron(read_text(Format::ply, binary, {}, &report)));
    CHECK(report.format == (order == std::endian::little ? "PLY, binary, little-endian" : "PLY, binary, big-endian"));
    CHECK(ends_as(Format::ply, std::string_view(binary).substr(0, binary.size() - 1), "truncated", "byte"));
  }
}

TEST_CASE("PLY: strips of triangles turn every other one round, and start again at -1") {
  const Mesh mesh = read_text(Format::ply,
                              "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
                              "float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                              "0 0 0\n1 0 0\n0 1 0\n0 0 1\n10 0 1 2 3 -1 0 2 2 1 3\n");
  const std::array<Triangle, 3> expected = {{{0, 1, 2}, {2, 1, 3}, {2, 1, 3}}};
  CHECK(std::equal(mesh.triangles.begin(), mesh.triangles.end(), expected.begin(), expected.end()));
}

TEST_CASE("PLY: what is wrong is refused with its line") {
  const std::string good =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  CHECK(outcome(Format::ply, good) == "accept");
  const auto with = [&](std::string_view what, std::string_view by) { return replaced(good, what, by); };
  CHECK(ends_as(Format::ply, with("ply\n", "plyx\n"), "bad-magic"));
  CHECK(ends_as(Format::ply, with("ascii", "utf8"), "parse", "line 2"));
  CHECK(ends_as(Format::ply, with("float y", "quad y"), "parse", "line 5"));
  CHECK(ends_as(Format::ply, with("list uchar", "list float"), "parse", "line 8"));
  CHECK(ends_as(Format::ply, with("float x", "float w"), "missing-attribute"));
  CHECK(ends_as(Format::ply, with("vertex_indices", "corners"), "missing-attribute"));
  CHECK(ends_as(Format::ply, with("vertex 3", "vertex -3"), "parse", "line 3"));
  CHECK(ends_as(Format::ply, with("vertex 3", "vertex 4294967295"), "truncated"));
  CHECK(ends_as(Format::ply, with("3 0 1 2", "-1 0 1 2"), "parse", "line 13"));
  CHECK(ends_as(Format::ply, with("3 0 1 2", "4294967295 0 1 2"), "truncated"));
  CHECK(ends_as(Format::ply, with("3 0 1 2", "3 0 1 3"), "index-range", "line 13"));
  CHECK(ends_as(Format::ply, with("3 0 1 2", "3 0 1 18446744073709551618"), "index-range", "line 13"));
  CHECK(ends_as(Format::ply, with("3 0 1 2", "2 0 1"), "parse", "line 13"));
  CHECK(ends_as(Format::ply, with("0 1 0\n", "0 nan 0\n"), "non-finite", "line 12"));
  CHECK(ends_as(Format::ply, with("end_header", "end"), "truncated"));
  CHECK(ends_as(Format::ply, "ply\nformat ascii 1.0\nelement vertex 3\n", "truncated"));
}

TEST_CASE("STL: both forms are distinguished, and their corners are joined") {
  std::string text = "solid two words\n";
  std::string binary = std::string("solid, but binary").append(63, ' ') + bytes_of(std::uint32_t{4});
  const Mesh surface = read_text(Format::obj, corners_obj + faces_obj);
  for (const Triangle& t : surface.triangles) {
    text += " facet normal 0 0 0\n  outer loop\n";
    binary += std::string(12, '\0');
    for (const Index v : t) {
      const Vector3& p = surface.positions[v];
      text += "   vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
      for (const double x : p)
        binary += bytes_of(static_cast<float>(x));
    }
    text += "  endloop\n endfacet\n";
    binary += "ab";
  }
  text += "endsolid two words\n";
  for (const std::string& file : {text, binary, replaced(text, "\n", "\r\n")}) {
    ReadReport report;
    const Mesh mesh = read_text(Format::stl, file, {}, &report);
    CHECK(mesh.positions.size() == 4);
    CHECK(mesh.triangles.size() == 4);
    CHECK(report.welded_vertices == 8);
    CHECK(report.format == (file == binary ? "STL, binary" : "STL, ASCII"));
  }
  CHECK(ends_as(Format::stl, std::string_view(text).substr(0, text.size() / 2), "truncated", "line"));
  CHECK(ends_as(Format::stl, std::string_view(binary).substr(0, binary.size() - 1), "truncated", "byte"));
  // Padding is passed over, a facet more than the file counts is not.
  for (const std::string& padding : {std::string("x"), std::string(50, '\0'), std::string(428, '\0')}) {
    ReadReport report;
    CHECK(read_text(Format::stl, binary + padding, {}, &report).triangles.size() == 4);
    CHECK(report.notes == std::vector{base::counted(padding.size(), "byte behind the last facet was",
                                                    "bytes behind the last facet were") +
                                      " passed over"});
  }
  CHECK(ends_as(Format::stl, binary + std::string(50, 'x'), "trailing-data", "byte"));
  CHECK(ends_as(Format::stl, replaced(text, "endloop", "endlop"), "parse", "line 7"));
  std::string infinite = binary;
  infinite.replace(84 + 12, 4, bytes_of(HUGE_VALF));
  CHECK(ends_as(Format::stl, infinite, "non-finite", "facet 0"));
  std::string one_point = binary.substr(0, 80) + bytes_of(std::uint32_t{1}) + std::string(50, '\0');
  CHECK(ends_as(Format::stl, one_point, "degenerate-geometry", "two corners at one position"));
}

TEST_CASE("Identical positions are joined on request where the surface is open, and stay where it is closed") {
  const std::string loose =
      corners_obj + corners_obj + corners_obj + corners_obj + "f 1 3 2\nf 5 6 8\nf 10 11 12\nf 13 16 15\n";
  ReadReport report;
  CHECK(read_text(Format::obj, loose, {.weld_identical = false}, &report).positions.size() == 16);
  CHECK(report.welded_vertices == 0);
  CHECK(read_text(Format::obj, loose, {.weld_identical = true}, &report).positions.size() == 4);
  CHECK(report.welded_vertices == 12);
  const std::string closed = replaced(corners_obj, "v 0 0 1", "v 0 0 0") + faces_obj;
  CHECK(read_text(Format::obj, closed, {.weld_identical = true}, &report).positions.size() == 4);
}
