// The readers of MEDIT and legacy VTK.
#include <doctest/doctest.h>

#include <bit>
#include <cstring>

#include "read_text.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

const std::string medit_points =
    "MeshVersionFormatted 2\nDimension\n3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 7\n0 0 1 0\n";
const std::string vtk_points = "DATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0\n0 1 0\n0 0 1\n";
const std::string vtk_head = "# vtk DataFile Version 3.0\nany title\nASCII\n";

// A number as it stands in a binary VTK file.
std::string big_endian(auto number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  if (std::endian::native == std::endian::little) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

}  // namespace

TEST_CASE("MEDIT: all kinds of cells, comments, and sections that are of no interest") {
  ReadReport report;
  const Mesh mesh = read_text(
      Format::medit,
      "MeshVersionFormatted 1 # comment\n\nDimension 3\nVertices 9\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n"
      "1 0 1 0\n1 1 1 0\n0 1 1 0\n0.5 0.5 2 0\nCorners\n2\n1 2\nTriangles\n1\n1 3 2 5\nQuadrilaterals 1\n1 2 6 5 9\n"
      "RequiredVertices 1\n-1\nHexahedra 1\n1 2 3 4 5 6 7 8 0\nTetrahedra\n2\n5 6 7 9 1\n5 7 8 9 2\nEnd\nanything",
      {}, &report);
  CHECK(mesh.positions.size() == 9);
  CHECK(mesh.triangles.size() == 3);
  CHECK(mesh.triangles[0] == Triangle{0, 2, 1});
  CHECK(mesh.hexahedra == Array<Hexahedron>{{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(mesh.tetrahedra == Array<Tetrahedron>{{4, 5, 6, 8}, {4, 6, 7, 8}});
  CHECK(report.polygons == 1);
  CHECK(report.notes == std::vector<std::string>{"sections passed over: 'Corners', 'RequiredVertices'"});
  CHECK(mesh.regions.triangles == Array<std::int32_t>{5, 9, 9});
  CHECK(mesh.regions.tetrahedra == Array<std::int32_t>{1, 2});
  CHECK(mesh.regions.hexahedra.empty());
}

TEST_CASE("Marked edges and vertices are kept on request") {
  using Edges = std::vector<std::array<Index, 2>>;
  const auto tags = [](Format format, const std::string& text) {
    ReadReport report;
    read_text(format, text, {.feature_tags = true}, &report);
    for (const std::string& note : report.notes)
      CHECK(note.find("passed over") == std::string::npos);
    return *report.tags;
  };
  const std::string tetrahedron = "Tetrahedra 1\n1 2 3 4 0\n", edges = "Edges 3\n1 2 7\n2 3 7\n4 4 8\n";
  const FeatureTags all = tags(Format::medit, medit_points + tetrahedron + edges);
  CHECK(all.edges == Edges{{0, 1}, {1, 2}});
  const FeatureTags some = tags(Format::medit, medit_points + "Ridges 1\n2\nCorners 2\n1 4\nRequiredVertices 1\n2\n" +
                                                   tetrahedron + edges + "RequiredEdges 1\n2\n");
  CHECK(some.edges == Edges{{1, 2}, {1, 2}});
  CHECK(some.vertices == std::vector<Index>{0, 3, 1});
  for (const char* ridges : {"Ridges 1\n4\n", "Ridges 1\n0\n", "Corners 1\n5\n"}) {
    try {
      read_text(Format::medit, medit_points + tetrahedron + edges + ridges, {.feature_tags = true});
      CHECK(false);
    } catch (const base::Error& error) {
      CHECK(std::string(error.kind()) == "index-range");
    }
  }
  const FeatureTags lines =
      tags(Format::vtk, vtk_head +
                            "DATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n"
                            "CELLS 4 14\n4 0 1 2 3\n2 0 1\n3 1 2 3\n1 2\nCELL_TYPES 4\n10 3 4 1\n");
  CHECK(lines.edges == Edges{{0, 1}, {1, 2}, {2, 3}});
  CHECK(lines.vertices == std::vector<Index>{2});
  const FeatureTags polydata = tags(Format::vtk, vtk_head +
                                                     "DATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n"
                                                     "VERTICES 1 2\n1 2\nLINES 1 3\n2 0 1\nPOLYGONS 1 4\n3 0 1 2\n");
  CHECK(polydata.edges == Edges{{0, 1}});
  CHECK(polydata.vertices == std::vector<Index>{2});
  const FeatureTags obj = tags(Format::obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2 -1\np 2\n");
  CHECK(obj.edges == Edges{{0, 1}, {1, 2}});
  CHECK(obj.vertices == std::vector<Index>{1});
}

TEST_CASE("MEDIT: the version and the End may be missing, lines may end anywhere") {
  CHECK(outcome(Format::medit, "Vertices 3 0 0 0 0 1 0 0 0 0 1 0 0 Triangles 1 1 2 3 0") == "accept");
  CHECK(outcome(Format::medit, medit_points + "Tetrahedra\r\n1\r\n1 2 3 4 0") == "accept");
}

TEST_CASE("MEDIT: what is wrong is refused with its line, and cells that are those of no solid") {
  CHECK(ends_as(Format::medit, medit_points + "Tetrahedra\n1\n1 2 3 5 0\nEnd\n", "index-range",
                "line 12: vertex index 5"));
  CHECK(ends_as(Format::medit, medit_points + "Tetrahedra\n1\n0 2 3 4 0\nEnd\n", "index-range", "counted from 1"));
  CHECK(ends_as(Format::medit, medit_points + "Tetrahedra\n1\n1 2 3 4", "truncated"));
  CHECK(ends_as(Format::medit, medit_points + "Tetrahedra\n9000000000\n1 2 3 4 0\nEnd\n", "truncated", "9000000000"));
  CHECK(ends_as(Format::medit, medit_points + "Tetrahedra\n-1\nEnd\n", "parse", "line 11"));
  CHECK(ends_as(Format::medit, medit_points + "End\n", "empty-mesh"));
  CHECK(ends_as(Format::medit, "Dimension 2\n", "unsupported-format"));
  CHECK(ends_as(Format::medit, "Triangles 1\n1 2 3 0\n", "parse", "before the section Vertices"));
  CHECK(ends_as(Format::medit, "Vertices 1\n0 0 inf 0\n", "non-finite", "line 2"));
  CHECK(ends_as(Format::medit, medit_points + "1 2 3\n", "parse", "line 10"));
  CHECK(ends_as(Format::medit, medit_points + "Tetrahedra 2\n1 3 2 4 0\n1 2 3 4 0\n", "inverted-cell"));
  CHECK(ends_as(Format::medit, medit_points + "Tetrahedra 1\n1 3 2 1 0\n", "degenerate-cell"));
  CHECK(ends_as(Format::medit, medit_points + "Quadrilaterals 1\n1 3 2 1 0\n", "degenerate-face"));
}

TEST_CASE("VTK: surfaces of polygons and strips; data, fields and lines are passed over") {
  const Mesh mesh =
      read_text(Format::vtk, vtk_head +
                                 "DATASET POLYDATA\nFIELD FieldData 1\nTIME 1 2 double\n0.5 1\n"
                                 "POINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\nVERTICES 1 2\n1 0\n"
                                 "LINES 1 3\n2 0 1\nPOLYGONS 1 5\n4 0 1 2 3\nTRIANGLE_STRIPS 1 5\n4 0 1 3 2\n"
                                 "POINT_DATA 4\nSCALARS s float\nLOOKUP_TABLE default\n1 2 3 nan\n");
  const std::array<Triangle, 4> expected = {{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {3, 1, 2}}};
  CHECK(std::equal(mesh.triangles.begin(), mesh.triangles.end(), expected.begin(), expected.end()));
}

TEST_CASE("VTK: grids, with every type that is read") {
  ReadReport report;
  const Mesh mesh =
      read_text(Format::vtk,
                vtk_head +
                    "DATASET UNSTRUCTURED_GRID\nPOINTS 12 float\n0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 "
                    "1 1 1\n0 0 2 1 0 2 0 1 2 1 1 2\nCELLS 8 43\n8 0 1 2 3 4 5 6 7\n8 4 5 7 6 8 9 11 10\n"
                    "3 0 1 2\n4 0 1 3 2\n4 0 1 2 3\n4 0 2 1 3\n2 0 1\n1 0\nCELL_TYPES 8\n11 12 5 9 8 6 3 1\n",
                {}, &report);
  CHECK(mesh.hexahedra == Array<Hexahedron>{{0, 1, 3, 2, 4, 5, 7, 6}, {4, 5, 7, 6, 8, 9, 11, 10}});
  CHECK(mesh.triangles.size() == 1 + 2 + 2 + 2);
  CHECK(report.notes.size() == 1);
  CHECK(ends_as(Format::vtk, vtk_head + vtk_points + "CELLS 2 10\n4 0 1 2 3\n4 0 1 2 3\nCELL_TYPES 2\n42 42\n",
                "unsupported", "2 of type 42 (polyhedron)"));
}

TEST_CASE("VTK: versions 4 and 5, ASCII and binary, hold the same tetrahedron") {
  const auto coordinates = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  std::string points = "DATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n";
  for (const double x : coordinates)
    points += big_endian(x);
  std::string old_cells = "\nCELLS 1 5\n", offsets = "\nCELLS 2 4\nOFFSETS vtktypeint64\n", indices;
  for (const std::int32_t i : {4, 0, 1, 2, 3})
    old_cells += big_endian(i);
  for (const std::int64_t i : {0, 4})
    offsets += big_endian(i);
  for (const std::int64_t i : {0, 1, 2, 3})
    indices += big_endian(i);
  const std::string types = "\nCELL_TYPES 1\n" + big_endian(std::int32_t{10}) + "\n";
  const auto head = [](const char* version, const char* form) {
    return "# vtk DataFile Version " + std::string(version) + "\n\n" + form + "\n";
  };
  const std::string binary = head("4.2", "BINARY") + points + old_cells + types;
  for (const std::string& file :
       {vtk_head + vtk_points + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n",
        head("5.1", "ASCII") + vtk_points +
            "METADATA\nINFORMATION 0\n\nCELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\n"
            "CELL_TYPES 1\n10\n",
        binary, head("5.1", "BINARY") + points + offsets + "\nCONNECTIVITY vtktypeint64\n" + indices + types}) {
    const Mesh mesh = read_text(Format::vtk, file);
    CHECK(mesh.positions.size() == 4);
    CHECK(mesh.tetrahedra == Array<Tetrahedron>{{0, 1, 2, 3}});
  }
  CHECK(ends_as(Format::vtk, std::string_view(binary).substr(0, binary.size() - 3), "truncated", "byte"));
}

TEST_CASE("VTK: what is wrong is refused") {
  const std::string cells = "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n";
  CHECK(ends_as(Format::vtk, "vtk\n", "bad-magic"));
  CHECK(ends_as(Format::vtk, "# vtk DataFile Version 3.0\ntitle\nTEXT\n", "parse", "line 3"));
  CHECK(ends_as(Format::vtk, "# vtk DataFile Version 3.0\ntitle", "truncated"));
  CHECK(ends_as(Format::vtk, vtk_head + "DATASET STRUCTURED_POINTS\n", "unsupported-format"));
  CHECK(ends_as(Format::vtk, vtk_head + "DATASET POLYDATA\nPOINTS 10000000000 float\n0 0 0\n", "truncated"));
  CHECK(ends_as(Format::vtk, vtk_head + "DATASET POLYDATA\nPOINTS 6148914691236517206 float\n0 0 0\n", "truncated"));
  CHECK(ends_as(Format::vtk, vtk_head + "DATASET POLYDATA\nPOINTS 1 float\n0 0 nan\n", "non-finite", "line 6"));
  CHECK(ends_as(Format::vtk, vtk_head + vtk_points + "CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n", "index-range"));
  CHECK(ends_as(Format::vtk, vtk_head + vtk_points + "CELLS 1 5\n5 0 1 2 3\nCELL_TYPES 1\n10\n", "parse"));
  CHECK(ends_as(Format::vtk, vtk_head + vtk_points + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n", "parse", "3 corners"));
  CHECK(ends_as(Format::vtk, vtk_head + vtk_points + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n10 10\n", "parse"));
  CHECK(ends_as(Format::vtk, vtk_head + vtk_points, "empty-mesh"));
  CHECK(outcome(Format::vtk, vtk_head + vtk_points + cells) == "accept");
}
