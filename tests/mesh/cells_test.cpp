// Cells of solids that are right, and each way in which they can be wrong.
#include "mesh/topology/cells.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/topology/topology.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

std::string refusal(const Mesh& mesh) {
  try {
    require_valid_cells(mesh, base::Host());
  } catch (const base::Error& e) {
    return e.kind() + std::string(": ") + e.what();
  }
  return "";
}

std::string kind(const Mesh& mesh) {
  const std::string text = refusal(mesh);
  return text.substr(0, text.find(':'));
}

// n^3 unit cubes, each one hexahedron or six tetrahedra around a diagonal (Kuhn).
Mesh cubes(Index n, bool as_hexahedra) {
  Mesh mesh;
  const auto at = [n](Index x, Index y, Index z) { return (z * (n + 1) + y) * (n + 1) + x; };
  for (Index z = 0; z <= n; ++z) {
    for (Index y = 0; y <= n; ++y) {
      for (Index x = 0; x <= n; ++x)
        mesh.positions.emplace_back(x, y, z);
    }
  }
  for (Index z = 0; z < n; ++z) {
    for (Index y = 0; y < n; ++y) {
      for (Index x = 0; x < n; ++x) {
        if (as_hexahedra) {
          mesh.hexahedra.push_back({at(x, y, z), at(x + 1, y, z), at(x + 1, y + 1, z), at(x, y + 1, z), at(x, y, z + 1),
                                    at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1), at(x, y + 1, z + 1)});
          continue;
        }
        std::array<int, 3> axes{0, 1, 2};
        do {
          std::array<Index, 3> p{x, y, z};
          Tetrahedron t{at(x, y, z), 0, 0, 0};
          for (std::size_t i = 0; i < 3; ++i) {
            ++p[static_cast<std::size_t>(axes[i])];
            t[i + 1] = at(p[0], p[1], p[2]);
          }
          const bool even = (axes[1] - axes[0] + 3) % 3 == 1;
          if (!even) std::swap(t[2], t[3]);
          mesh.tetrahedra.push_back(t);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("Blocks of cubes and of tetrahedra are valid, at any size and place") {
  CHECK(refusal(Mesh()) == "");
  for (const bool as_hexahedra : {false, true}) {
    Mesh mesh = cubes(3, as_hexahedra);
    CHECK(refusal(mesh) == "");
    for (const double scale : {1e-300, 1e150}) {
      Mesh scaled = mesh;
      for (Vector3& p : scaled.positions)
        p *= scale;
      CHECK(refusal(scaled) == "");
    }
    for (Vector3& p : mesh.positions)
      p += Vector3::Constant(0x1p50);
    CHECK(refusal(mesh) == "");
  }
}

TEST_CASE("Turning any two vertices of a cell inverts it") {
  Mesh mesh = cubes(2, false);
  std::swap(mesh.tetrahedra[17][1], mesh.tetrahedra[17][3]);
  CHECK(refusal(mesh).starts_with("inverted-cell: cells that are inverted, or have a corner that is: 1;"));
  CHECK(refusal(mesh).find("first tetrahedron 17") != std::string::npos);
  Mesh hexahedra = cubes(2, true);
  Hexahedron& c = hexahedra.hexahedra[3];
  c = {c[4], c[5], c[6], c[7], c[0], c[1], c[2], c[3]};
  CHECK(kind(hexahedra) == "inverted-cell");
}

TEST_CASE("Moving one corner of a cube through its neighbors' plane is seen to the last bit") {
  for (Index corner = 0; corner < 8; ++corner) {
    // The corner on the plane through its three neighbors is flat; a bit inside it is not, a bit beyond it is
    // inverted.
    const Mesh cube = cubes(1, true);
    const Index vertex = cube.hexahedra[0][corner];
    const Vector3 p = cube.positions[vertex];
    const Vector3 inward = (Vector3::Constant(0.5) - p) * 2;
    const auto moved = [&](double along_x) {
      Mesh mesh = cube;
      mesh.positions[vertex] = p + Vector3(along_x, inward.y() / 4, inward.z() / 2);
      return kind(mesh);
    };
    const double limit = inward.x() / 4;
    CHECK(moved(limit) == "degenerate-cell");
    CHECK(moved(limit * (1 - 0x1p-50)) == "");
    CHECK(moved(limit * (1 + 0x1p-50)) == "inverted-cell");
  }
}

TEST_CASE("Flat and collapsed cells are degenerate") {
  Mesh mesh = cubes(1, false);
  mesh.tetrahedra[2][1] = mesh.tetrahedra[2][0];
  CHECK(kind(mesh) == "degenerate-cell");
  Mesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  flat.tetrahedra = {{0, 1, 2, 3}};
  CHECK(kind(flat) == "degenerate-cell");
  Mesh hexahedra = cubes(1, true);
  hexahedra.hexahedra[0][6] = hexahedra.hexahedra[0][5];
  CHECK(kind(hexahedra) == "degenerate-cell");
}

TEST_CASE("Vertices that do not exist are refused") {
  Mesh mesh = cubes(1, false);
  mesh.tetrahedra[5][2] = 8;
  CHECK(kind(mesh) == "index-range");
}

TEST_CASE("A cell that is there twice is found, whatever the order of its vertices") {
  Mesh mesh = cubes(2, false);
  const Tetrahedron t = mesh.tetrahedra[30];
  mesh.tetrahedra.push_back({t[1], t[2], t[0], t[3]});
  CHECK(refusal(mesh).starts_with("duplicate-cell"));
  CHECK(refusal(mesh).find("first tetrahedron 48") != std::string::npos);
  CHECK(refusal(mesh).find("those of 30, at (") != std::string::npos);
  Mesh hexahedra = cubes(2, true);
  const Hexahedron h = hexahedra.hexahedra[1];
  hexahedra.hexahedra.push_back({h[1], h[2], h[3], h[0], h[5], h[6], h[7], h[4]});
  CHECK(kind(hexahedra) == "duplicate-cell");
}

TEST_CASE("A face of three cells and an edge between parts that only touch there are refused") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0.2, 0.2, 2}, {0, -1, 0}, {0.3, -1, -1}};
  for (Vector3& p : mesh.positions)
    p.x() += 7;
  mesh.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}};
  CHECK(refusal(mesh) == "non-manifold-face: faces of more than two cells: 1; first 0-1-2 of 3 cells, at (7, 0, 0)");
  mesh.tetrahedra = {{0, 1, 2, 3}, {0, 1, 6, 7}};
  CHECK(refusal(mesh) ==
        "non-manifold-edge: edges where parts of the solid touch: 1; first 0-1 of 4 boundary faces, at (7, 0, 0)");

  // Two cubes of a block that share an edge only.
  Mesh hexahedra = cubes(2, true);
  hexahedra.hexahedra = {hexahedra.hexahedra[0], hexahedra.hexahedra[3]};
  CHECK(kind(hexahedra) == "non-manifold-edge");
}

TEST_CASE("The boundary of a solid is a closed surface that is outward-oriented and encloses its volume") {
  for (const bool as_hexahedra : {false, true}) {
    const Mesh mesh = cubes(3, as_hexahedra);
    const auto triangles = boundary_triangles(mesh, base::Host());
    const Topology t = topology(mesh.positions, triangles, base::Host());
    CHECK(t.triangles == 6 * 9 * 2);
    CHECK(t.unreferenced_vertices == 8);
    CHECK(t.genus == 0);
    CHECK(t.inconsistent_edges == 0);
    CHECK(t.volume == doctest::Approx(27));
  }
  // A tunnel through the middle.
  Mesh tunnel = cubes(3, true);
  Array<Hexahedron> kept;
  for (std::size_t i = 0; i < 27; ++i) {
    if (i % 9 != 4) kept.push_back(tunnel.hexahedra[i]);
  }
  tunnel.hexahedra = kept;
  const Topology t = topology(tunnel.positions, boundary_triangles(tunnel, base::Host()), base::Host());
  CHECK(t.genus == 1);
  CHECK(t.volume == doctest::Approx(24));
  CHECK(boundary_triangles(Mesh(), base::Host()).empty());
}

TEST_CASE("The quads of a boundary begin where their hexahedra have them begin") {
  Mesh one;
  one.positions.assign(8, Vector3::Zero());
  one.hexahedra = {{7, 6, 5, 4, 3, 2, 1, 0}};
  auto quads = boundary_quads(one, base::Host());
  std::sort(quads.begin(), quads.end());
  const std::vector<std::array<Index, 4>> expected = {{3, 2, 1, 0}, {4, 7, 3, 0}, {5, 4, 0, 1},
                                                      {6, 5, 1, 2}, {7, 4, 5, 6}, {7, 6, 2, 3}};
  CHECK(std::equal(quads.begin(), quads.end(), expected.begin(), expected.end()));
  CHECK(boundary_quads(cubes(3, true), base::Host()).size() == 6 * 9);
  CHECK(boundary_quads(cubes(3, false), base::Host()).empty());
}

TEST_CASE("A face of a hexahedron is filled by two triangles of tetrahedra or by none, and then lies inside") {
  Mesh mesh = cubes(1, true);
  mesh.positions.emplace_back(0.5, 0.5, 2);
  const auto& h = mesh.hexahedra[0];
  // The two halves of a pyramid on top.
  const Tetrahedron one = {h[4], h[5], h[6], 8}, other = {h[4], h[6], h[7], 8};
  mesh.tetrahedra = {one, other};
  CHECK(refusal(mesh) == "");
  const Topology t = topology(mesh.positions, boundary_triangles(mesh, base::Host()), base::Host());
  CHECK(t.triangles == 5 * 2 + 4);
  CHECK(t.genus == 0);
  CHECK(t.volume == doctest::Approx(1 + 1.0 / 3));
  mesh.tetrahedra = {one};
  CHECK(kind(mesh) == "non-manifold-face");
  CHECK(refusal(mesh).find("with 1 on it, at (") != std::string::npos);
  CHECK_THROWS(boundary_triangles(mesh, base::Host()));
  // The halves along both diagonals do not fit.
  mesh.positions.emplace_back(0.5, 0.5, 3);
  mesh.tetrahedra = {one, {h[5], h[6], h[7], 9}};
  CHECK(kind(mesh) == "non-manifold-face");
  // On one edge only.
  mesh.tetrahedra = {{h[4], h[5], 9, 8}};
  mesh.positions[9] = {0.5, -1, 2};
  if (!refusal(mesh).starts_with("non-manifold-edge")) std::swap(mesh.tetrahedra[0][2], mesh.tetrahedra[0][3]);
  CHECK(kind(mesh) == "non-manifold-edge");
}

TEST_CASE("Cells that are all inverted are turned, and only those") {
  for (const bool as_hexahedra : {false, true}) {
    const Mesh right = cubes(2, as_hexahedra);
    Mesh mesh = right;
    CHECK(turn_inverted_cells(mesh, base::Host()).tetrahedra + turn_inverted_cells(mesh, base::Host()).hexahedra == 0);
    for (Vector3& p : mesh.positions)
      p.x() = -p.x();
    CHECK(refusal(mesh).starts_with("inverted-cell: all cells are inverted"));
    const CellTurnReport report = turn_inverted_cells(mesh, base::Host());
    CHECK(report.tetrahedra == mesh.tetrahedra.size());
    CHECK(report.hexahedra == mesh.hexahedra.size());
    CHECK(refusal(mesh) == "");
    // One that is right among them: no convention.
    mesh = right;
    for (std::size_t i = 1; i < mesh.tetrahedra.size(); ++i)
      std::swap(mesh.tetrahedra[i][0], mesh.tetrahedra[i][1]);
    for (std::size_t i = 1; i < mesh.hexahedra.size(); ++i) {
      auto& c = mesh.hexahedra[i];
      c = {c[4], c[5], c[6], c[7], c[0], c[1], c[2], c[3]};
    }
    CHECK(turn_inverted_cells(mesh, base::Host()).tetrahedra + turn_inverted_cells(mesh, base::Host()).hexahedra == 0);
  }
}
