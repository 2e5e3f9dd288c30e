// The C functions of correspondence: what they promise about arguments, memory and cancelling.
#include "orbicube/correspondence.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "failing_allocations.h"
#include "shapes.h"

using namespace orbicube;
using test::octahedron, test::Shape;

namespace {

Shape stretched() {
  Shape result = octahedron;
  for (std::size_t i = 0; i < result.positions.size(); i += 3)
    result.positions[i] *= 2;
  return result;
}

const Shape longer = stretched();

obc_correspondence_options defaults() {
  obc_correspondence_options options;
  REQUIRE(obc_correspondence_options_init(&options, sizeof options) == OBC_OK);
  return options;
}

obc_status create(const std::vector<obc_surface>& shapes, const obc_correspondence_options& options) {
  obc_correspondence* made = nullptr;
  obc_error error;
  const obc_status status = obc_correspondence_create(shapes.data(), shapes.size(), &options, nullptr, &made, &error);
  CHECK((made != nullptr) == (status == OBC_OK));
  obc_correspondence_destroy(made);
  return status;
}

}  // namespace

TEST_CASE("Two shapes get one triangulation, which blends from one to the other") {
  const std::vector<obc_surface> shapes{octahedron.surface(), longer.surface()};
  for (const std::int32_t via : {OBC_CORRESPONDENCE_SPHERE, OBC_CORRESPONDENCE_POLYCUBE}) {
    obc_correspondence_options options = defaults();
    options.via = via;
    options.cells = 50;
    obc_correspondence* both = nullptr;
    obc_error error;
    REQUIRE_MESSAGE(obc_correspondence_create(shapes.data(), 2, &options, nullptr, &both, &error) == OBC_OK,
                    error.message);
    CHECK(obc_correspondence_shape_count(both) == 2);
    const std::size_t vertices = obc_correspondence_vertex_count(both);
    CHECK(obc_correspondence_triangle_count(both) == 2 * vertices - 4);
    std::vector<double> first(3 * vertices), second(first), blended(first);
    std::vector<std::uint32_t> triangles(3 * obc_correspondence_triangle_count(both));
    REQUIRE(obc_correspondence_copy(both, 0, first.data(), triangles.data(), &error) == OBC_OK);
    REQUIRE(obc_correspondence_copy(both, 1, second.data(), nullptr, &error) == OBC_OK);
    const double all_of_second[] = {0, 1}, half[] = {0.5, 0.5};
    REQUIRE(obc_correspondence_blend(both, all_of_second, 2, blended.data(), &error) == OBC_OK);
    CHECK(blended == second);
    REQUIRE(obc_correspondence_blend(both, half, 2, blended.data(), &error) == OBC_OK);
    CHECK(blended[0] == 0.5 * first[0] + 0.5 * second[0]);
    std::vector<double> domain(3 * vertices);
    REQUIRE(obc_correspondence_copy_domain(both, domain.data(), &error) == OBC_OK);
    const std::size_t quads = obc_correspondence_quad_count(both);
    CHECK(2 * quads == (via == OBC_CORRESPONDENCE_POLYCUBE ? obc_correspondence_triangle_count(both) : 0));
    std::vector<std::uint32_t> corners(4 * quads + 4);
    CHECK(obc_correspondence_copy_quads(both, corners.data(), &error) == OBC_OK);
    for (std::size_t q = 0; q < quads; ++q)
      CHECK((corners[4 * q] == triangles[6 * q] && corners[4 * q + 3] == triangles[6 * q + 5]));
    const double not_finite[] = {0, std::nan("")};
    CHECK(obc_correspondence_blend(both, not_finite, 2, blended.data(), &error) == OBC_INVALID_ARGUMENT);
    CHECK(obc_correspondence_blend(both, half, 1, blended.data(), &error) == OBC_INVALID_ARGUMENT);
    CHECK(obc_correspondence_blend(both, nullptr, 2, blended.data(), &error) == OBC_INVALID_ARGUMENT);
    CHECK(obc_correspondence_copy(both, 2, first.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
    obc_correspondence_destroy(both);
  }
}

TEST_CASE("Points are mapped from one shape to the other and back") {
  const std::vector<obc_surface> shapes{octahedron.surface(), longer.surface()};
  for (const std::int32_t via : {OBC_CORRESPONDENCE_SPHERE, OBC_CORRESPONDENCE_POLYCUBE}) {
    obc_correspondence_options options = defaults();
    options.via = via;
    options.cells = 50;
    obc_correspondence* both = nullptr;
    REQUIRE(obc_correspondence_create(shapes.data(), 2, &options, nullptr, &both, nullptr) == OBC_OK);
    REQUIRE(obc_correspondence_surface_vertex_count(both, 0) == 6);
    CHECK(obc_correspondence_surface_vertex_count(both, 2) == 0);
    CHECK(obc_correspondence_surface_vertex_count(nullptr, 0) == 0);
    std::uint32_t triangles[6];
    double weights[18];
    REQUIRE(obc_correspondence_map_vertices(both, 0, 1, nullptr, triangles, weights, nullptr) == OBC_OK);
    REQUIRE(obc_correspondence_map(both, 1, 0, triangles, weights, 6, nullptr, triangles, weights, nullptr) == OBC_OK);
    for (std::size_t v = 0; v < 6; ++v) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double x = 0;
        for (std::size_t k = 0; k < 3; ++k)
          x += weights[3 * v + k] * octahedron.positions[3 * octahedron.triangles[3 * triangles[v] + k] + axis];
        CHECK(std::abs(x - octahedron.positions[3 * v + axis]) < 1e-9);
      }
    }
    CHECK(obc_correspondence_map(both, 0, 1, nullptr, nullptr, 0, nullptr, nullptr, nullptr, nullptr) == OBC_OK);
    CHECK(obc_correspondence_map(both, 0, 2, triangles, weights, 6, nullptr, triangles, weights, nullptr) ==
          OBC_INVALID_ARGUMENT);
    CHECK(obc_correspondence_map(both, 0, 1, nullptr, weights, 6, nullptr, triangles, weights, nullptr) ==
          OBC_INVALID_ARGUMENT);
    weights[4] = std::nan("");
    CHECK(obc_correspondence_map(both, 0, 1, triangles, weights, 6, nullptr, triangles, weights, nullptr) ==
          OBC_INVALID_ARGUMENT);
    CHECK(obc_correspondence_map_vertices(both, 0, 1, nullptr, nullptr, weights, nullptr) == OBC_INVALID_ARGUMENT);
    CHECK(obc_correspondence_map_vertices(nullptr, 0, 1, nullptr, triangles, weights, nullptr) == OBC_INVALID_ARGUMENT);
    const auto call = [&](const obc_host& host) {
      return obc_correspondence_map_vertices(both, 0, 1, &host, triangles, weights, nullptr);
    };
    CHECK(test::fail_each_allocation(call, 300).problem == "");
    CHECK(test::cancel_everywhere(call).problem == "");
    obc_correspondence_destroy(both);
  }
}

TEST_CASE("Landmarks and grids of the sphere are options") {
  const std::vector<obc_surface> shapes{octahedron.surface(), longer.surface()};
  const double landmarks[] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 0, 1, 0, 0, 0, 1};
  obc_correspondence_options options = defaults();
  options.grid = OBC_CORRESPONDENCE_GRID_CUBE;
  options.resolution = 4;
  options.landmark_count = 3;
  options.landmarks = landmarks;
  CHECK(create(shapes, options) == OBC_OK);
  double far[18];
  std::copy(std::begin(landmarks), std::end(landmarks), far);
  far[4] = -1e300;  // the square of its distance overflows
  options.landmarks = far;
  CHECK(create(shapes, options) == OBC_INVALID_ARGUMENT);
  options.landmarks = nullptr;
  CHECK(create(shapes, options) == OBC_INVALID_ARGUMENT);
  options.landmark_count = 0;
  options.resolution = 0;
  CHECK(create(shapes, options) == OBC_INVALID_ARGUMENT);
  options.resolution = 4;
  options.via = OBC_CORRESPONDENCE_POLYCUBE;
  CHECK(create(shapes, options) == OBC_INVALID_ARGUMENT);
}

TEST_CASE("What is missing, out of range or not finite is refused") {
  const std::vector<obc_surface> shapes{octahedron.surface(), longer.surface()};
  CHECK(obc_correspondence_create(shapes.data(), 2, nullptr, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  obc_correspondence* made = nullptr;
  CHECK(obc_correspondence_create(nullptr, 2, nullptr, nullptr, &made, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_correspondence_create(shapes.data(), SIZE_MAX, nullptr, nullptr, &made, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(create({}, defaults()) == OBC_INVALID_ARGUMENT);
  CHECK(create({octahedron.surface()}, defaults()) == OBC_INVALID_ARGUMENT);
  for (std::int32_t obc_correspondence_options::*choice :
       {&obc_correspondence_options::via, &obc_correspondence_options::align, &obc_correspondence_options::grid,
        &obc_correspondence_options::placement}) {
    for (const std::int32_t value : {-1, 6}) {
      obc_correspondence_options options = defaults();
      options.*choice = value;
      CHECK(create(shapes, options) == OBC_INVALID_ARGUMENT);
    }
  }
  obc_correspondence_options options = defaults();
  options.tolerance = std::nan("");
  CHECK(create(shapes, options) == OBC_INVALID_ARGUMENT);
  Shape bad = octahedron;
  bad.positions[4] = std::numeric_limits<double>::infinity();
  CHECK(create({octahedron.surface(), bad.surface()}, defaults()) == OBC_INVALID_ARGUMENT);
  bad = octahedron;
  bad.triangles[4] = 6;
  CHECK(create({octahedron.surface(), bad.surface()}, defaults()) == OBC_INVALID_ARGUMENT);
  bad = octahedron;
  bad.triangles.resize(21);
  CHECK(create({octahedron.surface(), bad.surface()}, defaults()) == OBC_NOT_CLOSED);
  obc_correspondence_destroy(nullptr);
  CHECK(obc_correspondence_shape_count(nullptr) == 0);
  CHECK(obc_correspondence_vertex_count(nullptr) == 0);
  CHECK(obc_correspondence_triangle_count(nullptr) == 0);
  CHECK(obc_correspondence_copy(nullptr, 0, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_correspondence_version() == 100);
}

TEST_CASE("Every allocation may fail and every report may cancel") {
  const obc_surface shapes[] = {octahedron.surface(), longer.surface()};
  // The rotation is tested with harmonics; here it would repeat seconds of work thousands of times.
  obc_correspondence_options options = defaults();
  options.align = OBC_CORRESPONDENCE_ALIGN_NONE;
  const auto call = [&](const obc_host& host) {
    obc_correspondence* made = nullptr;
    const obc_status status = obc_correspondence_create(shapes, 2, &options, &host, &made, nullptr);
    obc_correspondence_destroy(made);
    return status;
  };
  CHECK(test::fail_each_allocation(call, 300).problem == "");
  CHECK(test::cancel_everywhere(call).problem == "");
}
