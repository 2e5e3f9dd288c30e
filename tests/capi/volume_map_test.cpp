// The C functions of volume_map: what they promise about arguments, memory, cancelling and threads. What the maps are
// worth is tested in tests/volume_map/.
#include "orbicube/volume_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "boxes.h"
#include "promises.h"

using namespace orbicube;
using test::Box;

namespace {

obc_volume_map_untangle_problem problem_of(const Box& box) {
  obc_volume_map_untangle_problem t;
  REQUIRE(obc_volume_map_untangle_problem_init(&t, sizeof t) == OBC_OK);
  t.positions = box.start.data();
  t.vertex_count = box.start.size() / 3;
  t.tetrahedra = box.tetrahedra.data();
  t.tetrahedron_count = box.tetrahedra.size() / 4;
  t.rest = box.rest.data();
  t.fixed = box.fixed.data();
  return t;
}
}  // namespace

TEST_CASE("An inverted box is untangled, in place too, and the report says how") {
  Box box;
  obc_volume_map_untangle_problem problem = problem_of(box);
  std::vector<double> result(box.start.size());
  obc_volume_map_untangle_report report;
  REQUIRE(obc_volume_map_untangle_report_init(&report, sizeof report) == OBC_OK);
  obc_error error;
  REQUIRE(obc_volume_map_untangle(&problem, nullptr, nullptr, result.data(), &report, &error) == OBC_OK);
  CHECK(report.inverted_before > 0);
  CHECK(report.inverted == 0);
  CHECK(report.first_inverted == UINT32_MAX);
  CHECK(report.steps > 0);
  CHECK(report.min_determinant > 0);
  CHECK(report.max_determinant >= report.min_determinant);
  for (std::size_t t = 0; t < box.tetrahedra.size(); t += 4) {
    const auto* const v = &box.tetrahedra[t];
    const double* const x = result.data();
    CHECK(obc_mesh_orientation_3d(x + 3 * v[0], x + 3 * v[1], x + 3 * v[2], x + 3 * v[3]) == 1);
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (box.fixed[i] != 0)
      CHECK(result[i] == box.start[i]);
    else
      CHECK(std::abs(result[i] - box.rest[i]) < 0.01);  // where nothing is distorted, but for the end of the polishing
  }
  REQUIRE(obc_volume_map_untangle(&problem, nullptr, nullptr, box.start.data(), nullptr, &error) == OBC_OK);
  CHECK(box.start == result);
}

TEST_CASE("Ties and options reach the method") {
  const Box box;
  obc_volume_map_untangle_problem problem = problem_of(box);
  // The two vertices inside share y and z.
  std::vector<std::uint32_t> ties(box.start.size(), UINT32_MAX);
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < ties.size(); i += 3) {
    if (box.fixed[i] == 0) inside.push_back(i);
  }
  REQUIRE(inside.size() == 2);
  for (const std::size_t i : inside) {
    ties[i + 1] = 7;
    ties[i + 2] = 9;
  }
  problem.ties = ties.data();
  std::vector<double> result(box.start.size());
  REQUIRE(obc_volume_map_untangle(&problem, nullptr, nullptr, result.data(), nullptr, nullptr) == OBC_OK);
  CHECK(result[inside[0] + 1] == result[inside[1] + 1]);
  CHECK(result[inside[0] + 2] == result[inside[1] + 2]);

  obc_volume_map_untangle_options options;
  REQUIRE(obc_volume_map_untangle_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.steps == 500);
  CHECK(options.polish_steps == 20);
  CHECK(options.volume_weight == 1);
  options.steps = 0;
  obc_volume_map_untangle_report report;
  REQUIRE(obc_volume_map_untangle_report_init(&report, sizeof report) == OBC_OK);
  obc_error error;
  CHECK(obc_volume_map_untangle(&problem, &options, nullptr, result.data(), &report, &error) == OBC_NO_VALID_RESULT);
  CHECK(report.inverted == report.inverted_before);
  CHECK(std::string(error.kind) == "no-valid-result");
  CHECK(std::string(error.message).find(std::to_string(report.inverted)) != std::string::npos);
  CHECK(std::equal(result.begin(), result.end(), box.start.begin()));
}

TEST_CASE("Wrong arguments are refused, not followed") {
  const Box box;
  const obc_volume_map_untangle_problem problem = problem_of(box);
  std::vector<double> result(box.start.size(), 99);
  obc_error error;
  CHECK(obc_volume_map_untangle(nullptr, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_volume_map_untangle(&problem, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_volume_map_untangle_problem wrong = problem;
  wrong.positions = nullptr;
  CHECK(obc_volume_map_untangle(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  wrong = problem;
  wrong.vertex_count = 5;
  CHECK(obc_volume_map_untangle(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_MALFORMED_FILE);
  CHECK(std::string(error.kind) == "index-range");
  wrong = problem;
  wrong.vertex_count = static_cast<std::size_t>(-1);
  CHECK(obc_volume_map_untangle(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  const std::vector<std::uint32_t> ties(box.start.size(), static_cast<std::uint32_t>(box.start.size()));
  wrong = problem;
  wrong.ties = ties.data();
  CHECK(obc_volume_map_untangle(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_volume_map_untangle_options options;
  REQUIRE(obc_volume_map_untangle_options_init(&options, sizeof options) == OBC_OK);
  options.volume_weight = std::numeric_limits<double>::quiet_NaN();
  CHECK(obc_volume_map_untangle(&problem, &options, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_volume_map_untangle_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  CHECK(std::count(result.begin(), result.end(), 99) == static_cast<std::ptrdiff_t>(result.size()));
}

TEST_CASE("Each allocation that fails, and each report that cancels, ends the untangling") {
  const Box box;
  const obc_volume_map_untangle_problem problem = problem_of(box);
  std::vector<double> result(box.start.size());
  const test::Call call = [&](const obc_host& host) {
    return obc_volume_map_untangle(&problem, nullptr, &host, result.data(), nullptr, nullptr);
  };
  test::check_failing_allocations(call);
  test::check_cancelling(call);
}

TEST_CASE("A box of tetrahedra is mapped to a polycube, every tetrahedron positive on both sides") {
  const Box box;
  obc_volume_map_solid* solid = nullptr;
  obc_error error;
  REQUIRE(obc_volume_map_solid_compute(box.rest.data(), box.rest.size() / 3, box.tetrahedra.data(),
                                       box.tetrahedra.size() / 4, nullptr, nullptr, &solid, &error) == OBC_OK);
  std::vector<double> source(3 * obc_volume_map_solid_vertex_count(solid)), image(source.size());
  std::vector<std::uint32_t> cells(4 * obc_volume_map_solid_tetrahedron_count(solid));
  REQUIRE(obc_volume_map_solid_copy(solid, source.data(), image.data(), cells.data(), &error) == OBC_OK);
  obc_volume_map_solid_destroy(solid);
  CHECK(cells.size() >= box.tetrahedra.size());
  for (std::size_t t = 0; t < cells.size(); t += 4) {
    for (const double* x : {source.data(), image.data()}) {
      CHECK(obc_mesh_orientation_3d(x + 3 * cells[t], x + 3 * cells[t + 1], x + 3 * cells[t + 2],
                                    x + 3 * cells[t + 3]) == 1);
    }
  }
}

TEST_CASE("Solids of two pieces are mapped to polycubes side by side") {
  Box box;
  const std::size_t vertices = box.rest.size() / 3, tetrahedra = box.tetrahedra.size();
  for (std::size_t i = 0; i < 3 * vertices; ++i)
    box.rest.push_back(box.rest[i] + (i % 3 == 1 ? 5 : 0));
  for (std::size_t i = 0; i < tetrahedra; ++i)
    box.tetrahedra.push_back(static_cast<std::uint32_t>(vertices) + box.tetrahedra[i]);
  obc_volume_map_solid* solid = nullptr;
  obc_error error;
  REQUIRE(obc_volume_map_solid_compute(box.rest.data(), 2 * vertices, box.tetrahedra.data(), tetrahedra / 2, nullptr,
                                       nullptr, &solid, &error) == OBC_OK);
  std::vector<double> source(3 * obc_volume_map_solid_vertex_count(solid)), image(source.size());
  std::vector<std::uint32_t> cells(4 * obc_volume_map_solid_tetrahedron_count(solid));
  REQUIRE(obc_volume_map_solid_copy(solid, source.data(), image.data(), cells.data(), &error) == OBC_OK);
  obc_volume_map_solid_destroy(solid);
  // Of each piece, how far along x it reaches on the polycube.
  double first_high = -1e300, second_low = 1e300;
  for (std::size_t t = 0; t < cells.size(); t += 4) {
    CHECK(obc_mesh_orientation_3d(&image[3 * cells[t]], &image[3 * cells[t + 1]], &image[3 * cells[t + 2]],
                                  &image[3 * cells[t + 3]]) == 1);
    for (std::size_t k = 0; k < 4; ++k) {
      const bool second = source[3 * cells[t + k] + 1] > 3;
      CHECK(second == (source[3 * cells[t] + 1] > 3));
      const double x = image[3 * cells[t + k]];
      if (second)
        second_low = std::min(second_low, x);
      else
        first_high = std::max(first_high, x);
    }
  }
  CHECK(first_high < second_low);
}

TEST_CASE("Wrong arguments of solids are refused") {
  const Box solid_box;
  obc_volume_map_solid* solid = nullptr;
  obc_error error;
  CHECK(obc_volume_map_solid_compute(nullptr, 4, solid_box.tetrahedra.data(), 1, nullptr, nullptr, &solid, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_volume_map_solid_compute(solid_box.rest.data(), 1, solid_box.tetrahedra.data(), 1, nullptr, nullptr, &solid,
                                     &error) != OBC_OK);
  const std::vector<std::uint32_t> inverted = {0, 1, 3, 9};
  for (const double wrong : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<double> positions(solid_box.rest.begin(), solid_box.rest.end());
    positions[4] = wrong;
    CHECK(obc_volume_map_solid_compute(positions.data(), positions.size() / 3, solid_box.tetrahedra.data(),
                                       solid_box.tetrahedra.size() / 4, nullptr, nullptr, &solid,
                                       &error) == OBC_INVALID_ARGUMENT);
    CHECK(std::string(error.message).find("vertex 1 is not finite") != std::string::npos);
  }
  CHECK(obc_volume_map_solid_compute(solid_box.rest.data(), solid_box.rest.size() / 3, inverted.data(), 1, nullptr,
                                     nullptr, &solid, &error) != OBC_OK);
  CHECK(solid == nullptr);
  CHECK(obc_volume_map_solid_copy(nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_volume_map_solid_vertex_count(nullptr) + obc_volume_map_solid_tetrahedron_count(nullptr) == 0);
  obc_volume_map_solid_destroy(nullptr);
}

TEST_CASE("Each allocation that fails while a solid is mapped ends in out of memory") {
  const Box box;
  test::check_failing_allocations(test::destroying(obc_volume_map_solid_destroy,
                                                   [&](const obc_host* host, obc_volume_map_solid** out) {
                                                     return obc_volume_map_solid_compute(
                                                         box.rest.data(), box.rest.size() / 3, box.tetrahedra.data(),
                                                         box.tetrahedra.size() / 4, nullptr, host, out, nullptr);
                                                   }),
                                  50);
}
