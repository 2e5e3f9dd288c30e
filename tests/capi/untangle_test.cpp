// The C functions of untangle: what they promise about arguments, memory, cancelling and threads. What the meshes
// are worth is tested in tests/untangle/.
#include "orbicube/untangle.h"

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

obc_untangle_tetrahedra_problem problem_of(const Box& box) {
  obc_untangle_tetrahedra_problem t;
  REQUIRE(obc_untangle_tetrahedra_problem_init(&t, sizeof t) == OBC_OK);
  t.positions = box.start.data();
  t.vertex_count = box.start.size() / 3;
  t.tetrahedra = box.tetrahedra.data();
  t.tetrahedron_count = box.tetrahedra.size() / 4;
  t.rest = box.rest.data();
  t.fixed_coordinates = box.fixed.data();
  return t;
}

// A square of 4 by 4 squares, each cut in two; vertices inside are at one corner.
struct Square {
  std::vector<double> start, rest;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint8_t> fixed;

  Square() {
    for (std::uint32_t y = 0; y <= 4; ++y) {
      for (std::uint32_t x = 0; x <= 4; ++x) {
        const bool inside = x > 0 && y > 0 && x < 4 && y < 4;
        start.insert(start.end(), {inside ? 0.0 : x, inside ? 0.0 : y});
        rest.insert(rest.end(), {1.0 * x, 1.0 * y, 0.0});
        fixed.push_back(!inside);
        const std::uint32_t p = 5 * y + x;
        if (x < 4 && y < 4) triangles.insert(triangles.end(), {p, p + 1, p + 6, p, p + 6, p + 5});
      }
    }
  }

  obc_untangle_triangles_problem problem() const {
    obc_untangle_triangles_problem t;
    REQUIRE(obc_untangle_triangles_problem_init(&t, sizeof t) == OBC_OK);
    t.positions = start.data();
    t.vertex_count = fixed.size();
    t.triangles = triangles.data();
    t.triangle_count = triangles.size() / 3;
    t.rest = rest.data();
    return t;
  }
};

}  // namespace

TEST_CASE("An inverted box is untangled, in place too, and the report says how") {
  Box box;
  obc_untangle_tetrahedra_problem problem = problem_of(box);
  std::vector<double> result(box.start.size());
  obc_untangle_report report;
  REQUIRE(obc_untangle_report_init(&report, sizeof report) == OBC_OK);
  obc_error error;
  REQUIRE(obc_untangle_tetrahedra(&problem, nullptr, nullptr, result.data(), &report, &error) == OBC_OK);
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
  REQUIRE(obc_untangle_tetrahedra(&problem, nullptr, nullptr, box.start.data(), nullptr, &error) == OBC_OK);
  CHECK(box.start == result);
}

TEST_CASE("The boundary is fixed unless something else is fixed or it is free") {
  Box box;
  obc_untangle_tetrahedra_problem problem = problem_of(box);
  std::vector<double> result(box.start.size()), by_vertices(box.start.size()), free(box.start.size());
  problem.fixed_coordinates = nullptr;
  REQUIRE(obc_untangle_tetrahedra(&problem, nullptr, nullptr, result.data(), nullptr, nullptr) == OBC_OK);
  std::vector<std::uint8_t> fixed;
  for (std::size_t i = 0; i < box.fixed.size(); i += 3)
    fixed.push_back(box.fixed[i]);
  problem.fixed = fixed.data();
  REQUIRE(obc_untangle_tetrahedra(&problem, nullptr, nullptr, by_vertices.data(), nullptr, nullptr) == OBC_OK);
  CHECK(result == by_vertices);
  // A box of other proportions than its target shapes keeps them where nothing is fixed.
  problem.fixed = nullptr;
  for (std::size_t i = 0; i < box.start.size(); i += 3)
    box.start[i] = 1.5 * box.rest[i];
  obc_untangle_options options;
  REQUIRE(obc_untangle_options_init(&options, sizeof options) == OBC_OK);
  options.free_boundary = 1;
  options.max_polish_steps = 100;
  options.tolerance = 0;
  obc_untangle_report report;
  REQUIRE(obc_untangle_report_init(&report, sizeof report) == OBC_OK);
  REQUIRE(obc_untangle_tetrahedra(&problem, &options, nullptr, free.data(), &report, nullptr) == OBC_OK);
  CHECK(report.energy == doctest::Approx(5).epsilon(1e-4));  // directions by conjugate gradients to 1e-2
  CHECK(report.max_determinant == doctest::Approx(1).epsilon(0.02));
}

TEST_CASE("Ties and options reach the method") {
  const Box box;
  obc_untangle_tetrahedra_problem problem = problem_of(box);
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
  REQUIRE(obc_untangle_tetrahedra(&problem, nullptr, nullptr, result.data(), nullptr, nullptr) == OBC_OK);
  CHECK(result[inside[0] + 1] == result[inside[1] + 1]);
  CHECK(result[inside[0] + 2] == result[inside[1] + 2]);

  obc_untangle_options options;
  REQUIRE(obc_untangle_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.max_steps == 500);
  CHECK(options.max_polish_steps == 20);
  CHECK(options.free_boundary == 0);
  CHECK(options.tolerance == 1e-4);
  CHECK(options.volume_weight == 1);
  options.max_steps = 0;
  obc_untangle_report report;
  REQUIRE(obc_untangle_report_init(&report, sizeof report) == OBC_OK);
  obc_error error;
  CHECK(obc_untangle_tetrahedra(&problem, &options, nullptr, result.data(), &report, &error) == OBC_NO_VALID_RESULT);
  CHECK(report.inverted == report.inverted_before);
  CHECK(std::string(error.kind) == "no-valid-result");
  CHECK(std::string(error.message).find(std::to_string(report.inverted)) != std::string::npos);
  CHECK(std::equal(result.begin(), result.end(), box.start.begin()));
}

TEST_CASE("Wrong arguments are refused, not followed") {
  const Box box;
  const obc_untangle_tetrahedra_problem problem = problem_of(box);
  std::vector<double> result(box.start.size(), 99);
  obc_error error;
  CHECK(obc_untangle_tetrahedra(nullptr, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_untangle_tetrahedra(&problem, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_untangle_tetrahedra_problem wrong = problem;
  wrong.positions = nullptr;
  CHECK(obc_untangle_tetrahedra(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  wrong = problem;
  wrong.vertex_count = 5;
  CHECK(obc_untangle_tetrahedra(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_MALFORMED_FILE);
  CHECK(std::string(error.kind) == "index-range");
  wrong = problem;
  wrong.vertex_count = static_cast<std::size_t>(-1);
  CHECK(obc_untangle_tetrahedra(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  const std::vector<std::uint32_t> ties(box.start.size(), static_cast<std::uint32_t>(box.start.size()));
  wrong = problem;
  wrong.ties = ties.data();
  CHECK(obc_untangle_tetrahedra(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_untangle_options options;
  REQUIRE(obc_untangle_options_init(&options, sizeof options) == OBC_OK);
  options.volume_weight = std::numeric_limits<double>::quiet_NaN();
  CHECK(obc_untangle_tetrahedra(&problem, &options, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_untangle_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  CHECK(std::count(result.begin(), result.end(), 99) == static_cast<std::ptrdiff_t>(result.size()));
}

TEST_CASE("Each allocation that fails, and each report that cancels, ends the untangling") {
  const Box box;
  const obc_untangle_tetrahedra_problem problem = problem_of(box);
  std::vector<double> result(box.start.size());
  const test::Call call = [&](const obc_host& host) {
    return obc_untangle_tetrahedra(&problem, nullptr, &host, result.data(), nullptr, nullptr);
  };
  test::check_failing_allocations(call);
  test::check_cancelling(call);
}

TEST_CASE("A flat mesh is untangled, in place too, with its boundary fixed in each way") {
  Square square;
  obc_untangle_triangles_problem problem = square.problem();
  std::vector<double> result(square.start.size()), again(square.start.size());
  obc_untangle_report report;
  REQUIRE(obc_untangle_report_init(&report, sizeof report) == OBC_OK);
  REQUIRE(obc_untangle_triangles(&problem, nullptr, nullptr, result.data(), &report, nullptr) == OBC_OK);
  CHECK(report.inverted_before > 0);
  CHECK(report.inverted == 0);
  CHECK(report.steps > 0);
  CHECK(report.energy == doctest::Approx(4).epsilon(1e-4));
  for (std::size_t t = 0; t < square.triangles.size(); t += 3) {
    const auto* const v = &square.triangles[t];
    CHECK(obc_mesh_orientation_2d(&result[2 * v[0]], &result[2 * v[1]], &result[2 * v[2]]) == 1);
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (square.fixed[i / 2] != 0) CHECK(result[i] == square.start[i]);
    CHECK(std::abs(result[i] - square.rest[3 * (i / 2) + i % 2]) < 0.01);
  }
  problem.fixed = square.fixed.data();
  REQUIRE(obc_untangle_triangles(&problem, nullptr, nullptr, again.data(), nullptr, nullptr) == OBC_OK);
  CHECK(again == result);
  std::vector<std::uint8_t> coordinates;
  for (const std::uint8_t flag : square.fixed)
    coordinates.insert(coordinates.end(), 2, flag);
  problem.fixed = nullptr;
  problem.fixed_coordinates = coordinates.data();
  REQUIRE(obc_untangle_triangles(&problem, nullptr, nullptr, square.start.data(), nullptr, nullptr) == OBC_OK);
  CHECK(square.start == result);
}

TEST_CASE("Wrong flat meshes are refused, and what has no solution is returned with the error") {
  Square square;
  const obc_untangle_triangles_problem problem = square.problem();
  std::vector<double> result(square.start.size(), 99);
  obc_error error;
  CHECK(obc_untangle_triangles(nullptr, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_untangle_triangles(&problem, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_untangle_triangles_problem wrong = problem;
  wrong.positions = nullptr;
  CHECK(obc_untangle_triangles(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  wrong = problem;
  wrong.vertex_count = 5;
  CHECK(obc_untangle_triangles(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_MALFORMED_FILE);
  wrong.vertex_count = static_cast<std::size_t>(-1);
  CHECK(obc_untangle_triangles(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  wrong = problem;
  wrong.triangle_count = 0;
  CHECK(obc_untangle_triangles(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(std::count(result.begin(), result.end(), 99) == static_cast<std::ptrdiff_t>(result.size()));
  const std::vector<std::uint8_t> all(square.fixed.size(), 1);
  wrong = problem;
  wrong.fixed = all.data();
  CHECK(obc_untangle_triangles(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_NO_VALID_RESULT);
  CHECK(std::string(error.message).find("triangles") != std::string::npos);
  CHECK(result == square.start);
}

TEST_CASE("Each allocation that fails, and each report that cancels, ends the untangling of triangles") {
  const Square square;
  const obc_untangle_triangles_problem problem = square.problem();
  std::vector<double> result(square.start.size());
  const test::Call call = [&](const obc_host& host) {
    return obc_untangle_triangles(&problem, nullptr, &host, result.data(), nullptr, nullptr);
  };
  test::check_failing_allocations(call);
  test::check_cancelling(call);
}
