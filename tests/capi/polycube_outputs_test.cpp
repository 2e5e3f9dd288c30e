// The C functions for a polycube's graph and quads, for maps to polycubes that are given, and for one that shapes
// share.
#include "orbicube/polycube.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "polycube_cube.h"

using namespace orbicube;
using test::check_every_end, test::cube, test::sphere, test::triangles;

TEST_CASE("The polycube of a cube's map as a graph, and its quads") {
  const std::vector<double> in_space = sphere();
  const obc_surface surface = {in_space.data(), 8, triangles.data(), 12};
  obc_polycube* map = nullptr;
  obc_error error;
  REQUIRE(obc_polycube_create(&surface, cube.data(), nullptr, nullptr, &map, &error) == OBC_OK);
  obc_polycube_graph* graph = nullptr;
  REQUIRE(obc_polycube_graph_create(map, nullptr, &graph, &error) == OBC_OK);
  CHECK(obc_polycube_graph_corner_count(graph) == 8);
  CHECK(obc_polycube_graph_edge_count(graph) == 12);
  CHECK(obc_polycube_graph_patch_count(graph) == 6);
  CHECK(obc_polycube_graph_loop_count(graph) == 6);
  CHECK(obc_polycube_graph_link_count(graph) == 24);
  std::vector<double> positions(24), coordinates(6);
  std::vector<std::uint32_t> vertices(8), ends(24), sides(24), loop_starts(7), starts(7), darts(24), dual(7), links(24);
  std::vector<std::uint8_t> convex(12), labels(6);
  REQUIRE(obc_polycube_graph_copy_corners(graph, positions.data(), vertices.data(), &error) == OBC_OK);
  REQUIRE(obc_polycube_graph_copy_edges(graph, ends.data(), sides.data(), convex.data(), &error) == OBC_OK);
  REQUIRE(obc_polycube_graph_copy_patches(graph, labels.data(), coordinates.data(), loop_starts.data(), &error) ==
          OBC_OK);
  REQUIRE(obc_polycube_graph_copy_loops(graph, starts.data(), darts.data(), &error) == OBC_OK);
  REQUIRE(obc_polycube_graph_copy_dual(graph, dual.data(), links.data(), &error) == OBC_OK);
  CHECK(positions == cube);
  for (std::uint32_t c = 0; c < 8; ++c)
    CHECK(vertices[c] == c);
  for (std::uint32_t p = 0; p < 6; ++p) {
    CHECK(coordinates[p] == (labels[p] % 2 == 0 ? 2 : 0));
    CHECK(loop_starts[p + 1] - loop_starts[p] == 1);
    CHECK(starts[p + 1] - starts[p] == 4);
    CHECK(dual[p + 1] - dual[p] == 4);
    for (std::uint32_t i = starts[p]; i < starts[p + 1]; ++i)
      CHECK(sides[darts[i]] == p);
    // Not opposite faces.
    for (std::uint32_t i = dual[p]; i < dual[p + 1]; ++i)
      CHECK(labels[links[i]] / 2 != labels[p] / 2);
  }
  for (std::uint32_t e = 0; e < 12; ++e) {
    CHECK(convex[e] == 1);
    CHECK(ends[2 * e] != ends[2 * e + 1]);
    CHECK(sides[2 * e] != sides[2 * e + 1]);
  }
  CHECK(obc_polycube_graph_copy_corners(graph, nullptr, nullptr, &error) == OBC_OK);
  CHECK(obc_polycube_graph_copy_edges(graph, nullptr, nullptr, nullptr, &error) == OBC_OK);
  CHECK(obc_polycube_graph_copy_patches(graph, nullptr, nullptr, nullptr, &error) == OBC_OK);
  CHECK(obc_polycube_graph_copy_loops(graph, nullptr, nullptr, &error) == OBC_OK);
  CHECK(obc_polycube_graph_copy_dual(graph, nullptr, nullptr, &error) == OBC_OK);
  obc_polycube_graph_destroy(graph);

  obc_polycube_quads_options options;
  REQUIRE(obc_polycube_quads_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.quads == 10000);
  CHECK(options.edge_length == 0);
  options.edge_length = 1;
  obc_polycube_quads* quads = nullptr;
  REQUIRE(obc_polycube_quads_create(map, &options, nullptr, &quads, &error) == OBC_OK);
  CHECK(obc_polycube_quads_quad_count(quads) == 24);
  const std::size_t count = obc_polycube_quads_vertex_count(quads);
  REQUIRE(count == 26);
  std::vector<double> at(3 * count), on(3 * count), weights(3 * count);
  std::vector<std::uint32_t> corners(96), patches(24), in(count);
  REQUIRE(obc_polycube_quads_copy(quads, at.data(), on.data(), corners.data(), patches.data(), &error) == OBC_OK);
  REQUIRE(obc_polycube_quads_copy_sources(quads, in.data(), weights.data(), &error) == OBC_OK);
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      double x = 0, y = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        x += weights[3 * v + i] * in_space[3 * triangles[3 * in[v] + i] + k];
        y += weights[3 * v + i] * cube[3 * triangles[3 * in[v] + i] + k];
      }
      CHECK(x == doctest::Approx(at[3 * v + k]));
      CHECK(y == doctest::Approx(on[3 * v + k]));
    }
  }
  CHECK(*std::max_element(corners.begin(), corners.end()) == count - 1);
  CHECK(*std::max_element(patches.begin(), patches.end()) == 5);
  CHECK(obc_polycube_quads_copy(quads, nullptr, nullptr, nullptr, nullptr, &error) == OBC_OK);
  CHECK(obc_polycube_quads_copy_sources(quads, nullptr, nullptr, &error) == OBC_OK);
  obc_polycube_quads_destroy(quads);

  CHECK(obc_polycube_graph_create(nullptr, nullptr, &graph, &error) == OBC_INVALID_ARGUMENT);
  CHECK(graph == nullptr);
  CHECK(obc_polycube_graph_create(map, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_graph_copy_corners(nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_graph_copy_edges(nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_graph_copy_patches(nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_graph_copy_loops(nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_graph_copy_dual(nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_graph_corner_count(nullptr) + obc_polycube_graph_edge_count(nullptr) +
            obc_polycube_graph_patch_count(nullptr) + obc_polycube_graph_loop_count(nullptr) +
            obc_polycube_graph_link_count(nullptr) + obc_polycube_quads_vertex_count(nullptr) +
            obc_polycube_quads_quad_count(nullptr) ==
        0);
  obc_polycube_graph_destroy(nullptr);
  for (const double length : {-1.0, 1e-9, std::numeric_limits<double>::quiet_NaN()}) {
    options.edge_length = length;
    CHECK(obc_polycube_quads_create(map, &options, nullptr, &quads, &error) == OBC_INVALID_ARGUMENT);
    CHECK(quads == nullptr);
  }
  options.edge_length = 0;
  options.quads = 0;
  CHECK(obc_polycube_quads_create(map, &options, nullptr, &quads, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_quads_create(nullptr, nullptr, nullptr, &quads, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_quads_create(map, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_quads_copy(nullptr, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_quads_copy_sources(nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_quads_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  obc_polycube_quads_destroy(nullptr);

  const test::Call call = [&](const obc_host& host) {
    obc_polycube_graph* made = nullptr;
    obc_status status = obc_polycube_graph_create(map, &host, &made, nullptr);
    obc_polycube_graph_destroy(made);
    if (status != OBC_OK) return status;
    obc_polycube_quads_options few;
    obc_polycube_quads_options_init(&few, sizeof few);
    few.quads = 24;
    obc_polycube_quads* grid = nullptr;
    status = obc_polycube_quads_create(map, &few, &host, &grid, nullptr);
    obc_polycube_quads_destroy(grid);
    return status;
  };
  check_every_end(call);
  obc_polycube_destroy(map);
}

TEST_CASE("A sphere's triangles are mapped to the polycube that is given, with a corner at its target" *
          doctest::test_suite("long")) {
  obc_mesh* mesh = nullptr;
  obc_surface surface;
  obc_error error;
  REQUIRE(obc_mesh_make("sphere", 400, 0, nullptr, &mesh, &error) == OBC_OK);
  REQUIRE(obc_mesh_surface(mesh, &surface, &error) == OBC_OK);
  const obc_surface box = {cube.data(), 8, triangles.data(), 12};
  std::uint32_t nearest = 0;  // to the direction of corner 7
  for (std::uint32_t v = 0; v < surface.vertex_count; ++v) {
    const auto along = [&](std::uint32_t i) {
      return surface.positions[3 * i] + surface.positions[3 * i + 1] + surface.positions[3 * i + 2];
    };
    if (along(v) > along(nearest)) nearest = v;
  }
  const std::vector<std::uint32_t> corners = {7, 0}, vertices = {nearest, UINT32_MAX};
  const std::vector<double> points = {0, 0, 0, -1, -1, -1};
  obc_polycube_constraints places = {corners.data(), vertices.data(), points.data(), 2};
  obc_polycube* map = nullptr;
  REQUIRE(obc_polycube_map_to_domain(&surface, &box, &places, nullptr, &map, &error) == OBC_OK);
  CHECK(obc_polycube_corner_count(map) == 8);
  CHECK(obc_polycube_construction(map) == -1);
  const std::size_t count = obc_polycube_vertex_count(map);
  std::vector<double> positions(3 * count), polycube(3 * count);
  REQUIRE(obc_polycube_copy(map, positions.data(), polycube.data(), nullptr, &error) == OBC_OK);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(polycube[3 * nearest + k] == 2);
  std::size_t at_origin = 0;
  for (std::size_t v = 0; v < count; ++v) {
    if (polycube[3 * v] != 0 || polycube[3 * v + 1] != 0 || polycube[3 * v + 2] != 0) continue;
    ++at_origin;
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(positions[3 * v + k] == doctest::Approx(-1 / std::sqrt(3.0)).epsilon(0.1));
  }
  CHECK(at_origin == 1);
  obc_polycube_destroy(map);
  REQUIRE(obc_polycube_map_to_domain(&surface, &box, nullptr, nullptr, &map, &error) == OBC_OK);
  obc_polycube_destroy(map);

  std::vector<double> bent = cube;
  bent[0] = 0.5;
  const obc_surface no_polycube = {bent.data(), 8, triangles.data(), 12};
  CHECK(obc_polycube_map_to_domain(&surface, &no_polycube, nullptr, nullptr, &map, &error) == OBC_UNSUPPORTED);
  CHECK(map == nullptr);
  CHECK(std::string(error.message).find("axis-aligned") != std::string::npos);
  CHECK(obc_polycube_map_to_domain(nullptr, &box, nullptr, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_map_to_domain(&surface, nullptr, nullptr, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_map_to_domain(&surface, &box, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  places.corners = nullptr;
  CHECK(obc_polycube_map_to_domain(&surface, &box, &places, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  const std::vector<std::uint32_t> none = {8, 0}, same = {7, 7};
  for (const std::uint32_t* wrong : {none.data(), same.data()}) {
    places.corners = wrong;
    CHECK(obc_polycube_map_to_domain(&surface, &box, &places, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  }
  places = {corners.data(), vertices.data(), nullptr, 2};
  CHECK(obc_polycube_map_to_domain(&surface, &box, &places, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  obc_mesh* ring = nullptr;
  obc_surface torus;
  REQUIRE(obc_mesh_make("torus", 400, 0, nullptr, &ring, &error) == OBC_OK);
  REQUIRE(obc_mesh_surface(ring, &torus, &error) == OBC_OK);
  CHECK(obc_polycube_map_to_domain(&torus, &box, nullptr, nullptr, &map, &error) == OBC_WRONG_GENUS);
  CHECK(map == nullptr);
  obc_mesh_destroy(ring);
  obc_mesh_destroy(mesh);

  const std::vector<double> in_space = sphere();
  const obc_surface few = {in_space.data(), 8, triangles.data(), 12};
  const std::uint32_t corner = 7, vertex = 7;
  const obc_polycube_constraints one = {&corner, &vertex, nullptr, 1};
  const test::Call call = [&](const obc_host& host) {
    obc_polycube* made = nullptr;
    const obc_status status = obc_polycube_map_to_domain(&few, &box, &one, &host, &made, nullptr);
    obc_polycube_destroy(made);
    return status;
  };
  check_every_end(call, 300);
}

TEST_CASE(
    "Arrays of surfaces and of maps are refused where they, a member or the count is none, and no handle is left") {
  const obc_surface box = {cube.data(), 8, triangles.data(), 12};
  obc_error error;
  obc_polycube* map = nullptr;
  REQUIRE(obc_polycube_create(&box, cube.data(), nullptr, nullptr, &map, &error) == OBC_OK);
  obc_polycube* const untouched = map;
  for (const std::size_t count : {SIZE_MAX, SIZE_MAX / sizeof(obc_surface), std::size_t{65537}, std::size_t{0}}) {
    obc_polycube* out[2] = {untouched, untouched};
    CHECK(obc_polycube_compute_common(&box, count, nullptr, nullptr, nullptr, nullptr, out, &error) ==
          OBC_INVALID_ARGUMENT);
    CHECK(obc_polycube_compute_common(nullptr, count, nullptr, nullptr, nullptr, nullptr, out, &error) ==
          OBC_INVALID_ARGUMENT);
    CHECK(obc_polycube_optimize_common_domain(&map, count, nullptr, nullptr, out, &error) == OBC_INVALID_ARGUMENT);
    CHECK(obc_polycube_optimize_common_domain(nullptr, count, nullptr, nullptr, out, &error) == OBC_INVALID_ARGUMENT);
    CHECK((out[0] == untouched && out[1] == untouched));
  }
  for (const obc_surface& none : {obc_surface{nullptr, 8, triangles.data(), 12},
                                  obc_surface{cube.data(), 8, nullptr, 12}, obc_surface{nullptr, 0, nullptr, 0}}) {
    const obc_surface given[2] = {box, none};
    obc_polycube* out[2] = {untouched, untouched};
    CHECK(obc_polycube_compute_common(given, 2, nullptr, nullptr, nullptr, nullptr, out, &error) != OBC_OK);
    CHECK(error.message[0] != '\0');
    CHECK((out[0] == nullptr && out[1] == nullptr));
  }
  for (const std::size_t missing : {0U, 1U}) {
    const obc_polycube* given[2] = {map, map};
    given[missing] = nullptr;
    obc_polycube* out[2] = {untouched, untouched};
    CHECK(obc_polycube_optimize_common_domain(given, 2, nullptr, nullptr, out, &error) == OBC_INVALID_ARGUMENT);
    CHECK(std::string(error.message) == "a map is NULL");
    CHECK((out[0] == nullptr && out[1] == nullptr));
  }
  obc_polycube* out[1] = {untouched};
  CHECK(obc_polycube_compute_common(nullptr, 1, nullptr, nullptr, nullptr, nullptr, out, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(out[0] == nullptr);
  CHECK(obc_polycube_compute_common(&box, 1, nullptr, nullptr, nullptr, nullptr, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  obc_polycube_destroy(map);
}

TEST_CASE("Two boxes share a polycube with the proportions that suit both") {
  const auto stretched = [](std::size_t axis) {
    std::vector<double> result = cube;
    for (std::size_t i = axis; i < result.size(); i += 3)
      result[i] *= 2;
    return result;
  };
  const std::vector<double> wide = stretched(0), tall = stretched(2);
  const std::vector<obc_surface> boxes = {{wide.data(), 8, triangles.data(), 12},
                                          {tall.data(), 8, triangles.data(), 12}};
  obc_error error;
  obc_polycube* maps[2] = {nullptr, nullptr};
  obc_polycube* best[2] = {nullptr, nullptr};
  for (std::size_t i = 0; i < 2; ++i)
    REQUIRE(obc_polycube_create(&boxes[i], cube.data(), nullptr, nullptr, &maps[i], &error) == OBC_OK);
  REQUIRE(obc_polycube_optimize_common_domain(maps, 2, nullptr, nullptr, best, &error) == OBC_OK);
  std::vector<double> first(24), second(24);
  REQUIRE(obc_polycube_copy(best[0], nullptr, first.data(), nullptr, &error) == OBC_OK);
  REQUIRE(obc_polycube_copy(best[1], nullptr, second.data(), nullptr, &error) == OBC_OK);
  CHECK(first == second);
  CHECK(first[21] - first[0] == doctest::Approx(first[23] - first[2]).epsilon(1e-6));  // as long along x as along z
  CHECK(first[21] - first[0] > 1.05 * (first[22] - first[1]));
  std::vector<double> energies(obc_polycube_energy_count(best[0]));
  REQUIRE(energies.size() >= 2);
  REQUIRE(obc_polycube_copy_energies(best[1], energies.data(), &error) == OBC_OK);
  CHECK(std::is_sorted(energies.rbegin(), energies.rend()));
  for (obc_polycube*& map : best) {
    obc_polycube_destroy(map);
    map = nullptr;
  }

  obc_polycube_options options;
  REQUIRE(obc_polycube_options_init(&options, sizeof options) == OBC_OK);
  options.corners = 8;
  std::size_t constructed_from = 2;
  REQUIRE(obc_polycube_compute_common(boxes.data(), 2, &options, nullptr, nullptr, &constructed_from, best, &error) ==
          OBC_OK);
  CHECK(constructed_from < 2);
  for (obc_polycube*& map : best) {
    CHECK(obc_polycube_corner_count(map) == 8);
    CHECK(obc_polycube_patch_count(map) == 6);
    CHECK(obc_polycube_energy_count(map) >= 1);
    obc_polycube_destroy(map);
    map = nullptr;
  }

  CHECK(obc_polycube_optimize_common_domain(maps, 0, nullptr, nullptr, best, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_optimize_common_domain(nullptr, 2, nullptr, nullptr, best, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_optimize_common_domain(maps, 2, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_compute_common(nullptr, 2, nullptr, nullptr, nullptr, nullptr, best, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_compute_common(boxes.data(), 0, nullptr, nullptr, nullptr, nullptr, best, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_compute_common(boxes.data(), 2, nullptr, nullptr, nullptr, nullptr, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  // Maps to different polycubes have nothing in common.
  obc_polycube_destroy(maps[1]);
  REQUIRE(obc_polycube_create(&boxes[1], tall.data(), nullptr, nullptr, &maps[1], &error) == OBC_OK);
  CHECK(obc_polycube_optimize_common_domain(maps, 2, nullptr, nullptr, best, &error) == OBC_INVALID_ARGUMENT);
  CHECK(best[0] == nullptr);
  obc_polycube* const with_none[2] = {maps[0], nullptr};
  CHECK(obc_polycube_optimize_common_domain(with_none, 2, nullptr, nullptr, best, &error) == OBC_INVALID_ARGUMENT);
  obc_polycube_destroy(maps[1]);
  REQUIRE(obc_polycube_create(&boxes[1], cube.data(), nullptr, nullptr, &maps[1], &error) == OBC_OK);
  const test::Call call = [&](const obc_host& host) {
    obc_polycube* made[2] = {nullptr, nullptr};
    const obc_status status = obc_polycube_optimize_common_domain(maps, 2, nullptr, &host, made, nullptr);
    for (obc_polycube* map : made)
      obc_polycube_destroy(map);
    return status;
  };
  check_every_end(call);
  for (obc_polycube* map : maps)
    obc_polycube_destroy(map);
  const test::Call common = [&](const obc_host& host) {
    obc_polycube* made[2] = {nullptr, nullptr};
    const obc_status status =
        obc_polycube_compute_common(boxes.data(), 2, &options, nullptr, &host, nullptr, made, nullptr);
    for (obc_polycube* map : made)
      obc_polycube_destroy(map);
    return status;
  };
  // Its allocations are those of the parts, which have their own tests.
  const test::Outcome cancelled = test::cancel_everywhere(common, 20);
  CHECK(cancelled.problem == "");
  CHECK(cancelled.runs > 10);
}
