// The C++ wrappers of solids: tetrahedra untangled, mapped to polycubes and along frames, and hexahedra.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <doctest/doctest.h>

#include <orbicube/frame_field.hpp>
#include <orbicube/hexmesh.hpp>
#include <orbicube/polycube.hpp>
#include <orbicube/untangle.hpp>
#include <orbicube/volume_map.hpp>

using namespace orbicube;

TEST_CASE("inverted tetrahedra are untangled, or the best is handed out with the error") {
  // Four tetrahedra around a vertex that has left the one that they fill.
  const std::vector<double> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 2, 2};
  const std::vector<std::uint32_t> cells = {0, 1, 2, 4, 0, 2, 3, 4, 0, 3, 1, 4, 1, 3, 2, 4};
  untangle::Tetrahedra problem(positions, cells);
  const auto right = untangle::tetrahedra(problem);
  CHECK(right.report.inverted_before > 0);
  CHECK(right.report.inverted == 0);
  CHECK(std::equal(positions.begin(), positions.begin() + 12, right.positions.begin()));

  const std::vector<std::uint8_t> fixed(5, 1);
  problem.fixed = fixed.data();
  untangle::Untangled best;
  CHECK_THROWS_AS(untangle::tetrahedra(problem, {}, nullptr, &best), Error);
  CHECK(best.positions == positions);
  CHECK(best.report.inverted == right.report.inverted_before);
}

TEST_CASE("flipped triangles of a flat mesh are untangled") {
  // Four triangles around a vertex that has left the square that they fill.
  const std::vector<double> flat = {0, 0, 1, 0, 1, 1, 0, 1, 3, 2};
  const std::vector<std::uint32_t> corners = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  const auto right = untangle::triangles(untangle::Triangles(flat, corners));
  CHECK(right.report.inverted_before > 0);
  CHECK(right.report.inverted == 0);
  CHECK(std::equal(flat.begin(), flat.begin() + 8, right.positions.begin()));
  for (std::size_t i = 8; i < 10; ++i)
    CHECK(right.positions[i] == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("elements that have no room are split") {
  // Around an edge that passes outside of the triangle in the middle, and on both sides of a diagonal outside of a
  // dart.
  const std::vector<double> places = {0, 0, -1, 3, 0, 1, 1, 0, 0, -0.5, 0.75, 0, -0.5, -0.75, 0};
  const std::vector<std::uint32_t> cells = {0, 1, 2, 3, 0, 1, 3, 4, 0, 1, 4, 2};
  const untangle::Refined solid = untangle::refine_tetrahedra(untangle::Tetrahedra(places, cells));
  CHECK(solid.report.inverted_before == 2);
  CHECK(solid.report.inverted == 0);
  CHECK(solid.elements.size() == 24);
  CHECK(solid.parents.size() == 6);
  CHECK(std::equal(places.begin(), places.end(), solid.positions.begin()));
  CHECK(std::vector<double>(solid.weights.end() - 4, solid.weights.end()) == std::vector<double>{0.5, 0.5, 0, 0});
  const std::vector<double> dart = {0, 0, 2, 1, 0, 4, 1, 1};
  const untangle::Refined flat =
      untangle::refine_triangles(untangle::Triangles(dart, std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  CHECK(flat.report.inverted == 0);
  CHECK(flat.positions.size() == 10);
  CHECK(flat.elements.size() == 12);
  CHECK(flat.origins.size() == 15);
  CHECK_THROWS_AS(untangle::refine_triangles(untangle::Triangles(dart, std::vector<std::uint32_t>{0, 1, 7})), Error);
}

TEST_CASE("a cube is filled with hexahedra, and a tetrahedral cube goes to its polycube") {
  const std::vector<double> corners = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, 2, 1, 1, 1};
  const std::vector<std::uint32_t> triangles = {0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                                1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
  hexmesh::Options options;
  options.cells = 27;
  options.padding = OBC_HEXMESH_PADDING_WITHOUT;
  const auto hexes = hexmesh::fill_with_hexahedra(Surface(Doubles(corners.data(), 24), triangles), options);
  CHECK(hexes.hexahedra.size() == 8 * 27);
  CHECK(hexes.positions.size() == 3 * 64);
  CHECK(hexes.quads.size() == 4 * 54);
  CHECK(hexes.quad_patches.size() == 54);
  CHECK(hexes.report.volume == doctest::Approx(8));

  // The same with a vertex in the middle.
  std::vector<std::uint32_t> tetrahedra;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
    tetrahedra.insert(tetrahedra.end(), {8, triangles[t], triangles[t + 1], triangles[t + 2]});
  const auto solid = volume_map::map_to_polycube(corners, tetrahedra);
  CHECK(solid.tetrahedra.size() >= tetrahedra.size());
  CHECK(solid.polycube.size() == solid.positions.size());
}

TEST_CASE("a tetrahedral cube is parameterized along its axes, and a map of it is a function with an inverse") {
  std::vector<double> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1}, image, axes;
  const std::vector<std::uint32_t> cells = {0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7, 0, 6, 4, 7, 0, 4, 5, 7, 0, 5, 1, 7};
  for (int t = 0; t < 6; ++t)
    axes.insert(axes.end(), {1, 0, 0, 0});
  volume_map::FrameMapOptions options;
  options.cell_length = 0.5;
  options.integer = 1;
  const auto map = volume_map::parameterize(corners, cells, axes, options);
  CHECK(map.report.inverted == 0);
  CHECK(map.report.patches == 6);
  CHECK(map.singular_edges.empty());
  for (std::size_t i = 0; i < map.parameters.size(); ++i) {
    const double moved = 2 * (corners[3 * cells[i / 3] + i % 3] - corners[3 * cells[0] + i % 3]);
    CHECK(std::abs(map.parameters[i] - map.parameters[i % 3] - moved) < 1e-6);
  }
  CHECK_THROWS_AS(volume_map::parameterize(corners, cells, Doubles(axes.data(), 20), options), Error);

  for (const double x : corners)
    image.push_back(2 * x + 1);
  const std::vector<double> points = {0.25, 0.5, 0.875, 2, 0, 0};
  const std::vector<double> images = volume_map::Locator(corners, cells).sample(points, image);
  CHECK(images[2] == doctest::Approx(2.75));
  CHECK(images[3] != images[3]);
  const std::vector<double> back = volume_map::Locator(image, cells).sample(Doubles(images.data(), 3), corners);
  for (std::size_t a = 0; a < 3; ++a)
    CHECK(back[a] == doctest::Approx(points[a]));
}

TEST_CASE("frames to start from are one a tetrahedron") {
  const std::vector<double> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, too_few = {1, 0, 0};
  const std::vector<std::uint32_t> cells = {0, 1, 2, 3};
  CHECK_THROWS_AS(frame_field::compute(frame_field::Solid(corners, cells), {}, {}, too_few), Error);
}

TEST_CASE("hexahedra follow the frames of a tetrahedral cube") {
  const std::vector<double> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
  const std::vector<std::uint32_t> cells = {0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7, 0, 6, 4, 7, 0, 4, 5, 7, 0, 5, 1, 7};
  hexmesh::Options options;
  options.method = OBC_HEXMESH_METHOD_FRAMES;
  options.cells = 8;
  const auto hexes = hexmesh::fill_with_hexahedra(corners, cells, {}, options);
  CHECK(hexes.hexahedra.size() == 8 * 8);
  CHECK(hexes.positions.size() == 3 * 27);
  CHECK(hexes.quads.size() == 4 * 24);
  CHECK(hexes.report.volume == doctest::Approx(1));
  CHECK(hexes.report.min_scaled_jacobian > 0.99);
  Mesh::Cells given;
  given.positions = hexes.positions.data();
  given.vertex_count = 27;
  given.hexahedra = hexes.hexahedra.data();
  given.hexahedron_count = 8;
  Mesh(given).check_cells();
  CHECK(Mesh(given).hexahedron_regions().empty());
  const std::vector<std::int32_t> regions = {1, 2, 3, 4, 5, 6, 7, -8};
  given.hexahedron_regions = regions.data();
  CHECK(Mesh(given).hexahedron_regions() == regions);
  Host host;
  host.on_progress([](const Progress&) { return false; });
  CHECK_THROWS_AS(hexmesh::fill_with_hexahedra(corners, cells, {}, options, &host), Error);
}
