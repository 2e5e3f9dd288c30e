// The C functions of volume_map for parameterizations along frames and for maps as functions: arguments, memory,
// cancelling. What the maps are worth is tested in tests/volume_map/.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "boxes.h"
#include "orbicube/volume_map.h"
#include "promises.h"

using namespace orbicube;
using test::Box;

namespace {

std::vector<double> axes_of(const Box& box) {
  std::vector<double> frames(box.tetrahedra.size(), 0);
  for (std::size_t t = 0; t < frames.size(); t += 4)
    frames[t] = 1;
  return frames;
}

}  // namespace

TEST_CASE("A box along its axes has the coordinates of space, in cells") {
  const Box box;
  const std::vector<double> frames = axes_of(box);
  const std::size_t cells = box.tetrahedra.size() / 4;
  obc_volume_map_frame_map_options options;
  REQUIRE(obc_volume_map_frame_map_options_init(&options, sizeof options) == OBC_OK);
  options.cell_length = 0.5;
  obc_volume_map_frame_map_report report;
  REQUIRE(obc_volume_map_frame_map_report_init(&report, sizeof report) == OBC_OK);
  obc_volume_map_frame_map* map = nullptr;
  obc_error error;
  REQUIRE(obc_volume_map_frame_map_compute(box.rest.data(), box.rest.size() / 3, box.tetrahedra.data(), cells,
                                           frames.data(), &options, nullptr, &report, &map, &error) == OBC_OK);
  CHECK(report.inverted == 0);
  CHECK(report.patches == 6);
  CHECK(report.cell_length == 0.5);
  CHECK(obc_volume_map_frame_map_tetrahedron_count(map) == cells);
  CHECK(obc_volume_map_frame_map_singular_edge_count(map) == 0);
  std::vector<double> parameters(12 * cells);
  REQUIRE(obc_volume_map_frame_map_copy(map, parameters.data(), nullptr, nullptr, nullptr, nullptr, nullptr, &error) ==
          OBC_OK);
  for (std::size_t i = 3; i < parameters.size(); ++i) {
    const double moved = 2 * (box.rest[3 * box.tetrahedra[i / 3] + i % 3] - box.rest[3 * box.tetrahedra[0] + i % 3]);
    CHECK(std::abs(parameters[i] - parameters[i % 3] - moved) < 1e-6);
  }
  obc_volume_map_frame_map_destroy(map);
}

TEST_CASE("Points are located in a box, and interpolated") {
  const Box box;
  obc_volume_map_locator* locator = nullptr;
  obc_error error;
  const std::size_t vertices = box.rest.size() / 3;
  REQUIRE(obc_volume_map_locator_create(box.rest.data(), vertices, box.tetrahedra.data(), box.tetrahedra.size() / 4,
                                        nullptr, &locator, &error) == OBC_OK);
  std::vector<double> points(box.rest);
  points.insert(points.end(), {1e6, 0, 0});
  std::vector<std::uint32_t> tetrahedra(vertices + 1);
  std::vector<double> weights(4 * vertices + 4), images(3 * vertices + 3);
  REQUIRE(obc_volume_map_locator_locate(locator, points.data(), vertices + 1, nullptr, tetrahedra.data(),
                                        weights.data(), &error) == OBC_OK);
  CHECK(tetrahedra.back() == UINT32_MAX);
  const auto interpolate = [&](const double* values, std::size_t components) {
    return obc_volume_map_locator_interpolate(locator, tetrahedra.data(), weights.data(), vertices + 1, values,
                                              components, nullptr, images.data(), &error);
  };
  REQUIRE(interpolate(box.rest.data(), 3) == OBC_OK);
  for (std::size_t i = 0; i < 3 * vertices; ++i)
    CHECK(std::abs(images[i] - box.rest[i]) < 1e-12);
  CHECK_UNARY(std::isnan(images.back()));
  for (std::size_t i = 0; i < 4 * vertices; i += 4)
    CHECK(std::abs(weights[i] + weights[i + 1] + weights[i + 2] + weights[i + 3] - 1) < 1e-14);
  CHECK(interpolate(nullptr, 3) == OBC_INVALID_ARGUMENT);
  CHECK(interpolate(box.rest.data(), 0) == OBC_INVALID_ARGUMENT);
  CHECK(interpolate(box.rest.data(), SIZE_MAX / 4) == OBC_INVALID_ARGUMENT);
  tetrahedra[0] = 1'000'000;
  CHECK(interpolate(box.rest.data(), 3) == OBC_INVALID_ARGUMENT);
  points[0] = std::numeric_limits<double>::quiet_NaN();
  CHECK(obc_volume_map_locator_locate(locator, points.data(), 1, nullptr, tetrahedra.data(), weights.data(), &error) ==
        OBC_INVALID_ARGUMENT);
  obc_volume_map_locator_destroy(locator);
  obc_volume_map_locator_destroy(nullptr);
}

TEST_CASE("Wrong arguments of parameterizations are refused") {
  const Box box;
  std::vector<double> frames = axes_of(box);
  obc_volume_map_frame_map_options options;
  REQUIRE(obc_volume_map_frame_map_options_init(&options, sizeof options) == OBC_OK);
  obc_volume_map_frame_map* map = nullptr;
  obc_error error;
  const auto compute = [&] {
    return obc_volume_map_frame_map_compute(box.rest.data(), box.rest.size() / 3, box.tetrahedra.data(),
                                            box.tetrahedra.size() / 4, frames.data(), &options, nullptr, nullptr, &map,
                                            &error);
  };
  options.integer = 2;
  CHECK(compute() == OBC_INVALID_ARGUMENT);
  options.integer = 0;
  options.cell_length = -1;
  CHECK(compute() == OBC_INVALID_ARGUMENT);
  options.cell_length = 1e-310;  // the parameters overflow
  CHECK(compute() == OBC_NO_VALID_RESULT);
  options.cell_length = 0;
  options.feature_angle = 40;
  CHECK(compute() == OBC_INVALID_ARGUMENT);
  options.feature_angle = 0;
  frames[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(compute() == OBC_INVALID_ARGUMENT);
  CHECK(map == nullptr);
  CHECK(obc_volume_map_frame_map_copy(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
}

TEST_CASE("Each allocation that fails, and each report that cancels, ends a parameterization and a locator") {
  const Box box;
  const std::vector<double> frames = axes_of(box);
  const test::Call call = [&](const obc_host& host) {
    obc_volume_map_frame_map* map = nullptr;
    const obc_status status = obc_volume_map_frame_map_compute(box.rest.data(), box.rest.size() / 3,
                                                               box.tetrahedra.data(), box.tetrahedra.size() / 4,
                                                               frames.data(), nullptr, &host, nullptr, &map, nullptr);
    obc_volume_map_frame_map_destroy(map);
    return status;
  };
  test::check_failing_allocations(call);
  test::check_cancelling(call);
  // With computed frames and integers.
  test::check_cancelling([&](const obc_host& host) {
    obc_volume_map_frame_map_options options;
    obc_volume_map_frame_map_options_init(&options, sizeof options);
    options.integer = 1;
    options.cell_length = 0.5;
    obc_volume_map_frame_map* map = nullptr;
    const obc_status status =
        obc_volume_map_frame_map_compute(box.rest.data(), box.rest.size() / 3, box.tetrahedra.data(),
                                         box.tetrahedra.size() / 4, nullptr, &options, &host, nullptr, &map, nullptr);
    obc_volume_map_frame_map_destroy(map);
    return status;
  });
  // A map and its inverse, and the image of each point.
  const std::size_t vertices = box.rest.size() / 3, cells = box.tetrahedra.size() / 4;
  std::vector<std::uint32_t> found(vertices);
  std::vector<double> weights(4 * vertices), images(box.rest);
  const test::Call map_points = [&](const obc_host& host) {
    std::copy(box.rest.begin(), box.rest.end(), images.begin());
    obc_status status = OBC_OK;
    for (int round = 0; round < 2 && status == OBC_OK; ++round) {
      obc_volume_map_locator* locator = nullptr;
      status = obc_volume_map_locator_create(images.data(), vertices, box.tetrahedra.data(), cells, &host, &locator,
                                             nullptr);
      if (status == OBC_OK)
        status = obc_volume_map_locator_locate(locator, box.rest.data(), vertices, &host, found.data(), weights.data(),
                                               nullptr);
      if (status == OBC_OK)
        status = obc_volume_map_locator_interpolate(locator, found.data(), weights.data(), vertices, box.rest.data(), 3,
                                                    &host, images.data(), nullptr);
      obc_volume_map_locator_destroy(locator);
    }
    return status;
  };
  test::check_failing_allocations(map_points);
  test::check_cancelling(map_points);
}
