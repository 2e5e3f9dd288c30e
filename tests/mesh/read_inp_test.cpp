// The reader of Abaqus and CalculiX files: elements of each shape, how lines may be written, and what is refused.
#include <doctest/doctest.h>

#include "mesh/formats/inp/inp_elements.h"
#include "read_text.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

const std::string nodes =
    "** made by hand\n*Heading\nany text, with *commas\n*NODE, NSET=ALL\n"
    "11, 0, 0, 0\n12, 1., 0, 0\n13,1,1,0.0E+00\n14,,1\n\n25,0,0,1\n 26 , 1 , 0 , 1 ,\n27,1,1,1\n28,0,1,+1\n7,.5,.5,2\n";
const std::string hexahedron = "*element, type=C3D8R,\n elset = Cube\n1, 11, 12, 13, 14, 25,\n26, 27, 28\n";

}  // namespace

TEST_CASE("Abaqus: solids, shells, and lines as tags, with lines of data and keywords that go on") {
  ReadReport report;
  const Mesh mesh =
      read_text(Format::inp,
                nodes + hexahedron +
                    "*Element, type=S4R\r\n2, 25, 26, 27, 28\n** text\n*ELEMENT,TYPE=B31\n3, 11, 12\n"
                    "*ELEMENT, TYPE=SPRING1\n4, 11\n*Material, name=steel\n*Elastic\n2.1e5, 0.3\n*Step\n*End Step\n",
                {.feature_tags = true}, &report);
  CHECK(mesh.positions.size() == 9);
  CHECK(mesh.positions[3] == Vector3(0, 1, 0));
  CHECK(mesh.positions[8] == Vector3(.5, .5, 2));
  CHECK(mesh.hexahedra == Array<Hexahedron>{{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(mesh.triangles == Array<Triangle>{{4, 5, 6}, {4, 6, 7}});
  CHECK(report.polygons == 1);
  CHECK(report.tags->edges == std::vector<std::array<Index, 2>>{{0, 1}});
  REQUIRE(!report.notes.empty());
  CHECK(report.notes.back() == "left out: 1 element of points or lines, 4 other keywords");
}

TEST_CASE("Abaqus: pyramids and prisms are cut with the cells beside them, and elements may come first") {
  const Mesh mesh =
      read_text(Format::inp, hexahedron + "*ELEMENT, TYPE=C3D5\n2, 25, 26, 27, 28, 7\n" + nodes +
                                 "30,2,0,0\n31,2,0,1\n" + "*ELEMENT, TYPE=C3D6\n3, 12, 30, 13, 26, 31, 27\n");
  double volume = 0;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    const auto p = [&](std::size_t k) { return mesh.positions[t[k]]; };
    volume += (p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0)) / 6;
  }
  CHECK(mesh.hexahedra.empty());
  CHECK(volume == doctest::Approx(1 + 1 / 3. + .5));
}

TEST_CASE("Abaqus: one part with its instance is read, without the reference points of the assembly") {
  const std::string assembly =
      "*Assembly, name=A\n*Instance, name=I, part=P\n1., 0., 0.\n*End Instance\n*Node\n11, 5, 5, 5\n*End Assembly\n";
  ReadReport report;
  const Mesh mesh =
      read_text(Format::inp, "*Part, name=P\n" + nodes + hexahedron + "*End Part\n" + assembly, {}, &report);
  CHECK(mesh.positions.size() == 9);
  CHECK(mesh.hexahedra.size() == 1);
  CHECK(report.notes.back() == "left out: 1 section of the assembly");
  const Mesh in_instance =
      read_text(Format::inp, "*Part, name=P\n*End Part\n*Assembly, name=A\n*Instance, name=I, part=P\n" + nodes +
                                 hexahedron + "*End Instance\n*End Assembly\n");
  CHECK(in_instance.hexahedra == mesh.hexahedra);
  const std::string part = "*Part, name=P\n" + nodes + hexahedron + "*End Part\n";
  CHECK(ends_as(Format::inp, part + part, "unsupported", "several parts"));
  CHECK(ends_as(Format::inp, part + assembly + assembly, "unsupported", "several instances"));
}

TEST_CASE("Abaqus: the shape of each type of elements") {
  for (const char* type : {"C3D4", "C3D4H", "DC3D4", "AC3D4", "F3D4"})
    CHECK(inp_shape(type) == InpShape::tetrahedron);
  for (const char* type : {"C3D8", "C3D8R", "C3D8RH", "C3D8I", "DC3D8", "SC8R", "COH3D8"})
    CHECK(inp_shape(type) == InpShape::hexahedron);
  for (const char* type : {"S3", "S3R", "STRI3", "CPS3", "CPE3H", "M3D3", "R3D3", "SFM3D3", "CAX3", "DS3"})
    CHECK(inp_shape(type) == InpShape::triangle);
  for (const char* type : {"S4", "S4R", "S4R5", "CPS4", "CPEG4", "M3D4R", "R3D4", "CAX4R", "DC2D4"})
    CHECK(inp_shape(type) == InpShape::quadrilateral);
  for (const char* type : {"T3D2", "B31", "B21H", "T2D2"})
    CHECK(inp_shape(type) == InpShape::line);
  for (const char* type : {"MASS", "SPRINGA", "DASHPOT1", "CONN3D2", "B32", "T3D3", "PIPE31", "SAX1"})
    CHECK(inp_shape(type) == InpShape::passed_over);
  for (const char* type : {"C3D10", "C3D20R", "C3D15", "C3D27", "S8R", "S6", "STRI65", "CPS6", "M3D8", "C3D", "", "U1",
                           "C3D999999999999999999999"})
    CHECK_FALSE(inp_shape(type));
}

TEST_CASE("Abaqus: what cannot be read is refused with the place") {
  CHECK(ends_as(Format::inp, "solid\n", "bad-magic"));
  CHECK(ends_as(Format::inp, "*INCLUDE, INPUT=mesh.inp\n", "unsupported", "MESH.INP"));
  CHECK(ends_as(Format::inp, "*NODE, INPUT=nodes.txt\n", "unsupported", "NODES.TXT"));
  CHECK(ends_as(Format::inp, "*NODE, SYSTEM=C\n1, 1, 90, 0\n", "unsupported", "cylindrical"));
  CHECK(ends_as(Format::inp, "*NODE\n1, 0, 0, 0\n*NGEN\n1, 11\n", "unsupported", "*NGEN"));
  CHECK(ends_as(Format::inp, "*NODE\n1, 0, nan, 0\n", "non-finite", "line 2"));
  CHECK(ends_as(Format::inp, "*NODE\n1, 0, 1e999, 0\n", "non-finite", "line 2"));
  CHECK(ends_as(Format::inp, "*NODE\n1\n", "parse", "without coordinates"));
  CHECK(ends_as(Format::inp, "*NODE\n-1, 0, 0, 0\n", "parse", "'-1'"));
  CHECK(ends_as(Format::inp, "*NODE\n99999999999999999999, 0, 0, 0\n", "index-range"));
  CHECK(ends_as(Format::inp, "*NODE\n1, 0, 0, 0\n1, 1, 0, 0\n", "parse", "two nodes have the number 1"));
  CHECK(ends_as(Format::inp, "*NODE,\n", "truncated"));
  CHECK(ends_as(Format::inp, "*NODE\n1, 0, 0, 0\n", "empty-mesh"));
  const auto with = [](const char* elements) { return nodes + "*ELEMENT, " + elements; };
  CHECK(ends_as(Format::inp, with("ELSET=A\n1, 11, 12, 13\n"), "parse", "TYPE"));
  CHECK(ends_as(Format::inp, with("TYPE=C3D10\n"), "unsupported", "'C3D10'"));
  CHECK(ends_as(Format::inp, with("TYPE=S3\n1, 11, 12, 99\n"), "index-range", "element 1: there is no node 99"));
  CHECK(ends_as(Format::inp, with("TYPE=S3\n1, 11, 12, 0\n"), "index-range", "no node 0"));
  CHECK(ends_as(Format::inp, with("TYPE=S3\n1, 11, 12"), "truncated"));
  CHECK(ends_as(Format::inp, with("TYPE=S3\n1, 11, 12\n*STEP\n"), "parse", "a keyword"));
  CHECK(ends_as(Format::inp, with("TYPE=S3\n1, 11, 12, 13, 14\n"), "parse", "more than the 3 nodes"));
}
