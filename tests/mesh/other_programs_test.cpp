// Files as other programs write them: what is odd in them is read, and what is not kept of them is reported once.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "read_text.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

using Notes = std::vector<std::string>;

const std::string byte_order_mark = "\xEF\xBB\xBF";

// A tetrahedron as ASCII STL.
std::string stl() {
  std::string text = "solid part\n";
  const std::array<Vector3, 4> p = {Vector3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Triangle& t : {Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const Index v : t)
      text +=
          "vertex " + std::to_string(p[v].x()) + " " + std::to_string(p[v].y()) + " " + std::to_string(p[v].z()) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid part\n";
}

std::string in_capitals(std::string text) {
  for (char& c : text)
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c;
  return text;
}

Notes notes_of(Format format, const std::string& text, std::size_t triangles, std::size_t tetrahedra = 0) {
  ReadReport report;
  const Mesh mesh = read_text(format, text, {}, &report);
  CHECK(mesh.positions.size() == 4);
  CHECK(mesh.triangles.size() == triangles);
  CHECK(mesh.tetrahedra.size() == tetrahedra);
  return report.notes;
}

const std::string vtk_solid =
    "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n"
    "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n";
const std::string medit_solid =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra\n1\n1 2 3 4 0\n"
    "End\n";

}  // namespace

TEST_CASE("ASCII STL: keywords in two words, in capitals, on one line, after tabs and marks") {
  for (const std::string& text :
       {stl(), replaced(stl(), "endloop", "end loop"),
        replaced(replaced(replaced(stl(), "endloop", "end\tloop"), "endfacet", "End Facet"), "endsolid", "END SOLID"),
        in_capitals(stl()), "\n \t" + replaced(stl(), "vertex", "\t\tVertex"), byte_order_mark + stl(),
        byte_order_mark + in_capitals(stl()), replaced(stl(), "\n", "\r\n"), replaced(stl(), "\n", "\r"),
        replaced(replaced(stl(), "0\nouter loop\n", "0 outer loop "), "\nendloop\n", " endloop "),
        replaced(stl(), "normal 0 0 0", "normal nan -nan(ind) inf"), replaced(stl(), "part", "a vertex, a facet \xFC"),
        replaced(stl(), "solid part\n", "solid\n"), stl() + "\n\n", stl() + std::string("\x1A\0\0\0", 4)}) {
    CAPTURE(text);
    CHECK(notes_of(Format::stl, text, 4).empty());
  }
}

TEST_CASE("ASCII STL: several solids, words behind endsolid, and no endsolid behind a closed surface") {
  ReadReport report;
  const std::string moved = replaced(replaced(stl(), "vertex 0.0", "vertex 5.0"), "part", "second");
  CHECK(read_text(Format::stl, stl() + moved, {}, &report).triangles.size() == 8);
  CHECK(notes_of(Format::stl, stl() + "made by a program\n2 lines\n", 4) ==
        Notes{"2 lines behind endsolid were passed over"});
  const std::string open = replaced(stl(), "endsolid part\n", "");
  CHECK(notes_of(Format::stl, open, 4) == Notes{"the file ends without endsolid"});
  const std::string half = open.substr(0, open.rfind("facet normal"));
  CHECK(ends_as(Format::stl, half, "truncated", "before endsolid"));
  CHECK(ends_as(Format::stl, open.substr(0, open.rfind("endfacet")), "truncated", "inside a facet"));
  CHECK(ends_as(Format::stl, replaced(stl(), "endloop\nendfacet", "endloop"), "parse", "facet inside a facet"));
}

TEST_CASE("A byte order mark before any text format, and keywords in letters of any size") {
  CHECK(notes_of(Format::obj, byte_order_mark + "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n", 1).empty());
  CHECK(notes_of(Format::off, byte_order_mark + "off\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n", 1).empty());
  CHECK(notes_of(Format::ply,
                 byte_order_mark + "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                                   "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                                   "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n",
                 1)
            .empty());
  for (const std::string& text : {medit_solid, in_capitals(medit_solid), replaced(medit_solid, "T", "t")}) {
    CHECK(notes_of(Format::medit, text, 0, 1).empty());
    CHECK(notes_of(Format::medit, byte_order_mark + text, 0, 1).empty());
  }
  for (const std::string& text : {vtk_solid, replaced(vtk_solid, "CELL", "cell"),
                                  replaced(vtk_solid, "DATASET UNSTRUCTURED_GRID", "dataset unstructured_grid"),
                                  replaced(vtk_solid, "float", "FLOAT")}) {
    CHECK(notes_of(Format::vtk, text, 0, 1).empty());
    CHECK(notes_of(Format::vtk, byte_order_mark + text, 0, 1).empty());
  }
}

TEST_CASE("ASCII PLY: properties that are not read are not judged, and faces may come before vertices") {
  const std::string head = "ply\nformat ascii 1.0\n";
  const std::string vertices =
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float q\n";
  const std::string faces = "element face 2\nproperty list uchar int vertex_indices\nproperty float quality\n";
  const std::string points = "0 0 0 nan 1e999\n1 0 0 -nan -inf\n0 1 0 -nan(ind) 1.#QNAN\n0 0 1 0 0\n";
  const std::string triangles = "3 0 1 2 nan\n3 0 3 1 inf\n";
  const Notes left = {"left out: 3 properties of vertices and faces (nx q quality)"};
  CHECK(notes_of(Format::ply, head + vertices + faces + "end_header\n" + points + triangles, 2) == left);
  const Notes reversed = {"left out: 3 properties of vertices and faces (quality nx q)"};
  const std::string first = head + faces + vertices + "end_header\n" + triangles + points;
  CHECK(notes_of(Format::ply, first, 2) == reversed);
  CHECK(ends_as(Format::ply, replaced(first, "3 0 3 1", "3 0 4 1"), "index-range", "vertex index 4 of 4"));
  CHECK(ends_as(Format::ply, replaced(first, "vertex 4", "vertex 5"), "truncated"));
  CHECK(ends_as(Format::ply, head + faces + "end_header\n" + triangles, "index-range", "0 of 0"));
  CHECK(
      ends_as(Format::ply, head + faces + "element vertex 4\nend_header\n" + triangles + points, "missing-attribute"));
  CHECK(ends_as(Format::ply, head + vertices + vertices + faces + "end_header\n" + points + points + triangles, "parse",
                "comes twice"));
  const std::string edges = "element edge 1\nproperty int vertex1\nproperty int vertex2\n";
  CHECK(notes_of(Format::ply, head + vertices + faces + edges + "end_header\n" + points + triangles + "0 1\n", 2) ==
        Notes{"left out: 3 properties of vertices and faces, 1 other element (nx q quality 1 edge)"});
}

TEST_CASE("MEDIT: references as real numbers, which count where they differ, and numbers that are none") {
  for (const char* reference : {" 0.0\n", " 1e0\n", " -7.\n", " 3\n"})
    CHECK(notes_of(Format::medit, replaced(medit_solid, " 0\n", reference), 0, 1).empty());
  CHECK(notes_of(Format::medit, replaced(medit_solid, "0 0 1 0\n", "0 0 1 2.5\n"), 0, 1) ==
        Notes{"left out: 4 reference numbers of vertices or edges"});
  CHECK(notes_of(Format::medit, replaced(medit_solid, "End", "Normals\n1\nnan NaN -inf\nRidges\n1\n1\nEnd"), 0, 1) ==
        Notes{"sections passed over: 'Normals', 'Ridges'"});
  CHECK(ends_as(Format::medit, replaced(medit_solid, "1 2 3 4 0", "1 2 3 4 x"), "parse", "a reference expected"));
}

TEST_CASE("Cells that are not read are refused with their number, in every section that can hold them") {
  for (const char* section : {"TetrahedraP2", "TRIANGLESP3", "HexahedraQ2", "PrismsP2", "Polyhedra", "Polygons"}) {
    CAPTURE(section);
    const std::string with = replaced(medit_solid, "End", section + std::string("\n2\n1 2 3 4\n1 2 3 4\nEnd"));
    CHECK(ends_as(Format::medit, with, "unsupported", "2 cells in the section"));
    CHECK(outcome(Format::medit, replaced(medit_solid, "End", section + std::string("\n0\nEnd"))) == "accept");
  }
  CHECK(outcome(Format::medit, replaced(medit_solid, "End", "EdgesP2\n1\n1 2 3 0\nEnd")) == "accept");
  CHECK(ends_as(Format::vtk,
                replaced(replaced(vtk_solid, "CELLS 1 5\n", "CELLS 4 18\n3 0 1 2\n4 0 1 2 3\n3 0 1 2\n"), "1\n10\n",
                         "4\n22\n24\n22\n10\n"),
                "unsupported", "2 of type 22 (quadratic triangle), 1 of type 24 (quadratic tetrahedron)"));
}

TEST_CASE("What decorates a surface is reported in one note") {
  CHECK(notes_of(Format::obj,
                 "mtllib a.mtl\no thing\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1\nv 0 0 1\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
                 "g\nusemtl red\nf 1/1/1 2/2/1 3/1/1\n",
                 1) == Notes{"left out: 2 texture coordinates, 1 normal, 2 vertex colors, 1 use of a material, "
                             "1 name of a group or object"});
  CHECK(notes_of(Format::obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nl 1 2\np 1\nsurf 0 1 0 1 1 2 3\n", 1) ==
        Notes{"2 lines and points were passed over", "1 curve or surface of free form was passed over"});
  CHECK(notes_of(Format::off, "COFF\n4 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n0 0 1 1 0 0 1\n3 0 1 2 9\n",
                 1) == Notes{"left out: 4 colors, normals or texture coordinates of vertices, 1 color of a face"});
  CHECK(notes_of(Format::vtk,
                 vtk_solid + "POINT_DATA 4\nSCALARS s float 1\nLOOKUP_TABLE default\n1 2 3 4\nVECTORS v float\n"
                             "0 0 0 0 0 0 0 0 0 0 0 0\nCELL_DATA 1\nFIELD FieldData 2\na 1 1 int\n1\nb 1 1 int\n2\n",
                 0, 1) == Notes{"left out: 4 data arrays"});
}

TEST_CASE("Cells that are all inverted are reversed with a note, others are not") {
  const std::string turned = replaced(medit_solid, "1 2 3 4 0", "1 3 2 4 0");
  ReadReport report;
  const Mesh mesh = read_text(Format::medit, turned, {}, &report);
  CHECK(mesh.tetrahedra == Array<Tetrahedron>{{0, 1, 2, 3}});
  CHECK(report.notes == Notes{"the only tetrahedron was inverted, and was reversed"});
  CHECK(ends_as(Format::medit, replaced(turned, "1\n1 3 2 4 0\n", "2\n1 3 2 4 0\n1 2 3 4 0\n"), "inverted-cell"));
}

TEST_CASE("Vertices of solids at one position are welded on request") {
  const std::string apart =
      "Vertices 8\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 -1 0\n"
      "Tetrahedra 2\n1 2 3 4 0\n5 7 6 8 0\n";
  ReadReport report;
  CHECK(read_text(Format::medit, apart, {}, &report).positions.size() == 8);
  const Mesh joined = read_text(Format::medit, apart, {.weld_identical = true}, &report);
  CHECK(joined.positions.size() == 5);
  CHECK(report.welded_vertices == 3);
  CHECK(joined.tetrahedra == Array<Tetrahedron>{{0, 1, 2, 3}, {0, 2, 1, 4}});
  CHECK(report.notes.empty());
}

TEST_CASE("OBJ: faces written fo or in capitals are read, and lines that no OBJ file has are reported") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  CHECK(notes_of(Format::obj, vertices + "fo 1 3 2\nF 1 2 4\nf 2 3 4\nf 1 4 3\n", 4).empty());
  CHECK(notes_of(Format::obj, in_capitals(vertices) + "F 1 3 2\n", 1).empty());
  const Notes notes = notes_of(Format::obj, vertices + "f 1 3 2\nface 1 2 4\nbogus\n", 1);
  CHECK(notes == Notes{"2 lines were passed over that no OBJ file has (line 6: 'face')"});
}

TEST_CASE("files in another wrapping are named as such, whatever their ending") {
  const std::string zeros(300, '\0');
  std::string utf_16;
  for (const char c : stl())
    utf_16 += std::string{c, '\0'};
  for (const Format format : {Format::stl, Format::obj, Format::off, Format::ply, Format::medit, Format::vtk}) {
    CAPTURE(static_cast<int>(format));
    CHECK(ends_as(format, "\x1F\x8B\x08" + zeros, "unsupported-format", "gzip"));
    CHECK(ends_as(format, "PK\x03\x04" + zeros, "unsupported-format", "zip"));
    CHECK(ends_as(format, utf_16, "unsupported-format", "UTF-16"));
    CHECK(ends_as(format, "\xFF\xFE" + utf_16, "unsupported-format", "UTF-16"));
  }
  CHECK(ends_as(Format::medit, std::string("\1\0\0\0\2\0\0\0", 8) + zeros, "unsupported-format", "binary MEDIT"));
}

TEST_CASE("ASCII STL: without a first solid, and all on one line") {
  CHECK(notes_of(Format::stl, replaced(stl(), "solid part\nfacet", "facet"), 4).empty());
  CHECK(notes_of(Format::stl, replaced(stl(), "\n", " "), 4).empty());
  CHECK(outcome(Format::stl, "# by a program\n" + stl()).starts_with("parse: line 1"));
}

TEST_CASE("numbers: exponents of Fortran, and whole numbers with a decimal point") {
  CHECK(notes_of(Format::medit, replaced(medit_solid, "1 0 0 0\n", "1.0D+00 0.0d0 0 0\n"), 0, 1).empty());
  CHECK(notes_of(Format::medit, replaced(medit_solid, "1 2 3 4 0", "1.0 2.0 3.0 4.0 0"), 0, 1).empty());
  CHECK(ends_as(Format::medit, replaced(medit_solid, "1 2 3 4 0", "1.5 2 3 4 0"), "parse", "1.5"));
  CHECK(ends_as(Format::medit, replaced(medit_solid, "1 0 0 0\n", "1.0D 0 0 0\n"), "parse", "1.0D"));
}
