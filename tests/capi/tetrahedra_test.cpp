// The C functions of tetrahedra: what they promise about arguments, memory, cancelling and threads. What the solids are
// worth is tested in tests/tetrahedra/.
#include "orbicube/tetrahedra.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "failing_allocations.h"
#include "shapes.h"

using namespace orbicube;
using test::octahedron, test::Shape;

namespace {

// Two octahedra, one within or across the other.
Shape two(double scale, double shift) {
  Shape result = octahedron;
  for (std::size_t i = 0; i < octahedron.positions.size(); ++i)
    result.positions.push_back(scale * octahedron.positions[i] + (i % 3 == 0 ? shift : 0));
  for (const std::uint32_t v : octahedron.triangles)
    result.triangles.push_back(v + 6);
  return result;
}

}  // namespace

TEST_CASE("A solid has the surface's vertices first and its triangles as they are") {
  const Shape shape = two(0.25, 0.1);
  const obc_surface surface = shape.surface();
  obc_tetrahedra_options options;
  REQUIRE(obc_tetrahedra_options_init(&options, sizeof options) == OBC_OK);
  options.max_volume = 0.02;
  options.quality = 2;
  obc_tetrahedra* solid = nullptr;
  obc_error error;
  REQUIRE(obc_tetrahedra_fill(&surface, &options, nullptr, &solid, &error) == OBC_OK);
  CHECK(obc_tetrahedra_part_count(solid) == 1);
  CHECK(obc_tetrahedra_cavity_count(solid) == 1);
  REQUIRE(obc_tetrahedra_boundary_count(solid) == 16);
  std::vector<double> positions(3 * obc_tetrahedra_vertex_count(solid));
  std::vector<std::uint32_t> tetrahedra(4 * obc_tetrahedra_count(solid)), boundary(48), source(16);
  REQUIRE(obc_tetrahedra_copy(solid, positions.data(), tetrahedra.data(), boundary.data(), source.data(), &error) ==
          OBC_OK);
  CHECK(obc_tetrahedra_copy(solid, nullptr, nullptr, nullptr, nullptr, &error) == OBC_OK);
  CHECK(std::equal(shape.positions.begin(), shape.positions.end(), positions.begin()));
  double volume = 0;
  for (std::size_t t = 0; t < tetrahedra.size(); t += 4) {
    const auto* const x = positions.data();
    CHECK(obc_mesh_orientation_3d(x + 3 * tetrahedra[t], x + 3 * tetrahedra[t + 1], x + 3 * tetrahedra[t + 2],
                                  x + 3 * tetrahedra[t + 3]) == 1);
    double e[3][3];
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c)
        e[k][c] = x[3 * tetrahedra[t + k + 1] + c] - x[3 * tetrahedra[t] + c];
    }
    const double one =
        (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
        6;
    volume += one;
  }
  CHECK(volume == doctest::Approx(4.0 / 3 * (1 - 1.0 / 64)).epsilon(1e-12));
  for (std::size_t i = 0; i < 16; ++i) {
    CHECK(source[i] == i);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto* const first = &boundary[3 * i];
      CHECK(std::count(first, first + 3, shape.triangles[3 * i + k]) == 1);
    }
  }
  // The outer shell was outward-oriented and is as it was; the inner one is reversed, into the cavity.
  CHECK(std::equal(boundary.begin(), boundary.begin() + 24, shape.triangles.begin()));
  CHECK(!std::equal(boundary.begin() + 24, boundary.end(), shape.triangles.begin() + 24));
  obc_tetrahedra_destroy(solid);
}

TEST_CASE("A surface is filled into a mesh as with the options of that volume") {
  const Shape shape = two(0.25, 0.1);
  const obc_surface surface = shape.surface();
  obc_tetrahedra_options options;
  REQUIRE(obc_tetrahedra_options_init(&options, sizeof options) == OBC_OK);
  options.max_volume = 0.02;
  obc_tetrahedra* solid = nullptr;
  obc_mesh* mesh = nullptr;
  obc_error error;
  REQUIRE(obc_tetrahedra_fill(&surface, &options, nullptr, &solid, &error) == OBC_OK);
  REQUIRE(obc_tetrahedra_fill_mesh(&surface, options.max_volume, nullptr, &mesh, &error, nullptr) == OBC_OK);
  std::vector<double> x(3 * obc_tetrahedra_vertex_count(solid)), y(3 * obc_mesh_vertex_count(mesh));
  std::vector<std::uint32_t> s(4 * obc_tetrahedra_count(solid)), t(4 * obc_mesh_tetrahedron_count(mesh));
  REQUIRE(obc_tetrahedra_copy(solid, x.data(), s.data(), nullptr, nullptr, &error) == OBC_OK);
  REQUIRE(obc_mesh_copy(mesh, y.data(), nullptr, t.data(), nullptr, &error) == OBC_OK);
  CHECK(x == y);
  CHECK(s == t);
  obc_tetrahedra_destroy(solid);
  obc_mesh_destroy(mesh);
  CHECK(obc_tetrahedra_fill_mesh(&surface, 0.02, nullptr, nullptr, &error, nullptr) == OBC_INVALID_ARGUMENT);
  const Shape crossing = two(1, 0.5);
  const obc_surface crossed = crossing.surface();
  CHECK(obc_tetrahedra_fill_mesh(&crossed, 0.02, nullptr, &mesh, &error, nullptr) == OBC_NOT_MANIFOLD);
  CHECK(std::string(error.kind) == "self-intersection");
  CHECK(mesh == nullptr);
}

TEST_CASE("Faces that meet come back as pairs, as many as there is room for, and in the refusal") {
  const Shape shape = two(1, 0.5);
  const obc_surface surface = shape.surface();
  obc_error error;
  std::size_t count = 0;
  CHECK(obc_tetrahedra_check_surface(&surface, nullptr, nullptr, 0, &count, &error) == OBC_NOT_MANIFOLD);
  CHECK(std::string(error.kind) == "self-intersection");
  REQUIRE(count > 2);
  std::vector<std::uint32_t> pairs(2 * count, 99), expected(2 * count);
  std::size_t of_mesh = 0;
  REQUIRE(obc_mesh_intersections(&surface, nullptr, expected.data(), count, &of_mesh, &error) == OBC_OK);
  CHECK(of_mesh == count);
  CHECK(obc_tetrahedra_check_surface(&surface, nullptr, pairs.data(), 2, &count, &error) == OBC_NOT_MANIFOLD);
  CHECK(std::equal(pairs.begin(), pairs.begin() + 4, expected.begin()));
  CHECK(pairs[4] == 99);
  CHECK(obc_tetrahedra_check_surface(&surface, nullptr, pairs.data(), count, &count, &error) == OBC_NOT_MANIFOLD);
  CHECK(pairs == expected);
  const std::string message = error.message;
  CHECK(message.find(std::to_string(count)) != std::string::npos);
  CHECK(message.find(std::to_string(pairs[0]) + " and " + std::to_string(pairs[1])) != std::string::npos);

  obc_tetrahedra* solid = nullptr;
  CHECK(obc_tetrahedra_fill(&surface, nullptr, nullptr, &solid, &error) == OBC_NOT_MANIFOLD);
  CHECK(solid == nullptr);
  CHECK(message == error.message);

  const obc_surface good = octahedron.surface();
  CHECK(obc_tetrahedra_check_surface(&good, nullptr, nullptr, 0, &count, &error) == OBC_OK);
  CHECK(count == 0);
  const obc_surface open = {octahedron.positions.data(), 6, octahedron.triangles.data(), 7};
  CHECK(obc_tetrahedra_check_surface(&open, nullptr, nullptr, 0, &count, &error) == OBC_NOT_CLOSED);
}

TEST_CASE("Wrong arguments are refused, not followed") {
  const obc_surface surface = octahedron.surface();
  obc_tetrahedra* solid = nullptr;
  obc_error error;
  std::size_t count = 0;
  CHECK(obc_tetrahedra_fill(nullptr, nullptr, nullptr, &solid, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_tetrahedra_fill(&surface, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_tetrahedra_check_surface(&surface, nullptr, nullptr, 3, &count, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_tetrahedra_check_surface(&surface, nullptr, nullptr, 0, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_tetrahedra_copy(nullptr, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_tetrahedra_options_init(nullptr, sizeof(obc_tetrahedra_options)) == OBC_INVALID_ARGUMENT);
  CHECK(obc_tetrahedra_vertex_count(nullptr) + obc_tetrahedra_count(nullptr) + obc_tetrahedra_boundary_count(nullptr) +
            obc_tetrahedra_part_count(nullptr) + obc_tetrahedra_cavity_count(nullptr) ==
        0);
  obc_tetrahedra_destroy(nullptr);
  obc_tetrahedra_options options;
  obc_tetrahedra_options_init(&options, sizeof options);
  options.quality = std::numeric_limits<double>::quiet_NaN();
  CHECK(obc_tetrahedra_fill(&surface, &options, nullptr, &solid, &error) == OBC_INVALID_ARGUMENT);
  obc_tetrahedra_options_init(&options, sizeof options);
  const double places[] = {0, 0, 0, 1, 0, 0}, lengths[] = {0.5, 0};
  options.size_positions = places;
  options.size_count = 2;
  CHECK(obc_tetrahedra_fill(&surface, &options, nullptr, &solid, &error) == OBC_INVALID_ARGUMENT);
  options.size_lengths = lengths;
  CHECK(obc_tetrahedra_fill(&surface, &options, nullptr, &solid, &error) == OBC_INVALID_ARGUMENT);
  options.size_count = static_cast<std::size_t>(-1);
  CHECK(obc_tetrahedra_fill(&surface, &options, nullptr, &solid, &error) == OBC_INVALID_ARGUMENT);
  Shape wrong = octahedron;
  wrong.triangles[5] = 6;
  const obc_surface out_of_range = wrong.surface();
  CHECK(obc_tetrahedra_fill(&out_of_range, nullptr, nullptr, &solid, &error) == OBC_INVALID_ARGUMENT);
  CHECK(solid == nullptr);
}

TEST_CASE("A length at a place makes tetrahedra small there") {
  const obc_surface surface = octahedron.surface();
  const double place[] = {0, 0, 0}, length[] = {0.1};
  std::size_t counts[3];
  for (std::size_t run = 0; run < 3; ++run) {
    obc_tetrahedra_options options;
    REQUIRE(obc_tetrahedra_options_init(&options, sizeof options) == OBC_OK);
    CHECK(options.size_growth == 0.3);
    options.keep_surface = 0;  // of eight triangles it leaves no room for a vertex inside
    options.max_volume = 0.01;
    options.size_positions = place;
    options.size_lengths = length;
    options.size_count = run == 0 ? 0 : 1;
    options.size_growth = run == 1 ? 1 : 0.2;
    obc_tetrahedra* solid = nullptr;
    REQUIRE(obc_tetrahedra_fill(&surface, &options, nullptr, &solid, nullptr) == OBC_OK);
    counts[run] = obc_tetrahedra_count(solid);
    obc_tetrahedra_destroy(solid);
  }
  CHECK(counts[0] < counts[1]);
  CHECK(counts[1] < counts[2]);
}

TEST_CASE("Each allocation that fails ends in out of memory, in this process and in the child") {
  const obc_surface surface = octahedron.surface();
  const double places[] = {0, 0, 0, 1, 0, 0}, lengths[] = {0.5, 0.4};
  obc_tetrahedra_options options;
  REQUIRE(obc_tetrahedra_options_init(&options, sizeof options) == OBC_OK);
  options.size_positions = places;
  options.size_lengths = lengths;
  options.size_count = 2;
  const test::Outcome outcome = test::fail_each_allocation([&](const obc_host& host) {
    obc_tetrahedra* solid = nullptr;
    const obc_status status = obc_tetrahedra_fill(&surface, &options, &host, &solid, nullptr);
    obc_tetrahedra_destroy(solid);
    return status;
  });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 20);
}

TEST_CASE("Each progress report may cancel") {
  const Shape shape = two(0.25, 0);
  const obc_surface surface = shape.surface();
  const test::Outcome outcome = test::cancel_everywhere([&](const obc_host& host) {
    obc_tetrahedra* solid = nullptr;
    const obc_status status = obc_tetrahedra_fill(&surface, nullptr, &host, &solid, nullptr);
    obc_tetrahedra_destroy(solid);
    return status;
  });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 5);
}
