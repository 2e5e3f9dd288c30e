// Features through the C functions of hexmesh: what options request, what is captured, and what is missing and why.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <set>
#include <utility>
#include <vector>

#include "failing_allocations.h"
#include "orbicube/hexmesh.h"

namespace {

struct Octahedron {
  const std::vector<double> positions = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  const std::vector<std::uint32_t> triangles = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  const obc_surface surface = {positions.data(), 6, triangles.data(), 8};
};

obc_hexmesh_options options_for(std::int32_t features, std::int32_t method) {
  obc_hexmesh_options options;
  REQUIRE(obc_hexmesh_options_init(&options, sizeof options) == OBC_OK);
  options.cells = 200;
  options.max_hausdorff_percent = 0;
  options.features = features;
  options.method = method;
  return options;
}

std::vector<double> positions_of(const obc_hexmesh* hexes) {
  std::vector<double> positions(3 * obc_hexmesh_vertex_count(hexes));
  CHECK(obc_hexmesh_copy(hexes, positions.data(), nullptr, nullptr, nullptr, nullptr) == OBC_OK);
  return positions;
}

}  // namespace

TEST_CASE("The edges of an octahedron are embedded, and each quad has the patch of its face") {
  const Octahedron shape;
  obc_hexmesh_options options = options_for(OBC_HEXMESH_FEATURES_ANGLES, OBC_HEXMESH_METHOD_GRID);
  options.cells = 900;
  obc_hexmesh_report report{};
  report.struct_size = sizeof report;
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  REQUIRE(obc_hexmesh_compute(&shape.surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
  CHECK(report.embedded == 1);
  CHECK(report.feature_curves == 12);
  CHECK(report.feature_corners == 6);
  CHECK(report.missing_features == 0);
  CHECK(obc_hexmesh_missing_count(hexes) == 0);
  CHECK(report.captured == doctest::Approx(1));
  CHECK(report.scaled_jacobian_bound ==
        doctest::Approx(0.5 / std::sqrt(3.0)));  // as in tests/hexmesh/features_test.cpp
  CHECK(report.min_scaled_jacobian > report.scaled_jacobian_bound - 0.05);
  const std::vector<double> positions = positions_of(hexes);
  std::vector<std::uint32_t> quads(4 * obc_hexmesh_quad_count(hexes)), patches(obc_hexmesh_quad_count(hexes));
  REQUIRE(obc_hexmesh_copy(hexes, nullptr, nullptr, quads.data(), patches.data(), &error) == OBC_OK);
  std::set<std::pair<std::uint32_t, int>> octants;  // of each patch
  for (std::size_t q = 0; q < patches.size(); ++q) {
    double center[3] = {0, 0, 0};
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        center[axis] += positions[3 * quads[4 * q + k] + axis];
    }
    octants.insert({patches[q], (center[0] > 0 ? 1 : 0) + (center[1] > 0 ? 2 : 0) + (center[2] > 0 ? 4 : 0)});
  }
  CHECK(octants.size() == 8);
  obc_hexmesh_missing missing{};
  missing.struct_size = sizeof missing;
  CHECK(obc_hexmesh_get_missing(hexes, 0, &missing, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_hexmesh_get_missing(nullptr, 0, &missing, &error) == OBC_INVALID_ARGUMENT);

  // All edges as tags are the same graph.
  const std::vector<std::uint32_t> edges = {0, 2, 2, 1, 1, 3, 3, 0, 0, 4, 1, 4, 2, 4, 3, 4, 0, 5, 1, 5, 2, 5, 3, 5};
  options.features = OBC_HEXMESH_FEATURES_TAGS;
  options.tagged_edges = edges.data();
  options.tagged_edge_count = edges.size() / 2;
  obc_hexmesh* tagged = nullptr;
  REQUIRE(obc_hexmesh_compute(&shape.surface, &options, nullptr, nullptr, &tagged, &error) == OBC_OK);
  CHECK(positions_of(tagged) == positions);
  obc_hexmesh_destroy(tagged);
  obc_hexmesh_destroy(hexes);
}

TEST_CASE("What a polycube does not follow is missing, with its ends and the reason") {
  const Octahedron shape;
  const obc_hexmesh_options options = options_for(OBC_HEXMESH_FEATURES_ANGLES, OBC_HEXMESH_METHOD_POLYCUBE);
  obc_hexmesh_report report{};
  report.struct_size = sizeof report;
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  REQUIRE(obc_hexmesh_compute(&shape.surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
  CHECK(report.embedded == 0);
  CHECK(report.captured < 0.9);
  REQUIRE(report.missing_features > 0);
  REQUIRE(obc_hexmesh_missing_count(hexes) == report.missing_features);
  std::size_t curves = 0;
  for (std::size_t i = 0; i < report.missing_features; ++i) {
    obc_hexmesh_missing missing{};
    missing.struct_size = sizeof missing;
    REQUIRE(obc_hexmesh_get_missing(hexes, i, &missing, &error) == OBC_OK);
    CHECK(std::strlen(obc_hexmesh_missing_reason(hexes, i)) > 0);
    CHECK(std::abs(missing.first[0]) + std::abs(missing.first[1]) + std::abs(missing.first[2]) == doctest::Approx(1));
    CHECK(missing.captured < 0.95);
    CHECK(std::equal(missing.first, missing.first + 3, missing.last) == (missing.corner != 0));
    curves += missing.corner != 0 ? 0 : 1;
  }
  CHECK(curves > 0);
  CHECK(obc_hexmesh_missing_reason(hexes, report.missing_features) == nullptr);
  CHECK(obc_hexmesh_missing_reason(nullptr, 0) == nullptr);
  obc_hexmesh_destroy(hexes);
  CHECK(obc_hexmesh_missing_count(nullptr) == 0);
}

TEST_CASE("Without features their figures are 0, and wrong features are refused") {
  const Octahedron shape;
  obc_hexmesh_options options = options_for(OBC_HEXMESH_FEATURES_OFF, OBC_HEXMESH_METHOD_GRID);
  obc_hexmesh_report report{};
  report.struct_size = sizeof report;
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  REQUIRE(obc_hexmesh_compute(&shape.surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
  CHECK(report.feature_curves + report.feature_corners + report.missing_features == 0);
  CHECK(report.captured + report.scaled_jacobian_bound == 0);
  obc_hexmesh_destroy(hexes);
  hexes = nullptr;
  const auto refused = [&] {
    return obc_hexmesh_compute(&shape.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT &&
           hexes == nullptr;
  };
  for (const std::int32_t features : {-1, 5}) {
    options.features = features;
    CHECK(refused());
  }
  options.features = OBC_HEXMESH_FEATURES_TAGS;
  options.tagged_edge_count = 1;
  CHECK(refused());
  const std::uint32_t beyond[2] = {0, 6};
  options.tagged_edges = beyond;
  CHECK(refused());
  options.tagged_edge_count = 0;
  options.tagged_vertex_count = 1;
  CHECK(refused());
  options.tagged_vertices = beyond + 1;
  CHECK(refused());
}

TEST_CASE("Reports cancel an embedding of features at any moment") {
  const Octahedron shape;
  obc_hexmesh_options options = options_for(OBC_HEXMESH_FEATURES_ANGLES, OBC_HEXMESH_METHOD_GRID);
  options.cells = 30;
  options.rounds = 2;
  const auto outcome = orbicube::test::cancel_everywhere(
      [&](const obc_host& host) {
        obc_hexmesh* hexes = nullptr;
        const obc_status status = obc_hexmesh_compute(&shape.surface, &options, &host, nullptr, &hexes, nullptr);
        CHECK((hexes != nullptr) == (status == OBC_OK));
        obc_hexmesh_destroy(hexes);
        return status;
      },
      8);
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 8);
}
