// The C functions of correspondence: what they promise about arguments, memory and cancelling.
#include "orbicube/correspondence.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "failing_allocations.h"

using namespace orbicube;

namespace {

struct Shape {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;

  obc_surface surface() const {
    return {positions.data(), positions.size() / 3, triangles.data(), triangles.size() / 3};
  }
};

const Shape octahedron = {{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
                          {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}};

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
    const double not_finite[] = {0, std::nan("")};
    CHECK(obc_correspondence_blend(both, not_finite, 2, blended.data(), &error) == OBC_INVALID_ARGUMENT);
    CHECK(obc_correspondence_blend(both, half, 1, blended.data(), &error) == OBC_INVALID_ARGUMENT);
    CHECK(obc_correspondence_blend(both, nullptr, 2, blended.data(), &error) == OBC_INVALID_ARGUMENT);
    CHECK(obc_correspondence_copy(both, 2, first.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
    obc_correspondence_destroy(both);
  }
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
    for (const std::int32_t value : {-1, 3}) {
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
