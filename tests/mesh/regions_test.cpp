// Region numbers of triangles and cells are what files say, in every format that holds them, and come back from it.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "mesh/files/write.h"
#include "mesh/regions/nearest_regions.h"
#include "mesh/regions/region_numbers.h"
#include "mesh/topology/weld.h"
#include "read_text.h"
#include "temporary_folder.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

using Numbers = Array<std::int32_t>;

// Two cubes with a pyramid of two tetrahedra on one, and faces.
Mesh solid_with_regions() {
  Mesh mesh;
  for (int i = 0; i < 12; ++i)
    mesh.positions.emplace_back(i / 2 % 3, i % 2, i / 6);
  mesh.positions.emplace_back(0.5, 0.5, 1.5);
  mesh.hexahedra.push_back({0, 2, 3, 1, 6, 8, 9, 7});
  mesh.hexahedra.push_back({2, 4, 5, 3, 8, 10, 11, 9});
  mesh.tetrahedra.push_back({6, 8, 9, 12});
  mesh.tetrahedra.push_back({6, 9, 7, 12});
  mesh.triangles = Array<Triangle>{{6, 8, 12}, {8, 9, 12}, {9, 7, 12}, {7, 6, 12}};
  mesh.regions.triangles = Numbers{4, 4, 17, 0};
  mesh.regions.tetrahedra = Numbers{2'000'000'000, 1};
  mesh.regions.hexahedra = Numbers{1, 3};
  return mesh;
}

Mesh surface_with_regions() {
  Mesh mesh = solid_with_regions();
  mesh.tetrahedra.clear();
  mesh.hexahedra.clear();
  mesh.regions.tetrahedra.clear();
  mesh.regions.hexahedra.clear();
  return mesh;
}

constexpr FileKind kinds_with_regions[] = {{"a.mesh", false}, {"a.vtk", false}, {"b.vtk", true},
                                           {"a.msh", false},  {"a.inp", false}, {"a.vtp", false},
                                           {"b.vtp", true},   {"a.vtu", false}, {"b.vtu", true}};

bool same(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles && a.tetrahedra == b.tetrahedra &&
         a.hexahedra == b.hexahedra && a.regions.triangles == b.regions.triangles &&
         a.regions.tetrahedra == b.regions.tetrahedra && a.regions.hexahedra == b.regions.hexahedra;
}

Numbers triangle_regions(Format format, const std::string& text, std::string* note = nullptr) {
  ReadReport report;
  const Mesh mesh = read_text(format, text, {}, &report);
  if (note) *note = report.notes.empty() ? "" : report.notes.back();
  return mesh.regions.triangles;
}

const std::string vtk_faces =
    "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\nPOINTS 5 float\n0 0 0 1 0 0 1 1 0 0 1 0 0 0 1\n"
    "VERTICES 1 2\n1 4\nLINES 1 3\n2 0 1\nPOLYGONS 2 9\n4 0 1 2 3\n3 0 1 4\n";

}  // namespace

TEST_CASE("Regions come back from every format that holds them, and other formats leave them out") {
  const TemporaryFolder folder;
  for (const FileKind& kind : kinds_with_regions) {
    CAPTURE(kind.file);
    REQUIRE(holds(kind.file, Holds::regions));
    for (const Mesh& mesh : {surface_with_regions(), solid_with_regions()}) {
      if (!mesh.hexahedra.empty() && !holds(kind.file, Holds::cells)) continue;
      write_mesh(folder / kind.file, mesh, {.binary = kind.binary}, base::Host());
      ReadReport report;
      CHECK(same(read_mesh(folder / kind.file, {}, base::Host(), &report), mesh));
      CHECK(report.notes.empty());
    }
  }
  write_mesh(folder / "a.ply", surface_with_regions(), {}, base::Host());
  CHECK(read_mesh(folder / "a.ply", {}, base::Host()).regions.empty());
}

TEST_CASE("Negative regions come back, also beside cells without regions") {
  const TemporaryFolder folder;
  Mesh mesh = solid_with_regions();
  mesh.regions.triangles = Numbers{-3, -3, 5, 0};
  mesh.regions.hexahedra.clear();
  for (const FileKind& kind : kinds_with_regions) {
    if (!holds(kind.file, Holds::cells)) continue;
    CAPTURE(kind.file);
    write_mesh(folder / kind.file, mesh, {.binary = kind.binary}, base::Host());
    CHECK(same(read_mesh(folder / kind.file, {}, base::Host()), mesh));
  }
}

TEST_CASE("A wrong number of regions is refused before a file is written") {
  const TemporaryFolder folder;
  Mesh mesh = solid_with_regions();
  mesh.regions.hexahedra.push_back(1);
  for (const char* file : {"a.mesh", "a.vtu", "a.msh", "a.inp"})
    CHECK_THROWS_WITH_AS(write_mesh(folder / file, mesh, {}, base::Host()), "3 region numbers of 2 hexahedra",
                         base::Error);
  CHECK(folder.files() == 0);
}

TEST_CASE("Distinct regions are in order, without 0") {
  const Numbers numbers{5, 0, 5, -1, 0, 7, 5};
  CHECK(distinct_regions(numbers, std::pmr::get_default_resource()) == Numbers{-1, 5, 7});
}

TEST_CASE("Triangles that welding removes take their regions with them") {
  Mesh mesh;
  mesh.positions = Array<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 1}};
  mesh.triangles = Array<Triangle>{{0, 1, 2}, {0, 3, 1}, {3, 2, 4}};
  mesh.regions.triangles = Numbers{1, 2, 3};
  CHECK(weld(mesh, base::Host()).triangles == 1);
  CHECK(mesh.regions.triangles == Numbers{1, 3});
}

TEST_CASE("MEDIT: numbers that are no regions are left out with a note, and the shape is read") {
  const std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\nTriangles 2\n";
  CHECK(triangle_regions(Format::medit, text + "1 2 3 4.0\n1 3 2 -7\n") == Numbers{4, -7});
  CHECK(triangle_regions(Format::medit, text + "1 2 3 0\n1 3 2 0\n").empty());
  std::string note;
  CHECK(triangle_regions(Format::medit, text + "1 2 3 1.5\n1 3 2 1\n", &note).empty());
  CHECK(note == "region numbers were left out: 1.5 is no integer of 32 bits");
  CHECK(triangle_regions(Format::medit, text + "1 2 3 1\n1 3 2 2147483648\n", &note).empty());
  CHECK(note == "region numbers were left out: 2147483648 is no integer of 32 bits");
}

TEST_CASE("VTK: regions are data on cells of a usual name, of which points and lines have some") {
  const auto scalars = [](const std::string& name, const std::string& numbers) {
    return "SCALARS " + name + " int 1\nLOOKUP_TABLE default\n" + numbers + "\n";
  };
  const std::string data = vtk_faces + "CELL_DATA 4\n";
  CHECK(triangle_regions(Format::vtk, data + scalars("CellEntityIds", "8 9 2 3")) == Numbers{2, 2, 3});
  CHECK(
      triangle_regions(Format::vtk, data + "FIELD FieldData 2\nage 1 4 int\n1 2 3 4\nmedit:ref 1 4 long\n8 9 5 6\n") ==
      Numbers{5, 5, 6});
  CHECK(triangle_regions(Format::vtk, data + "SCALARS MaterialIds double\nLOOKUP_TABLE t\n0 0 7 8\n") ==
        Numbers{7, 7, 8});
  // The more usual name counts, wherever it is.
  CHECK(triangle_regions(Format::vtk, data + scalars("material", "8 9 2 3") + scalars("region", "0 0 5 6")) ==
        Numbers{5, 5, 6});
  std::string note;
  const std::string of_points = "POINT_DATA 5\n" + scalars("region", "1 2 3 4 5");
  CHECK(triangle_regions(Format::vtk, vtk_faces + of_points, &note).empty());
  CHECK(note == "left out: 1 data array");
  CHECK(triangle_regions(Format::vtk, vtk_faces + of_points + "CELL_DATA 4\n" + scalars("region", "0 0 1 1")) ==
        Numbers{1, 1, 1});
  CHECK(triangle_regions(Format::vtk, data + scalars("temperature", "8 9 2 3"), &note).empty());
  ReadReport report;
  CHECK(read_text(Format::vtk, data + "SCALARS region float 1\nLOOKUP_TABLE default\n1 1 1 1.5\n", {}, &report)
            .regions.empty());
  CHECK(std::ranges::count(report.notes, "region numbers were left out: 1.5 is no integer of 32 bits") == 1);
  CHECK(ends_as(Format::vtk, vtk_faces + "CELL_DATA 3\n" + scalars("region", "1 2 3"), "parse",
                "the array 'region' has 3 numbers, where the file has 4 cells"));
  CHECK(ends_as(Format::vtk, data + "FIELD f 1\nregion 1 5 int\n1 2 3 4 5\n", "parse", "5 numbers"));
  CHECK(ends_as(Format::vtk, data + scalars("region", "1 2 3"), "truncated"));
  CHECK(ends_as(Format::vtk, data + scalars("region", "1 2 x 3"), "parse", "an integer"));
}

TEST_CASE("VTK XML: pieces without regions have 0, and a wrong number of them is refused") {
  const auto piece = [](const std::string& data) {
    return "<Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\"><Points><DataArray type=\"Float64\" "
           "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray></Points><Polys><DataArray "
           "type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int32\" "
           "Name=\"offsets\" format=\"ascii\">3</DataArray></Polys><CellData>" +
           data + "</CellData></Piece>";
  };
  const auto array = [](const std::string& name, const std::string& numbers) {
    return "<DataArray type=\"Int64\" Name=\"" + name + "\" format=\"ascii\">" + numbers + "</DataArray>";
  };
  const auto file = [](const std::string& pieces) {
    return "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData>" + pieces + "</PolyData></VTKFile>";
  };
  CHECK(triangle_regions(Format::vtp, file(piece("") + piece(array("gmsh:physical", "6")) + piece(""))) ==
        Numbers{0, 6, 0});
  std::string note;
  CHECK(triangle_regions(Format::vtp, file(piece(array("material", "1") + array("region", "2") + array("x", "3"))),
                         &note) == Numbers{2});
  CHECK(note == "left out: 2 data arrays");
  CHECK(ends_as(Format::vtp, file(piece(array("region", "1 2"))), "parse",
                "the array 'region' of CellData: 2 numbers, where the piece has 1 cell"));
}

TEST_CASE("Gmsh: regions are groups of entities, and entities where there are no groups") {
  const auto file = [](const std::string& entities, const std::string& elements) {
    return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + entities +
           "$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n$Elements\n" + elements +
           "$EndElements\n";
  };
  const std::string two = "2 2 1 2\n2 11 2 1\n1 1 2 3\n2 12 2 1\n2 1 2 4\n";
  CHECK(triangle_regions(Format::msh, file("", two)) == Numbers{11, 12});
  CHECK(triangle_regions(Format::msh, file("", "1 1 1 1\n2 11 2 1\n1 1 2 3\n")).empty());
  const std::string begin = "$Entities\n1 1 2 0\n5 0 0 0 1 9\n6 0 0 0 1 1 1 1 8 2 5 -5\n";
  std::string note;
  CHECK(triangle_regions(Format::msh,
                         file(begin + "11 0 0 0 1 1 1 1 31 1 6\n12 0 0 0 1 1 1 2 -32 33 0\n$EndEntities\n", two),
                         &note) == Numbers{31, 32});
  CHECK(note == "left out: 1 further group of an entity");
  CHECK(triangle_regions(Format::msh, file(begin + "11 0 0 0 1 1 1 0 0\n12 0 0 0 1 1 1 1 32 0\n$EndEntities\n", two)) ==
        Numbers{0, 32});
  CHECK(ends_as(Format::msh, file(begin + "11 0 0 0 1 1 1 1000000000 1\n", two), "parse", "the number of a group"));
  const std::string version_2 =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n$Elements\n2\n";
  CHECK(triangle_regions(Format::msh, version_2 + "1 2 2 7 1 1 2 3\n2 2 2 8 1 1 3 2\n$EndElements\n") == Numbers{7, 8});
  CHECK(triangle_regions(Format::msh, version_2 + "1 2 2 0 4 1 2 3\n2 2 2 0 5 1 3 2\n$EndElements\n") == Numbers{4, 5});
  CHECK(triangle_regions(Format::msh, version_2 + "1 2 0 1 2 3\n2 2 0 1 3 2\n$EndElements\n").empty());
  CHECK(triangle_regions(Format::msh, version_2 + "1 2 1 5000000000 1 2 3\n2 2 1 1 1 3 2\n$EndElements\n", &note)
            .empty());
  CHECK(note == "region numbers were left out: 5000000000 is beyond 32 bits");
}

TEST_CASE("Abaqus: element sets are regions, the smallest of an element") {
  const std::string nodes = "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n";
  const std::string faces = "*ELEMENT, TYPE=S3, ELSET=ALL\n1, 1, 2, 3\n5, 1, 2, 4\n9, 2, 3, 4\n";
  std::string note;
  CHECK(triangle_regions(Format::inp, nodes + faces).empty());
  CHECK(triangle_regions(Format::inp, nodes + "*ELEMENT, TYPE=S3, ELSET=Surface7\n1, 1, 2, 3\n") == Numbers{7});
  CHECK(triangle_regions(Format::inp, nodes + faces + "*ELSET, ELSET=PART-2\n5, 9,\n*ELSET, ELSET=PART-3\n9\n") ==
        Numbers{0, 2, 3});
  CHECK(triangle_regions(Format::inp, nodes + faces + "*ELSET, ELSET=A_-2, GENERATE\n1, 1000000000000, 4\n") ==
        Numbers{-2, -2, -2});
  CHECK(triangle_regions(Format::inp,
                         nodes + faces + "*ELSET, ELSET=A_1, GENERATE\n1, 9, 8\n*ELSET, ELSET=B2\nA_1, 5\n") ==
        Numbers{1, 2, 1});
  // Gmsh's of groups come before those of entities, ours before both.
  const std::string gmsh = nodes + faces + "*ELSET, ELSET=Surface1\n1\n*ELSET, ELSET=PhysicalSurface8\n1, 5\n";
  CHECK(triangle_regions(Format::inp, gmsh) == Numbers{8, 8, 0});
  CHECK(triangle_regions(Format::inp, gmsh + "*ELSET, ELSET=TRIANGLES_3\n9\n") == Numbers{0, 0, 3});
  // Names without numbers, and the same number twice.
  CHECK(triangle_regions(Format::inp, nodes + faces + "*ELSET, ELSET=STEEL\n5\n*ELSET, ELSET=RUBBER\n9\n", &note) ==
        Numbers{1, 2, 3});
  CHECK(note == "element sets were numbered as regions: ALL 1, STEEL 2, RUBBER 3");
  CHECK(triangle_regions(Format::inp, nodes + faces + "*ELSET, ELSET=STEEL-1\n1, 5\n*ELSET, ELSET=RUBBER-1\n9\n",
                         &note) == Numbers{1, 1, 2});
  CHECK(note == "element sets were numbered as regions: STEEL-1 1, RUBBER-1 2");
  CHECK(ends_as(Format::inp, nodes + faces + "*ELSET, ELSET=A, GENERATE\n1\n", "parse", "GENERATE"));
  CHECK(ends_as(Format::inp, nodes + faces + "*ELSET, ELSET=A, GENERATE\n1, 9, 0\n", "parse", "a step above 0"));
}

TEST_CASE("Tetrahedra of prisms, pyramids and hexahedra beside them have the regions of these") {
  const std::string text =
      "MeshVersionFormatted 2\nDimension 3\nVertices 11\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n"
      "1 1 1 0\n0 1 1 0\n0.5 0.5 2 0\n2 0 0 0\n2 0 1 0\nHexahedra 1\n1 2 3 4 5 6 7 8 5\nPyramids 1\n5 6 7 8 9 7\n"
      "Prisms 1\n2 10 3 6 11 7 0\nEnd\n";
  const Mesh mesh = read_text(Format::medit, text);
  REQUIRE(mesh.regions.tetrahedra.size() == mesh.tetrahedra.size());
  CHECK(mesh.hexahedra.empty());
  for (const std::int32_t region : {0, 5, 7}) {
    double volume = 0;
    for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
      const auto p = [&](std::size_t k) { return mesh.positions[mesh.tetrahedra[i][k]]; };
      if (mesh.regions.tetrahedra[i] == region) volume += (p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0)) / 6;
    }
    CAPTURE(region);
    CHECK(volume == doctest::Approx(region == 5 ? 1 : region == 7 ? 1 / 3. : .5));
  }
}

TEST_CASE("New faces have the regions of the nearest triangles that look the same way") {
  // A thin plate: its upper side has region 1, its lower side 2, its rim none.
  Mesh plate;
  for (int i = 0; i < 8; ++i)
    plate.positions.emplace_back(10 * (i % 2), 10 * (i / 2 % 2), 0.1 * (i / 4));
  plate.triangles = Array<Triangle>{{4, 5, 7}, {4, 7, 6}, {0, 3, 1}, {0, 2, 3}, {0, 1, 5}, {0, 5, 4}};
  plate.regions.triangles = Numbers{1, 1, 2, 2, 3, 3};
  const auto region = [&](const Vector3& center, const Vector3& area) {
    const std::array<FacePlace, 1> faces = {FacePlace{center, area}};
    const Numbers found = nearest_face_regions(plate, faces, base::Host());
    return found.empty() ? 0 : found[0];
  };
  CHECK(region({5, 5, 0.09}, {0, 0, 1}) == 1);
  // Moved by more than half of the thickness, it keeps its side.
  CHECK(region({5, 5, 0.04}, {0, 0, 1}) == 1);
  CHECK(region({5, 5, 0.06}, {0, 0, -1}) == 2);
  CHECK(region({5, 0.01, 0.05}, {0, -1, 0}) == 3);
  plate.regions.triangles = Numbers{0, 0, 0, 0, 3, 3};
  CHECK(region({5, 5, 0.09}, {0, 0, 1}) == 0);
  plate.regions.triangles.clear();
  CHECK(region({5, 5, 0.09}, {0, 0, 1}) == 0);
  const std::array<Index, 4> lower = {0, 2, 3, 1};
  const FacePlace place = face_place(plate.positions, lower);
  CHECK(place.center == Vector3(5, 5, 0));
  CHECK(place.area == Vector3(0, 0, -100));
}

TEST_CASE("Points have the regions of the cells that they are in, or of the nearest") {
  const Mesh mesh = solid_with_regions();
  const auto region = [&](const Vector3& p) {
    const Numbers found = nearest_cell_regions(mesh, std::array{p}, base::Host());
    return found.empty() ? 0 : found[0];
  };
  CHECK(region({0.5, 0.5, 0.5}) == 1);
  CHECK(region({1.01, 0.99, 0.01}) == 3);
  CHECK(region({9, 0.5, 0.5}) == 3);
  CHECK(region({0.7, 0.3, 1.1}) == 2'000'000'000);
  CHECK(region({0.3, 0.7, 1.1}) == 1);
  Mesh without = solid_with_regions();
  without.regions.tetrahedra.clear();
  without.regions.hexahedra.clear();
  CHECK(nearest_cell_regions(without, std::array{Vector3(0, 0, 0)}, base::Host()).empty());
}

TEST_CASE("Quadrilaterals are written with their regions and read as two triangles each") {
  const TemporaryFolder folder;
  Mesh mesh = solid_with_regions();
  mesh.triangles.resize(1);
  mesh.regions.triangles.clear();
  const Array<Quad> quads = {{0, 1, 3, 2}, {4, 5, 11, 10}};
  const Numbers regions = {9, -8};
  for (const FileKind& kind : kinds_with_regions) {
    CAPTURE(kind.file);
    const WriteOptions options = {.binary = kind.binary, .quads = quads, .quad_regions = regions};
    if (!holds(kind.file, Holds::cells)) {
      CHECK_THROWS_AS(write_mesh(folder / kind.file, surface_with_regions(), options, base::Host()), base::Error);
      continue;
    }
    write_mesh(folder / kind.file, mesh, options, base::Host());
    ReadReport report;
    const Mesh again = read_mesh(folder / kind.file, {}, base::Host(), &report);
    CHECK(report.polygons == 2);
    CHECK(again.triangles == Array<Triangle>{mesh.triangles[0], {0, 1, 3}, {0, 3, 2}, {4, 5, 11}, {4, 11, 10}});
    CHECK(again.regions.triangles == Numbers{0, 9, 9, -8, -8});
    CHECK(again.hexahedra == mesh.hexahedra);
    CHECK(again.regions.hexahedra == mesh.regions.hexahedra);
    CHECK(again.regions.tetrahedra == mesh.regions.tetrahedra);
  }
  const Numbers one = {9};
  CHECK_THROWS_WITH_AS(write_mesh(folder / "a.mesh", mesh, {.quads = quads, .quad_regions = one}, base::Host()),
                       "1 region number of 2 quadrilaterals", base::Error);
}
