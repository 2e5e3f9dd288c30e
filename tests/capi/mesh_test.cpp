// The C functions of mesh but for files (mesh_files_test.cpp): what they promise about arguments, memory and
// cancelling, and that they hand out what the C++ part finds. What that is worth is tested in tests/mesh/.
#include "orbicube/mesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "failing_allocations.h"
#include "mesh_cube.h"

using namespace orbicube;
using test::create;
using test::Cube;
using test::Mesh;
using test::Search;
using test::topology;

namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;

std::string cells_problem(const obc_mesh_cells& cells) {
  obc_error error;
  obc_mesh_check_cells(create(cells).get(), nullptr, &error);
  return error.kind;
}

}  // namespace

TEST_CASE("A mesh made from arrays hands the same arrays out") {
  const Cube cube;
  obc_mesh_cells cells = cube.cells();
  cells.hexahedra = cube.hexahedra.data();
  cells.hexahedron_count = 1;
  const Mesh mesh = create(cells);
  CHECK(obc_mesh_vertex_count(mesh.get()) == 8);
  CHECK(obc_mesh_triangle_count(mesh.get()) == 12);
  CHECK(obc_mesh_tetrahedron_count(mesh.get()) == 5);
  CHECK(obc_mesh_hexahedron_count(mesh.get()) == 1);
  Cube copy{};
  REQUIRE(obc_mesh_copy(mesh.get(), copy.positions.data(), copy.triangles.data(), copy.tetrahedra.data(),
                        copy.hexahedra.data(), nullptr) == OBC_OK);
  CHECK(copy.positions == cube.positions);
  CHECK(copy.triangles == cube.triangles);
  CHECK(copy.tetrahedra == cube.tetrahedra);
  CHECK(copy.hexahedra == cube.hexahedra);
  CHECK(obc_mesh_copy(mesh.get(), nullptr, nullptr, nullptr, nullptr, nullptr) == OBC_OK);
  obc_surface surface;
  REQUIRE(obc_mesh_surface(mesh.get(), &surface, nullptr) == OBC_OK);
  CHECK(surface.vertex_count == 8);
  CHECK(surface.triangle_count == 12);
  CHECK(std::memcmp(surface.triangles, cube.triangles.data(), sizeof cube.triangles) == 0);
}

TEST_CASE("Regions are handed out as they were given, 0 where there are none") {
  const Cube cube;
  obc_mesh_cells cells = cube.cells();
  cells.hexahedra = cube.hexahedra.data();
  cells.hexahedron_count = 1;
  CHECK(obc_mesh_region_kinds(create(cells).get()) == 0);
  std::array<std::int32_t, 12> patches;
  std::iota(patches.begin(), patches.end(), -3);
  const std::array<std::int32_t, 5> nothing{};
  const std::int32_t material = std::numeric_limits<std::int32_t>::max();
  cells.triangle_regions = patches.data();
  cells.tetrahedron_regions = nothing.data();
  cells.hexahedron_regions = &material;
  const Mesh mesh = create(cells);
  CHECK(obc_mesh_region_kinds(mesh.get()) == (OBC_MESH_TRIANGLE_REGIONS | OBC_MESH_HEXAHEDRON_REGIONS));
  std::array<std::int32_t, 12> triangles{};
  std::array<std::int32_t, 5> tetrahedra;
  tetrahedra.fill(7);
  std::int32_t hexahedron = 0;
  REQUIRE(obc_mesh_copy_regions(mesh.get(), triangles.data(), tetrahedra.data(), &hexahedron, nullptr) == OBC_OK);
  CHECK(triangles == patches);
  CHECK(tetrahedra == nothing);
  CHECK(hexahedron == material);
  CHECK(obc_mesh_copy_regions(mesh.get(), nullptr, nullptr, nullptr, nullptr) == OBC_OK);
  CHECK(obc_mesh_copy_regions(nullptr, nullptr, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_region_kinds(nullptr) == 0);
}

TEST_CASE("Topology of a cube, and where it is wrong when it is") {
  Cube cube;
  obc_mesh_topology_report t = topology(cube.surface());
  CHECK(t.vertices == 8);
  CHECK(t.edges == 18);
  CHECK(t.triangles == 12);
  CHECK(t.closed == 1);
  CHECK(t.manifold == 1);
  CHECK(t.orientable == 1);
  CHECK(t.genus == 0);
  CHECK(t.components == 1);
  CHECK(t.area == doctest::Approx(6));
  CHECK(t.volume == doctest::Approx(1));
  CHECK(t.high[2] == 1);
  CHECK(t.first_boundary_edge[0] == none);
  CHECK(t.first_duplicate_faces[1] == none);
  CHECK(t.first_vertex_apart == none);
  obc_error error;
  const obc_surface whole = cube.surface();
  CHECK(obc_mesh_check_closed_genus_zero(&whole, nullptr, &error) == OBC_OK);

  obc_surface open = cube.surface();
  open.triangle_count = 11;  // without 3 7 5
  t = topology(open);
  CHECK(t.closed == 0);
  CHECK(t.genus == -1);
  CHECK(t.boundary_edges == 3);
  CHECK(t.first_boundary_edge[0] != none);
  CHECK(obc_mesh_check_closed_genus_zero(&open, nullptr, &error) == OBC_NOT_CLOSED);
  CHECK(std::string(error.kind) == "not-closed");
  CHECK(std::string(error.message).find("1 boundary loop, the longest with 3 edges") == 0);

  std::copy(cube.triangles.begin(), cube.triangles.begin() + 3, cube.triangles.end() - 3);
  t = topology(cube.surface());
  CHECK(t.duplicate_faces == 1);
  CHECK(t.first_duplicate_faces[0] == 0);
  CHECK(t.first_duplicate_faces[1] == 11);
}

TEST_CASE("Turned triangles are turned back, and the caller's array is untouched when that fails") {
  Cube cube;
  const auto original = cube.triangles;
  std::swap(cube.triangles[9], cube.triangles[10]);
  obc_mesh_orient_report report;
  obc_mesh_orient_report_init(&report, sizeof report);
  REQUIRE(obc_mesh_orient(cube.positions.data(), 8, cube.triangles.data(), 12, nullptr, &report, nullptr) == OBC_OK);
  CHECK(report.reversed_triangles == 1);
  CHECK(report.inward_oriented == 0);
  CHECK(topology(cube.surface()).volume == doctest::Approx(1));
  cube.triangles = original;
  for (std::size_t t = 0; t < 36; t += 3)
    std::swap(cube.triangles[t], cube.triangles[t + 1]);
  REQUIRE(obc_mesh_orient(cube.positions.data(), 8, cube.triangles.data(), 12, nullptr, &report, nullptr) == OBC_OK);
  CHECK(report.reversed_triangles == 0);
  CHECK(report.inward_oriented == 1);
  CHECK(topology(cube.surface()).volume == doctest::Approx(1));

  // Five triangles round a Moebius strip.
  const std::vector<std::uint32_t> strip = {0, 1, 2, 1, 2, 3, 2, 3, 4, 3, 4, 0, 4, 0, 1};
  std::vector<std::uint32_t> turned = strip;
  obc_error error;
  CHECK(obc_mesh_orient(cube.positions.data(), 8, turned.data(), 5, nullptr, &report, &error) == OBC_NOT_MANIFOLD);
  CHECK(std::string(error.kind) == "non-orientable");
  CHECK(turned == strip);
}

TEST_CASE("Cells are checked") {
  Cube cube;
  CHECK(cells_problem(cube.cells()) == "");
  std::swap(cube.tetrahedra[5], cube.tetrahedra[6]);
  CHECK(cells_problem(cube.cells()) == "inverted-cell");
  cube.tetrahedra[5] = cube.tetrahedra[6];
  CHECK(cells_problem(cube.cells()) == "degenerate-cell");
  obc_mesh_cells hexahedron = cube.cells();
  hexahedron.tetrahedron_count = 0;
  hexahedron.hexahedra = cube.hexahedra.data();
  hexahedron.hexahedron_count = 1;
  CHECK(cells_problem(hexahedron) == "");
  std::rotate(cube.hexahedra.begin(), cube.hexahedra.begin() + 4, cube.hexahedra.end());
  CHECK(cells_problem(hexahedron) == "inverted-cell");
}

TEST_CASE("The shapes of tetrahedra are measured") {
  // The corner of a cube, and its mirror image.
  const std::array<double, 12> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<std::uint32_t, 8> tetrahedra = {0, 1, 2, 3, 1, 0, 2, 3};
  obc_mesh_cells cells;
  obc_mesh_cells_init(&cells, sizeof cells);
  cells.positions = positions.data();
  cells.vertex_count = 4;
  cells.tetrahedra = tetrahedra.data();
  cells.tetrahedron_count = 2;
  obc_mesh* made = nullptr;
  REQUIRE(obc_mesh_create(&cells, nullptr, &made, nullptr) == OBC_OK);
  const Mesh mesh(made);
  obc_mesh_tetrahedron_quality_report report;
  obc_error error;
  REQUIRE(obc_mesh_tetrahedron_quality_report_init(&report, sizeof report) == OBC_OK);
  REQUIRE(obc_mesh_tetrahedron_quality(made, nullptr, &report, &error) == OBC_OK);
  CHECK(report.tetrahedra == 2);
  CHECK(report.positive == 1);
  CHECK(report.inverted == 1);
  CHECK(report.worst == 1);
  CHECK(report.volume == 0);
  CHECK(report.max_volume == doctest::Approx(1.0 / 6));
  CHECK(report.max_dihedral == doctest::Approx(90));
  CHECK(report.max_edge_length == doctest::Approx(std::sqrt(2.0)));
  CHECK(report.dihedral_histogram[5] == 6);                                 // 54.7 degrees, three times each
  CHECK(report.dihedral_histogram[8] + report.dihedral_histogram[9] == 6);  // 90 degrees, but for rounding
  CHECK(obc_mesh_tetrahedron_quality(nullptr, nullptr, &report, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_tetrahedron_quality(made, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
}

TEST_CASE("The boundary of cells is a surface of its own") {
  const Cube cube;
  const Mesh solid = create(cube.cells());
  obc_mesh* made = nullptr;
  REQUIRE(obc_mesh_boundary(solid.get(), nullptr, &made, nullptr) == OBC_OK);
  const Mesh boundary(made);
  obc_surface surface;
  REQUIRE(obc_mesh_surface(made, &surface, nullptr) == OBC_OK);
  CHECK(surface.triangle_count == 12);
  CHECK(topology(surface).genus == 0);
  CHECK(topology(surface).volume == doctest::Approx(1));
  CHECK(obc_mesh_boundary(nullptr, nullptr, &made, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(made == nullptr);
}

TEST_CASE("What is nearest, what is at one place, what intersects") {
  Cube cube;
  const obc_surface surface = cube.surface();
  obc_mesh_search* made = nullptr;
  REQUIRE(obc_mesh_search_create(&surface, nullptr, &made, nullptr) == OBC_OK);
  const Search search(made);
  const std::array<double, 6> points{0.9, 0.8, 3, 0.5, -0.25, 0.25};
  std::array<std::uint32_t, 2> found{};
  std::array<double, 6> weights{}, at{};
  std::array<double, 2> distances{};
  REQUIRE(obc_mesh_search_vertices(search.get(), points.data(), 2, found.data(), nullptr) == OBC_OK);
  CHECK(found == std::array<std::uint32_t, 2>{7, 0});
  REQUIRE(obc_mesh_search_surface(search.get(), points.data(), 2, found.data(), weights.data(), at.data(),
                                  distances.data(), nullptr) == OBC_OK);
  CHECK(found == std::array<std::uint32_t, 2>{3, 4});
  CHECK(distances[0] == doctest::Approx(2));
  CHECK(distances[1] == doctest::Approx(0.25));
  CHECK(at[2] == doctest::Approx(1));
  CHECK(weights[3] + weights[4] + weights[5] == doctest::Approx(1));
  CHECK(obc_mesh_search_surface(search.get(), points.data(), 2, nullptr, nullptr, nullptr, nullptr, nullptr) == OBC_OK);
  const double not_finite[3] = {0, std::nan(""), 0};
  CHECK(obc_mesh_search_vertices(search.get(), not_finite, 1, found.data(), nullptr) == OBC_INVALID_ARGUMENT);

  std::array<std::uint32_t, 8> first{};
  cube.positions[21] = -0.0;
  cube.positions[22] = cube.positions[23] = 0;
  REQUIRE(obc_mesh_first_at_same_position(cube.positions.data(), 8, nullptr, first.data(), nullptr) == OBC_OK);
  CHECK(first == std::array<std::uint32_t, 8>{0, 1, 2, 3, 4, 5, 6, 0});

  // A corner of the cube is pushed out through the opposite one.
  const Cube whole;
  cube = whole;
  cube.positions[21] = cube.positions[22] = cube.positions[23] = -1;
  const obc_surface pushed = cube.surface(), straight = whole.surface();
  std::array<std::uint32_t, 40> pairs{};
  std::size_t count = 99;
  REQUIRE(obc_mesh_intersections(&straight, nullptr, pairs.data(), 20, &count, nullptr) == OBC_OK);
  CHECK(count == 0);
  REQUIRE(obc_mesh_intersections(&pushed, nullptr, pairs.data(), 20, &count, nullptr) == OBC_OK);
  CHECK(count > 2);
  for (std::size_t i = 0; i < count; ++i)
    CHECK(pairs[2 * i] < pairs[2 * i + 1]);
  REQUIRE(obc_mesh_intersections(&pushed, nullptr, pairs.data(), 2, &count, nullptr) == OBC_OK);
  CHECK(count == 2);
}

TEST_CASE("Normals and areas of vertices, and distances of surfaces and points") {
  const Cube cube;
  const obc_surface surface = cube.surface();
  obc_error error;
  std::array<double, 24> normals{};
  REQUIRE(obc_mesh_vertex_normals(&surface, nullptr, normals.data(), &error) == OBC_OK);
  for (std::size_t i = 0; i < 24; ++i)  // out of the corners, by symmetry
    CHECK(normals[i] == doctest::Approx((2 * cube.positions[i] - 1) / std::sqrt(3.0)).epsilon(1e-15));
  std::array<double, 8> areas{};
  REQUIRE(obc_mesh_vertex_areas(&surface, nullptr, areas.data(), &error) == OBC_OK);
  CHECK(std::accumulate(areas.begin(), areas.end(), 0.0) == doctest::Approx(6));

  Cube larger;
  for (double& x : larger.positions)
    x *= 2;
  const obc_surface other = larger.surface();
  obc_mesh_distance distance;
  REQUIRE(obc_mesh_distance_init(&distance, sizeof distance) == OBC_OK);
  REQUIRE(obc_mesh_surface_distance(&surface, &other, nullptr, &distance, &error) == OBC_OK);
  CHECK(distance.second_max == doctest::Approx(std::sqrt(3.0)));
  CHECK(distance.first_mean <= distance.first_root_mean_square);
  CHECK(distance.first_max < distance.second_max);
  double mean = -1;
  const double square[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  REQUIRE(obc_mesh_mean_distance(square, 4, square, 2, nullptr, &mean, &error) == OBC_OK);
  CHECK(mean == doctest::Approx(0.5));

  CHECK(obc_mesh_vertex_normals(nullptr, nullptr, normals.data(), &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_vertex_normals(&surface, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_vertex_areas(&surface, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  larger.positions[2] = HUGE_VAL;
  CHECK(obc_mesh_vertex_normals(&other, nullptr, normals.data(), &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_vertex_areas(&other, nullptr, areas.data(), &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_surface_distance(&surface, &other, nullptr, &distance, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_surface_distance(&surface, nullptr, nullptr, &distance, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_surface_distance(&surface, &surface, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_distance_init(nullptr, 8) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_mean_distance(square, 0, square, 1, nullptr, &mean, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_mean_distance(nullptr, 1, square, 1, nullptr, &mean, &error) == OBC_INVALID_ARGUMENT);
}

TEST_CASE("Predicates return exact signs, and 2 where there is none") {
  const double a[3] = {0.1, 0.1, 0.1}, b[3] = {0.2, 0.2, 0.2}, c[3] = {0.3, 0.3, 0.3}, d[3] = {0, 0, 1};
  CHECK(obc_mesh_orientation_from_origin(a, b, d) == 0);
  CHECK(obc_mesh_orientation_3d(a, b, c, d) == 0);
  CHECK(obc_mesh_orientation_2d(a, b, c) == 0);
  const double x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, least[3] = {0, 0, 5e-324};
  CHECK(obc_mesh_orientation_from_origin(x, y, least) == 1);
  CHECK(obc_mesh_orientation_from_origin(y, x, least) == -1);
  CHECK(obc_mesh_orientation_2d(least, x, y) == 1);
  const double infinite[3] = {std::numeric_limits<double>::infinity(), 0, 0};
  CHECK(obc_mesh_orientation_2d(x, y, infinite) == 2);
  CHECK(obc_mesh_orientation_3d(x, y, nullptr, d) == 2);
}

TEST_CASE("Every shape of the list can be made") {
  std::size_t count = 0;
  for (; obc_mesh_shape_name(count) != nullptr; ++count) {
    obc_mesh* mesh = nullptr;
    REQUIRE(obc_mesh_make(obc_mesh_shape_name(count), 2000, 1, nullptr, &mesh, nullptr) == OBC_OK);
    const Mesh owner(mesh);
    obc_surface surface;
    REQUIRE(obc_mesh_surface(mesh, &surface, nullptr) == OBC_OK);
    CHECK(topology(surface).closed == 1);
    CHECK(topology(surface).manifold == 1);
  }
  CHECK(count >= 5);
  obc_mesh* mesh = nullptr;
  CHECK(obc_mesh_make("no such shape", 2000, 1, nullptr, &mesh, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(mesh == nullptr);
}

TEST_CASE("Arguments that cannot be are refused") {
  const Cube cube;
  obc_mesh* mesh = nullptr;
  obc_mesh_search* search = nullptr;
  obc_error error;
  obc_mesh_cells cells = cube.cells();
  CHECK(obc_mesh_create(nullptr, nullptr, &mesh, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_create(&cells, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  cells.vertex_count = 7;
  CHECK(obc_mesh_create(&cells, nullptr, &mesh, &error) == OBC_INVALID_ARGUMENT);
  CHECK(std::string(error.message).find("has vertex 7 of 7") != std::string::npos);
  cells = cube.cells();
  cells.triangle_count = 0;
  cells.vertex_count = 7;
  CHECK(obc_mesh_create(&cells, nullptr, &mesh, &error) == OBC_INVALID_ARGUMENT);
  CHECK(std::string(error.message).find("tetrahedron 1 has vertex 7") == 0);
  cells = cube.cells();
  cells.positions = nullptr;
  CHECK(obc_mesh_create(&cells, nullptr, &mesh, &error) == OBC_INVALID_ARGUMENT);
  cells = cube.cells();
  cells.vertex_count = std::numeric_limits<std::size_t>::max() / 8;
  CHECK(obc_mesh_create(&cells, nullptr, &mesh, &error) == OBC_INVALID_ARGUMENT);
  CHECK(mesh == nullptr);
  // A caller whose header knew no cells.
  cells = cube.cells();
  cells.struct_size = offsetof(obc_mesh_cells, tetrahedra);
  CHECK(obc_mesh_tetrahedron_count(create(cells).get()) == 0);

  CHECK(obc_mesh_vertex_count(nullptr) == 0);
  CHECK(obc_mesh_copy(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_surface(nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_check_cells(nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_make(nullptr, 1000, 0, nullptr, &mesh, nullptr) == OBC_INVALID_ARGUMENT);
  obc_mesh_destroy(nullptr);
  obc_mesh_search_destroy(nullptr);

  const obc_surface surface = cube.surface();
  obc_surface bad = surface;
  obc_mesh_topology_report report;
  obc_mesh_topology_report_init(&report, sizeof report);
  CHECK(obc_mesh_topology(nullptr, nullptr, &report, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_topology(&surface, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  bad.triangles = nullptr;
  CHECK(obc_mesh_topology(&bad, nullptr, &report, nullptr) == OBC_INVALID_ARGUMENT);
  bad = surface;
  bad.vertex_count = 5;
  std::size_t count = 0;
  std::array<std::uint32_t, 36> triangles = cube.triangles;
  CHECK(obc_mesh_topology(&bad, nullptr, &report, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_check_closed_genus_zero(&bad, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_intersections(&bad, nullptr, nullptr, 0, &count, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_intersections(&surface, nullptr, nullptr, 1, &count, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_search_create(&bad, nullptr, &search, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_search_create(&surface, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_orient(cube.positions.data(), 5, triangles.data(), 12, nullptr, nullptr, nullptr) ==
        OBC_INVALID_ARGUMENT);
  Cube infinite;
  infinite.positions[4] = std::numeric_limits<double>::infinity();
  const obc_surface not_finite = infinite.surface();
  CHECK(obc_mesh_topology(&not_finite, nullptr, &report, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_search_create(&not_finite, nullptr, &search, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(search == nullptr);

  // Nothing is a surface too.
  const obc_surface empty{nullptr, 0, nullptr, 0};
  CHECK(topology(empty).triangles == 0);
  CHECK(obc_mesh_check_closed_genus_zero(&empty, nullptr, &error) == OBC_MALFORMED_FILE);
  CHECK(std::string(error.kind) == "empty-mesh");
  REQUIRE(obc_mesh_search_create(&empty, nullptr, &search, nullptr) == OBC_OK);
  const Search owner(search);
  const double origin[3] = {0, 0, 0};
  CHECK(obc_mesh_search_surface(search, origin, 1, nullptr, nullptr, nullptr, nullptr, nullptr) ==
        OBC_INVALID_ARGUMENT);
}

TEST_CASE("A report is written as far as the caller's header goes") {
  const Cube cube;
  const obc_surface surface = cube.surface();
  obc_mesh_topology_report report;
  std::memset(&report, 0x55, sizeof report);
  report.struct_size = offsetof(obc_mesh_topology_report, triangles);
  REQUIRE(obc_mesh_topology(&surface, nullptr, &report, nullptr) == OBC_OK);
  CHECK(report.vertices == 8);
  CHECK(report.triangles == 0x5555555555555555U);
  report.struct_size = 0;
  CHECK(obc_mesh_topology(&surface, nullptr, &report, nullptr) == OBC_INVALID_ARGUMENT);
}

namespace {

// Everything that the library does with a surface, one function after the other.
obc_status use_everything(const obc_host& host) {
  const Cube cube;
  const obc_surface surface = cube.surface();
  const obc_mesh_cells cells = cube.cells();
  obc_mesh* mesh = nullptr;
  obc_status status = obc_mesh_create(&cells, &host, &mesh, nullptr);
  if (status == OBC_OK) status = obc_mesh_check_cells(mesh, &host, nullptr);
  obc_mesh* boundary = nullptr;
  if (status == OBC_OK) status = obc_mesh_boundary(mesh, &host, &boundary, nullptr);
  obc_mesh_destroy(boundary);
  obc_mesh_destroy(mesh);
  mesh = nullptr;
  if (status == OBC_OK) status = obc_mesh_make("cube", 500, 0, &host, &mesh, nullptr);
  obc_mesh_destroy(mesh);
  obc_mesh_topology_report report;
  obc_mesh_topology_report_init(&report, sizeof report);
  std::array<std::uint32_t, 36> triangles = cube.triangles;
  std::swap(triangles[0], triangles[1]);
  if (status == OBC_OK) {
    const obc_surface turned{cube.positions.data(), 8, triangles.data(), 12};
    status = obc_mesh_topology(&turned, &host, &report, nullptr);
  }
  if (status == OBC_OK) status = obc_mesh_check_closed_genus_zero(&surface, &host, nullptr);
  const auto before = triangles;
  if (status == OBC_OK) {
    status = obc_mesh_orient(cube.positions.data(), 8, triangles.data(), 12, &host, nullptr, nullptr);
    if (status != OBC_OK && triangles != before) return OBC_INTERNAL;
  }
  std::array<std::uint32_t, 8> first{};
  if (status == OBC_OK)
    status = obc_mesh_first_at_same_position(cube.positions.data(), 8, &host, first.data(), nullptr);
  Cube pushed;
  pushed.positions[21] = pushed.positions[22] = pushed.positions[23] = -1;
  const obc_surface meeting = pushed.surface();
  std::array<std::uint32_t, 40> pairs{};
  std::size_t count = 0;
  if (status == OBC_OK) status = obc_mesh_intersections(&meeting, &host, pairs.data(), 20, &count, nullptr);
  std::array<double, 24> normals{};
  if (status == OBC_OK) status = obc_mesh_vertex_normals(&surface, &host, normals.data(), nullptr);
  if (status == OBC_OK) status = obc_mesh_vertex_areas(&surface, &host, normals.data(), nullptr);
  obc_mesh_distance distance;
  obc_mesh_distance_init(&distance, sizeof distance);
  if (status == OBC_OK) status = obc_mesh_surface_distance(&surface, &surface, &host, &distance, nullptr);
  if (status == OBC_OK)
    status = obc_mesh_mean_distance(cube.positions.data(), 8, normals.data(), 8, &host, &distance.first_mean, nullptr);
  obc_mesh_search* search = nullptr;
  if (status == OBC_OK) status = obc_mesh_search_create(&surface, &host, &search, nullptr);
  obc_mesh_search_destroy(search);
  return status;
}

}  // namespace

TEST_CASE("Each allocation of everything fails in turn and nothing is leaked") {
  const test::Outcome outcome = test::fail_each_allocation(use_everything);
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 40);
}

TEST_CASE("Everything can be cancelled at each of its reports") {
  const test::Outcome outcome = test::cancel_everywhere(use_everything, 200);
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 20);
}

TEST_CASE("Intersections are the same for any number of threads") {
  obc_mesh* made = nullptr;
  REQUIRE(obc_mesh_make("creature", 3000, 5, nullptr, &made, nullptr) == OBC_OK);
  const Mesh mesh(made);
  std::vector<double> positions(3 * obc_mesh_vertex_count(made));
  std::vector<std::uint32_t> triangles(3 * obc_mesh_triangle_count(made));
  REQUIRE(obc_mesh_copy(made, positions.data(), triangles.data(), nullptr, nullptr, nullptr) == OBC_OK);
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] += 0.3 * std::sin(37.0 * static_cast<double>(i));  // crumpled
  const obc_surface surface{positions.data(), positions.size() / 3, triangles.data(), triangles.size() / 3};
  std::array<std::vector<std::uint32_t>, 2> pairs;
  for (const std::uint32_t threads : {1U, 4U}) {
    obc_host host;
    obc_host_init(&host, sizeof host);
    host.thread_count = threads;
    std::vector<std::uint32_t>& found = pairs[threads / 4];
    found.resize(20000);
    std::size_t count = 0;
    REQUIRE(obc_mesh_intersections(&surface, &host, found.data(), 10000, &count, nullptr) == OBC_OK);
    CHECK(count > 100);
  }
  CHECK(pairs[0] == pairs[1]);
}

TEST_CASE("The version is that of the family") {
  CHECK(obc_mesh_version() == obc_base_version());
}
