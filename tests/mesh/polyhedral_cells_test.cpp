// Prisms and pyramids cut into tetrahedra: the volume is that of the cells, and neighbors meet in whole faces.
#include "mesh/files/polyhedral_cells.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "mesh/topology/cells.h"
#include "mesh/topology/topology.h"
#include "read_text.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

double volume_of(const Mesh& mesh) {
  double volume = 0;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    const auto& x = mesh.positions;
    volume += (x[t[1]] - x[t[0]]).dot((x[t[2]] - x[t[0]]).cross(x[t[3]] - x[t[0]])) / 6;
  }
  return volume;
}

// n^3 unit cubes with vertices in a random order: two prisms, six pyramids around a middle, or one hexahedron each.
Mesh mixed_block(Index n, std::uint32_t seed, bool turned, std::vector<std::string>& notes) {
  std::mt19937 random(seed);
  const Index corners = (n + 1) * (n + 1) * (n + 1);
  std::vector<Index> order(corners + n * n * n);
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), random);
  Mesh mesh;
  mesh.positions.resize(order.size());
  const auto at = [&](Index x, Index y, Index z) { return order[(z * (n + 1) + y) * (n + 1) + x]; };
  for (Index z = 0; z <= n; ++z)
    for (Index y = 0; y <= n; ++y)
      for (Index x = 0; x <= n; ++x)
        mesh.positions[at(x, y, z)] = Vector3(x, y, z);
  PolyhedralCells cells(std::pmr::get_default_resource());
  // What is above or below is exchanged in the other convention.
  const auto add = [&](Polyhedron kind, std::vector<Index> c) {
    if (turned && kind == Polyhedron::prism) std::rotate(c.begin(), c.begin() + 3, c.end());
    if (turned && kind == Polyhedron::pyramid) std::swap(c[1], c[3]);
    cells.add(kind, c);
  };
  Index number = 0;
  for (Index z = 0; z < n; ++z) {
    for (Index y = 0; y < n; ++y) {
      for (Index x = 0; x < n; ++x, ++number) {
        const Index middle = order[corners + number];
        mesh.positions[middle] = Vector3(x + 0.5, y + 0.5, z + 0.5);
        const std::array<Index, 8> h = {
            at(x, y, z),     at(x + 1, y, z),     at(x + 1, y + 1, z),     at(x, y + 1, z),
            at(x, y, z + 1), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1), at(x, y + 1, z + 1)};
        if (number % 3 == 0) {
          add(Polyhedron::prism, {h[0], h[1], h[2], h[4], h[5], h[6]});
          add(Polyhedron::prism, {h[0], h[2], h[3], h[4], h[6], h[7]});
        } else if (number % 3 == 1) {
          mesh.hexahedra.push_back({h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7]});
        } else {
          for (const std::array<std::size_t, 4>& f : {std::array<std::size_t, 4>{0, 1, 2, 3},
                                                      {7, 6, 5, 4},
                                                      {4, 5, 1, 0},
                                                      {5, 6, 2, 1},
                                                      {6, 7, 3, 2},
                                                      {7, 4, 0, 3}})
            add(Polyhedron::pyramid, {h[f[0]], h[f[1]], h[f[2]], h[f[3]], middle});
        }
      }
    }
  }
  cells.cut_into_tetrahedra(mesh, notes, base::Host());
  return mesh;
}

const std::string prism_points = "Vertices 6\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n0 1 1 0\n";

}  // namespace

TEST_CASE("Blocks of prisms, pyramids and hexahedra become conforming tetrahedra, whatever the order of vertices") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    std::vector<std::string> notes;
    const Mesh mesh = mixed_block(3, seed, seed % 2 == 1, notes);
    CHECK(mesh.hexahedra.empty());
    CHECK(mesh.tetrahedra.size() == 9 * (2 * 3 + 6 + 6 * 2));
    CHECK(volume_of(mesh) == doctest::Approx(27).epsilon(1e-12));
    CHECK_NOTHROW(require_valid_cells(mesh, base::Host()));
    const Topology t = topology(mesh.positions, boundary_triangles(mesh, base::Host()), base::Host());
    CHECK(t.genus == 0);
    CHECK(t.triangles == 6 * 9 * 2);
    CHECK(t.volume == doctest::Approx(27));
    CHECK(notes == std::vector<std::string>{"54 pyramids, 18 prisms, 9 hexahedra were cut into 216 tetrahedra"});
  }
}

TEST_CASE("Each kind of cell keeps its volume, alone and in either convention") {
  const auto ring = [](std::size_t n, double z, std::vector<Vector3>& into) {
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(n);
      into.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  };
  for (const auto& [kind, n] : {std::pair{Polyhedron::prism, 3},
                                {Polyhedron::hexahedron, 4},
                                {Polyhedron::pentagonal_prism, 5},
                                {Polyhedron::hexagonal_prism, 6},
                                {Polyhedron::pyramid, 4}}) {
    const auto sides = static_cast<std::size_t>(n);
    std::vector<Vector3> points;
    ring(sides, 0, points);
    if (kind == Polyhedron::pyramid) {
      points.emplace_back(0, 0, 3);
    } else {
      ring(sides, 1, points);
    }
    CHECK(points.size() == corner_count(kind));
    const double area = static_cast<double>(n) / 2 * std::sin(2 * 3.14159265358979 / n);
    for (const double height : {1.0, -1.0}) {
      Mesh mesh;
      for (const Vector3& p : points)
        mesh.positions.emplace_back(p.x(), p.y(), height * p.z());
      std::vector<Index> corners(points.size());
      std::iota(corners.begin(), corners.end(), 0U);
      PolyhedralCells cells(std::pmr::get_default_resource());
      cells.add(kind, corners);
      std::vector<std::string> notes;
      cells.cut_into_tetrahedra(mesh, notes, base::Host());
      CHECK_NOTHROW(require_valid_cells(mesh, base::Host()));
      CHECK(volume_of(mesh) == doctest::Approx(area));
      CHECK(notes.size() == 1);
    }
  }
}

TEST_CASE("A crooked cell is cut around a vertex of its own where its diagonals leave no other way") {
  std::mt19937 random(1);
  const auto offset = [&] { return 0.9 * (static_cast<double>(random()) * 0x1p-32 - 0.5); };
  std::size_t around = 0, valid = 0;
  for (int i = 0; i < 2000; ++i) {
    Mesh mesh;
    for (const double z : {0.0, 1.0}) {
      for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        mesh.positions.emplace_back(x + offset(), y + offset(), z + offset());
    }
    PolyhedralCells cells(std::pmr::get_default_resource());
    cells.add(Polyhedron::hexahedron, std::array<Index, 8>{0, 1, 2, 3, 4, 5, 6, 7});
    std::vector<std::string> notes;
    cells.cut_into_tetrahedra(mesh, notes, base::Host());
    try {
      require_valid_cells(mesh, base::Host());
    } catch (const base::Error& error) {
      CHECK(std::string(error.kind()) == "inverted-cell");
      continue;
    }
    ++valid;
    const bool own = mesh.positions.size() == 9;
    around += own;
    CHECK(mesh.tetrahedra.size() == (own ? 12 : 6));
    CHECK((notes[0].find("around a vertex of their own") != std::string::npos) == own);
    const auto boundary = boundary_triangles(mesh, base::Host());
    CHECK(boundary.size() == 12);
    CHECK(topology(mesh.positions, boundary, base::Host()).volume == doctest::Approx(volume_of(mesh)));
  }
  CHECK(valid >= 500);
  CHECK(around >= 10);
}

TEST_CASE("MEDIT and VTK: prisms and pyramids are read, those of all programs' orders") {
  for (const char* prism : {"1 2 3 4 5 6 1", "4 5 6 1 2 3 1", "1 3 2 4 6 5 1"}) {
    ReadReport report;
    const Mesh mesh = read_text(Format::medit, prism_points + "Prisms\n1\n" + prism + "\nEnd\n", {}, &report);
    CHECK(mesh.tetrahedra.size() == 3);
    CHECK(volume_of(mesh) == doctest::Approx(0.5));
    CHECK(report.notes == std::vector<std::string>{"1 prism was cut into 3 tetrahedra"});
  }
  CHECK(ends_as(Format::medit, prism_points + "Prisms\n1\n1 2 3 4 5 7 1\nEnd\n", "index-range"));
  CHECK(ends_as(Format::medit, prism_points + "Prisms\n1\n1 2 3 4 5 5 1\nEnd\n", "degenerate-cell"));
  const std::string vtk =
      "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 7 float\n0 0 0 1 0 0 0 1 0 0 0 1 1 0 1 "
      "0 1 1 -1 0.5 0.5\nCELLS 2 13\n6 0 1 2 3 4 5\n5 0 2 5 3 6\nCELL_TYPES 2\n13 14\n";
  const Mesh mesh = read_text(Format::vtk, vtk);
  CHECK(mesh.tetrahedra.size() == 5);
  CHECK(volume_of(mesh) == doctest::Approx(0.5 + 1.0 / 3));
}
