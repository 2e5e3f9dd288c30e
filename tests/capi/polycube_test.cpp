// The C functions of polycube: what they promise about arguments, memory and cancelling. What the maps are worth is
// tested in tests/polycube/.
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

TEST_CASE("A handle gives back the map that it was made of, with what certification found") {
  const std::vector<double> in_space = sphere();
  const obc_surface surface = {in_space.data(), 8, triangles.data(), 12};
  obc_polycube_certificate certificate{};
  certificate.struct_size = sizeof certificate;
  obc_polycube* map = nullptr;
  obc_error error;
  REQUIRE(obc_polycube_create(&surface, cube.data(), nullptr, &certificate, &map, &error) == OBC_OK);
  CHECK(certificate.valid == 1);
  CHECK(certificate.genus == 0);
  CHECK(certificate.corners == 8);
  CHECK(certificate.patches == 6);
  CHECK(std::string(certificate.reason) == "");
  CHECK(obc_polycube_vertex_count(map) == 8);
  CHECK(obc_polycube_triangle_count(map) == 12);
  CHECK(obc_polycube_corner_count(map) == 8);
  CHECK(obc_polycube_patch_count(map) == 6);
  CHECK(obc_polycube_construction(map) == -1);
  std::vector<double> positions(24), polycube(24), weights(24);
  std::vector<std::uint32_t> faces(36), patches(12), sources(12), corners(24);
  std::vector<std::uint8_t> labels(12);
  REQUIRE(obc_polycube_copy(map, positions.data(), polycube.data(), faces.data(), &error) == OBC_OK);
  REQUIRE(obc_polycube_copy_triangles(map, labels.data(), patches.data(), sources.data(), &error) == OBC_OK);
  REQUIRE(obc_polycube_copy_sources(map, corners.data(), weights.data(), &error) == OBC_OK);
  CHECK(positions == in_space);
  CHECK(polycube == cube);
  CHECK(faces == triangles);
  CHECK(labels == std::vector<std::uint8_t>{5, 5, 4, 4, 3, 3, 2, 2, 1, 1, 0, 0});
  for (std::uint32_t i = 0; i < 12; ++i) {
    CHECK(patches[i] == i / 2);
    CHECK(sources[i] == i);
  }
  for (std::uint32_t v = 0; v < 8; ++v) {
    CHECK(corners[3 * v] == v);
    CHECK(corners[3 * v + 1] == UINT32_MAX);
    CHECK(weights[3 * v] == 1);
  }
  CHECK(obc_polycube_copy(map, nullptr, nullptr, nullptr, &error) == OBC_OK);
  CHECK(obc_polycube_copy_triangles(map, nullptr, nullptr, nullptr, &error) == OBC_OK);
  CHECK(obc_polycube_copy_sources(map, nullptr, nullptr, &error) == OBC_OK);
  obc_polycube_destroy(map);
}

TEST_CASE("A map that is not valid makes no handle and has a reason") {
  const std::vector<double> in_space = sphere();
  const obc_surface surface = {in_space.data(), 8, triangles.data(), 12};
  obc_polycube_certificate certificate{};
  certificate.struct_size = sizeof certificate;
  obc_polycube* map = nullptr;
  obc_error error;
  CHECK(obc_polycube_create(&surface, in_space.data(), nullptr, &certificate, &map, &error) == OBC_OK);
  obc_polycube_destroy(map);
  std::vector<double> bent = cube;
  bent[0] = 0.5;
  CHECK(obc_polycube_create(&surface, bent.data(), nullptr, &certificate, &map, &error) == OBC_NO_VALID_RESULT);
  CHECK(map == nullptr);
  CHECK(certificate.valid == 0);
  CHECK(std::string(certificate.reason) == error.message);
  CHECK(std::string(certificate.reason).find("axis-aligned") != std::string::npos);
}

TEST_CASE("A polycube of a sphere's triangles is found, with its sources") {
  obc_mesh* mesh = nullptr;
  obc_surface surface;
  obc_error error;
  REQUIRE(obc_mesh_make("sphere", 600, 0, nullptr, &mesh, &error) == OBC_OK);
  REQUIRE(obc_mesh_surface(mesh, &surface, &error) == OBC_OK);
  obc_polycube_options options;
  REQUIRE(obc_polycube_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.construction == OBC_POLYCUBE_AUTO);
  options.corners = 8;
  obc_polycube* map = nullptr;
  for (const std::int32_t construction : {OBC_POLYCUBE_LABELS, OBC_POLYCUBE_VOXELS}) {
    options.construction = construction;
    REQUIRE(obc_polycube_compute(&surface, &options, nullptr, &map, &error) == OBC_OK);
    CHECK(obc_polycube_corner_count(map) == 8);
    CHECK(obc_polycube_construction(map) == construction);
    obc_polycube_destroy(map);
  }
  options.construction = OBC_POLYCUBE_AUTO;
  REQUIRE(obc_polycube_compute(&surface, &options, nullptr, &map, &error) == OBC_OK);
  CHECK(obc_polycube_construction(map) != OBC_POLYCUBE_AUTO);
  CHECK(obc_polycube_corner_count(map) == 8);
  CHECK(obc_polycube_patch_count(map) == 6);
  const std::size_t count = obc_polycube_vertex_count(map);
  REQUIRE(count >= surface.vertex_count);
  std::vector<double> positions(3 * count), polycube(3 * count), weights(3 * count);
  std::vector<std::uint32_t> faces(3 * obc_polycube_triangle_count(map)), corners(3 * count);
  REQUIRE(obc_polycube_copy(map, positions.data(), polycube.data(), faces.data(), &error) == OBC_OK);
  REQUIRE(obc_polycube_copy_sources(map, corners.data(), weights.data(), &error) == OBC_OK);
  CHECK(std::equal(surface.positions, surface.positions + 3 * surface.vertex_count, positions.begin()));
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double x = 0;
      for (std::size_t k = 0; k < 3 && corners[3 * v + k] != UINT32_MAX; ++k)
        x += weights[3 * v + k] * surface.positions[3 * corners[3 * v + k] + axis];
      CHECK(x == doctest::Approx(positions[3 * v + axis]).epsilon(1e-14));
    }
  }
  const obc_surface refined = {positions.data(), count, faces.data(), faces.size() / 3};
  obc_polycube* again = nullptr;
  CHECK(obc_polycube_create(&refined, polycube.data(), nullptr, nullptr, &again, &error) == OBC_OK);
  obc_polycube_destroy(again);
  obc_polycube_destroy(map);
  options.corners = 7;
  CHECK(obc_polycube_compute(&surface, &options, nullptr, &map, &error) == OBC_NO_VALID_RESULT);
  CHECK(map == nullptr);
  obc_mesh_destroy(mesh);
}

TEST_CASE("Wrong arguments are refused, not followed") {
  const obc_surface surface = {cube.data(), 8, triangles.data(), 12};
  obc_polycube* map = nullptr;
  obc_error error;
  CHECK(obc_polycube_create(nullptr, cube.data(), nullptr, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_create(&surface, nullptr, nullptr, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_create(&surface, cube.data(), nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  std::vector<double> wild = cube;
  wild[5] = std::numeric_limits<double>::infinity();
  CHECK(obc_polycube_create(&surface, wild.data(), nullptr, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  std::vector<std::uint32_t> wrong = triangles;
  wrong[7] = 8;
  const obc_surface out_of_range = {cube.data(), 8, wrong.data(), 12};
  CHECK(obc_polycube_create(&out_of_range, cube.data(), nullptr, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  CHECK(map == nullptr);
  CHECK(obc_polycube_compute(nullptr, nullptr, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_compute(&surface, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_compute(&out_of_range, nullptr, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  const obc_surface open = {cube.data(), 8, triangles.data(), 11};
  CHECK(obc_polycube_compute(&open, nullptr, nullptr, &map, &error) == OBC_NOT_CLOSED);
  obc_polycube_options options;
  REQUIRE(obc_polycube_options_init(&options, sizeof options) == OBC_OK);
  const obc_surface closed = {cube.data(), 8, triangles.data(), 12};
  for (const std::int32_t construction : {-1, 4}) {
    options.construction = construction;
    CHECK(obc_polycube_compute(&closed, &options, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  }
  CHECK(obc_polycube_construction(nullptr) == -1);
  std::size_t corner_points = 7;
  CHECK(obc_polycube_corner_points(nullptr, nullptr, &corner_points, &error) == OBC_INVALID_ARGUMENT);
  CHECK(corner_points == 0);
  CHECK(obc_polycube_options_init(nullptr, sizeof(obc_polycube_options)) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_copy(nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_copy_triangles(nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_copy_sources(nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_vertex_count(nullptr) + obc_polycube_triangle_count(nullptr) + obc_polycube_corner_count(nullptr) +
            obc_polycube_patch_count(nullptr) ==
        0);
  obc_polycube_destroy(nullptr);
}

TEST_CASE("Each allocation that fails ends in out of memory, and each report may cancel") {
  const obc_surface surface = {cube.data(), 8, triangles.data(), 12};
  const test::Call call = [&](const obc_host& host) {
    obc_polycube* map = nullptr;
    const obc_status status = obc_polycube_create(&surface, cube.data(), &host, nullptr, &map, nullptr);
    obc_polycube_destroy(map);
    return status;
  };
  check_every_end(call);
}

TEST_CASE("Each allocation of a construction that fails ends in out of memory, and each report may cancel") {
  const obc_surface surface = {cube.data(), 8, triangles.data(), 12};
  const test::Call call = [&](const obc_host& host) {
    obc_polycube* map = nullptr;
    obc_polycube_options options;
    obc_polycube_options_init(&options, sizeof options);
    options.corners = 8;
    const obc_status status = obc_polycube_compute(&surface, &options, &host, &map, nullptr);
    obc_polycube_destroy(map);
    return status;
  };
  const test::Outcome memory = test::fail_each_allocation(call);
  CHECK(memory.problem == "");
  CHECK(memory.runs > 100);
  const test::Outcome cancelled = test::cancel_everywhere(call);
  CHECK(cancelled.problem == "");
  CHECK(cancelled.runs > 10);
}

TEST_CASE("The dissertation's method makes a certified map of a box, and its corner points are counted") {
  const obc_surface surface = {cube.data(), 8, triangles.data(), 12};
  obc_polycube_options options;
  REQUIRE(obc_polycube_options_init(&options, sizeof options) == OBC_OK);
  options.construction = OBC_POLYCUBE_DISSERTATION;
  obc_polycube* map = nullptr;
  obc_error error;
  REQUIRE(obc_polycube_compute(&surface, &options, nullptr, &map, &error) == OBC_OK);
  CHECK(obc_polycube_construction(map) == OBC_POLYCUBE_DISSERTATION);
  CHECK(obc_polycube_corner_count(map) == 8);
  std::size_t count = 0;
  REQUIRE(obc_polycube_corner_points(map, nullptr, &count, &error) == OBC_OK);
  CHECK(count == 8);
  CHECK(obc_polycube_corner_points(map, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  check_every_end([&](const obc_host& host) { return obc_polycube_corner_points(map, &host, &count, nullptr); });
  obc_polycube_destroy(map);
  CHECK(options.area_weight == 1);
  CHECK(options.rounds == 40);
  for (const std::uint32_t rounds : {0u, std::numeric_limits<std::uint32_t>::max()}) {
    options.rounds = rounds;
    REQUIRE(obc_polycube_compute(&surface, &options, nullptr, &map, &error) == OBC_OK);
    obc_polycube_destroy(map);
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double weight : {-1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    options.area_weight = weight;
    CHECK(obc_polycube_compute(&surface, &options, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
    CHECK(map == nullptr);
  }
  options.area_weight = 1;
  std::vector<double> wild = cube;
  wild[4] = std::numeric_limits<double>::quiet_NaN();
  const obc_surface not_finite = {wild.data(), 8, triangles.data(), 12};
  CHECK(obc_polycube_compute(&not_finite, &options, nullptr, &map, &error) == OBC_INVALID_ARGUMENT);
  CHECK(map == nullptr);
  options.corners = 7;
  CHECK(obc_polycube_compute(&surface, &options, nullptr, &map, &error) == OBC_NO_VALID_RESULT);
}

TEST_CASE("Each allocation of the dissertation's method that fails ends in out of memory, and each report may cancel" *
          doctest::test_suite("long")) {
  const obc_surface surface = {cube.data(), 8, triangles.data(), 12};
  const test::Call call = [&](const obc_host& host) {
    obc_polycube* map = nullptr;
    obc_polycube_options options;
    obc_polycube_options_init(&options, sizeof options);
    options.construction = OBC_POLYCUBE_DISSERTATION;
    options.corners = 8;
    const obc_status status = obc_polycube_compute(&surface, &options, &host, &map, nullptr);
    obc_polycube_destroy(map);
    return status;
  };
  const test::Outcome memory = test::fail_each_allocation(call, 200);
  CHECK(memory.problem == "");
  CHECK(memory.runs > 100);
  const test::Outcome cancelled = test::cancel_everywhere(call);
  CHECK(cancelled.problem == "");
}
