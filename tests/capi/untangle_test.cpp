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

// Three tetrahedra around an edge that passes outside of the triangle in their middle. All vertices are fixed; the
// hexahedron of their faces is star-shaped around that triangle.
struct Bipyramid {
  std::vector<double> positions = {0, 0, -1, 3, 0, 1, 1, 0, 0, -0.5, 0.75, 0, -0.5, -0.75, 0};
  std::vector<std::uint32_t> tetrahedra = {0, 1, 2, 3, 0, 1, 3, 4, 0, 1, 4, 2};

  obc_untangle_tetrahedra_problem problem() const {
    obc_untangle_tetrahedra_problem t;
    REQUIRE(obc_untangle_tetrahedra_problem_init(&t, sizeof t) == OBC_OK);
    t.positions = positions.data();
    t.vertex_count = positions.size() / 3;
    t.tetrahedra = tetrahedra.data();
    t.tetrahedron_count = tetrahedra.size() / 4;
    return t;
  }
};

// The square with a corner on the straight line between its neighbors, with which it has a triangle in common.
Square cut_square() {
  Square square;
  square.start[8] = 3.5;
  square.start[9] = 0.5;
  return square;
}

// A refined mesh in arrays, destroyed.
struct Copied {
  std::vector<double> positions, weights;
  std::vector<std::uint32_t> elements, parents, origins;

  Copied(obc_untangle_refined* refined, std::size_t axes)
      : positions(axes * obc_untangle_refined_vertex_count(refined)),
        weights((axes + 1) * obc_untangle_refined_vertex_count(refined)),
        elements((axes + 1) * obc_untangle_refined_element_count(refined)),
        parents(obc_untangle_refined_element_count(refined)),
        origins(weights.size()) {
    REQUIRE(obc_untangle_refined_copy(refined, positions.data(), elements.data(), parents.data(), origins.data(),
                                      weights.data(), nullptr) == OBC_OK);
    obc_untangle_refined_destroy(refined);
  }
};

obc_untangle_options without_steps() {
  obc_untangle_options options;
  REQUIRE(obc_untangle_options_init(&options, sizeof options) == OBC_OK);
  options.max_steps = 0;
  return options;
}

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

TEST_CASE("Tetrahedra around an edge that cannot lie inside are split at it") {
  const Bipyramid bipyramid;
  const obc_untangle_tetrahedra_problem problem = bipyramid.problem();
  std::vector<double> moved(bipyramid.positions.size());
  CHECK(obc_untangle_tetrahedra(&problem, nullptr, nullptr, moved.data(), nullptr, nullptr) == OBC_NO_VALID_RESULT);
  obc_untangle_refined* refined = nullptr;
  obc_untangle_report report;
  REQUIRE(obc_untangle_report_init(&report, sizeof report) == OBC_OK);
  REQUIRE(obc_untangle_refine_tetrahedra(&problem, nullptr, nullptr, &refined, &report, nullptr) == OBC_OK);
  CHECK(report.inverted_before == 2);
  CHECK(report.inverted == 0);
  CHECK(report.first_inverted == UINT32_MAX);
  CHECK(report.min_determinant > 0);
  CHECK(obc_untangle_refined_copy(refined, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr) == OBC_OK);
  const Copied mesh(refined, 3);
  REQUIRE(mesh.positions.size() == 18);
  CHECK(std::equal(bipyramid.positions.begin(), bipyramid.positions.end(), mesh.positions.begin()));
  for (std::size_t t = 0; t < mesh.elements.size(); t += 4) {
    const auto* const v = &mesh.elements[t];
    const double* const x = mesh.positions.data();
    CHECK(obc_mesh_orientation_3d(x + 3 * v[0], x + 3 * v[1], x + 3 * v[2], x + 3 * v[3]) == 1);
  }
  std::vector<std::uint32_t> parents = mesh.parents;
  std::sort(parents.begin(), parents.end());
  CHECK(parents == std::vector<std::uint32_t>{0, 0, 1, 1, 2, 2});
  CHECK(std::equal(mesh.origins.begin() + 20, mesh.origins.end(),
                   std::vector<std::uint32_t>{0, 1, UINT32_MAX, UINT32_MAX}.begin()));
  CHECK(std::equal(mesh.weights.begin() + 20, mesh.weights.end(), std::vector<double>{0.5, 0.5, 0, 0}.begin()));
}

TEST_CASE("A box that has a solution is refined to itself") {
  const Box box;
  const obc_untangle_tetrahedra_problem problem = problem_of(box);
  std::vector<double> moved(box.start.size());
  REQUIRE(obc_untangle_tetrahedra(&problem, nullptr, nullptr, moved.data(), nullptr, nullptr) == OBC_OK);
  obc_untangle_refined* refined = nullptr;
  REQUIRE(obc_untangle_refine_tetrahedra(&problem, nullptr, nullptr, &refined, nullptr, nullptr) == OBC_OK);
  const Copied mesh(refined, 3);
  CHECK(mesh.positions == moved);
  CHECK(mesh.elements == box.tetrahedra);
  for (std::size_t t = 0; t < mesh.parents.size(); ++t)
    CHECK(mesh.parents[t] == t);
}

TEST_CASE("A triangle with a straight side of the boundary is split, and its disk is mapped without a step too") {
  const Square square = cut_square();
  const obc_untangle_triangles_problem problem = square.problem();
  const obc_untangle_options constructed = without_steps();
  for (const obc_untangle_options* options : {static_cast<const obc_untangle_options*>(nullptr), &constructed}) {
    obc_untangle_refined* refined = nullptr;
    obc_untangle_report report;
    REQUIRE(obc_untangle_report_init(&report, sizeof report) == OBC_OK);
    REQUIRE(obc_untangle_refine_triangles(&problem, options, nullptr, &refined, &report, nullptr) == OBC_OK);
    CHECK(report.inverted == 0);
    CHECK(report.inverted_before > 0);
    if (options != nullptr) CHECK(report.steps == 0);
    const Copied mesh(refined, 2);
    CHECK(mesh.parents.size() > square.triangles.size() / 3);
    for (std::size_t t = 0; t < mesh.elements.size(); t += 3) {
      const auto* const v = &mesh.elements[t];
      CHECK(obc_mesh_orientation_2d(&mesh.positions[2 * v[0]], &mesh.positions[2 * v[1]], &mesh.positions[2 * v[2]]) ==
            1);
    }
    for (std::size_t i = 0; i < square.start.size(); ++i) {
      if (square.fixed[i / 2] != 0) CHECK(mesh.positions[i] == square.start[i]);
    }
  }
}

TEST_CASE("Wrong arguments of refinement are refused and leave no mesh") {
  const Bipyramid bipyramid;
  const Square square;
  obc_error error;
  obc_untangle_refined* refined = nullptr;
  const obc_untangle_tetrahedra_problem solid = bipyramid.problem();
  const obc_untangle_triangles_problem flat = square.problem();
  CHECK(obc_untangle_refine_tetrahedra(&solid, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_untangle_refine_triangles(&flat, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  const auto refuses = [&](const obc_untangle_tetrahedra_problem* problem, const obc_untangle_options* options,
                           obc_status wanted) {
    refined = reinterpret_cast<obc_untangle_refined*>(&error);
    CHECK(obc_untangle_refine_tetrahedra(problem, options, nullptr, &refined, nullptr, &error) == wanted);
    CHECK(refined == nullptr);
  };
  const auto refuses_flat = [&](const obc_untangle_triangles_problem* problem, obc_status wanted) {
    refined = reinterpret_cast<obc_untangle_refined*>(&error);
    CHECK(obc_untangle_refine_triangles(problem, nullptr, nullptr, &refined, nullptr, &error) == wanted);
    CHECK(refined == nullptr);
  };
  refuses(nullptr, nullptr, OBC_INVALID_ARGUMENT);
  refuses_flat(nullptr, OBC_INVALID_ARGUMENT);
  obc_untangle_tetrahedra_problem wrong = solid;
  wrong.vertex_count = 4;
  refuses(&wrong, nullptr, OBC_MALFORMED_FILE);
  wrong.vertex_count = SIZE_MAX;
  refuses(&wrong, nullptr, OBC_INVALID_ARGUMENT);
  wrong = solid;
  wrong.tetrahedra = nullptr;
  refuses(&wrong, nullptr, OBC_INVALID_ARGUMENT);
  std::vector<double> places = bipyramid.positions;
  places[4] = std::numeric_limits<double>::quiet_NaN();
  wrong = solid;
  wrong.positions = places.data();
  refuses(&wrong, nullptr, OBC_INVALID_ARGUMENT);
  obc_untangle_options options = without_steps();
  options.max_steps = -1;
  refuses(&solid, &options, OBC_INVALID_ARGUMENT);
  obc_untangle_triangles_problem wrong_flat = flat;
  wrong_flat.vertex_count = 5;
  refuses_flat(&wrong_flat, OBC_MALFORMED_FILE);
  wrong_flat = flat;
  std::vector<std::uint32_t> ties(square.start.size(), UINT32_MAX - 1);
  wrong_flat.ties = ties.data();
  refuses_flat(&wrong_flat, OBC_INVALID_ARGUMENT);
  CHECK(obc_untangle_refined_copy(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_untangle_refined_vertex_count(nullptr) == 0);
  CHECK(obc_untangle_refined_element_count(nullptr) == 0);
  obc_untangle_refined_destroy(nullptr);
}

TEST_CASE("What splits do not help is an error with the number of inverted elements") {
  // A square whose boundary crosses itself.
  const std::vector<double> crossed = {0, 0, 1, 1, 1, 0, 0, 1};
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 0, 2, 3};
  obc_untangle_triangles_problem problem;
  REQUIRE(obc_untangle_triangles_problem_init(&problem, sizeof problem) == OBC_OK);
  problem.positions = crossed.data();
  problem.vertex_count = 4;
  problem.triangles = triangles.data();
  problem.triangle_count = 2;
  obc_untangle_report report;
  REQUIRE(obc_untangle_report_init(&report, sizeof report) == OBC_OK);
  obc_untangle_refined* refined = nullptr;
  obc_error error;
  CHECK(obc_untangle_refine_triangles(&problem, nullptr, nullptr, &refined, &report, &error) == OBC_NO_VALID_RESULT);
  CHECK(refined == nullptr);
  CHECK(report.inverted > 0);
  CHECK(report.first_inverted != UINT32_MAX);
  CHECK(std::string(error.message).find(std::to_string(report.inverted)) != std::string::npos);
}

TEST_CASE("Each allocation that fails, and each report that cancels, ends the refinement") {
  const Bipyramid bipyramid;
  const Square square = cut_square();
  const obc_untangle_tetrahedra_problem solid = bipyramid.problem();
  const obc_untangle_triangles_problem flat = square.problem();
  const obc_untangle_options constructed = without_steps();
  const auto check = [](const auto& refine) {
    const test::Call call = test::destroying<obc_untangle_refined>(obc_untangle_refined_destroy, refine);
    test::check_failing_allocations(call);
    test::check_cancelling(call);
  };
  check([&](const obc_host* host, obc_untangle_refined** made) {
    return obc_untangle_refine_tetrahedra(&solid, nullptr, host, made, nullptr, nullptr);
  });
  check([&](const obc_host* host, obc_untangle_refined** made) {
    return obc_untangle_refine_triangles(&flat, nullptr, host, made, nullptr, nullptr);
  });
  check([&](const obc_host* host, obc_untangle_refined** made) {
    return obc_untangle_refine_triangles(&flat, &constructed, host, made, nullptr, nullptr);
  });
}
