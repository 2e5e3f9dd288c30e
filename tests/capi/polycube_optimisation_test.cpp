// The C functions for a polycube's best proportions and corners.
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

TEST_CASE("A cube's map to a longer box gets the cube's proportions back, certified") {
  std::vector<double> box = cube;
  for (std::size_t i = 0; i < box.size(); i += 3)
    box[i] *= 3;
  const obc_surface surface = {cube.data(), 8, triangles.data(), 12};
  obc_polycube *map = nullptr, *best = nullptr;
  obc_error error;
  REQUIRE(obc_polycube_create(&surface, box.data(), nullptr, nullptr, &map, &error) == OBC_OK);
  CHECK(obc_polycube_energy_count(map) == 0);
  obc_polycube_domain_options options;
  REQUIRE(obc_polycube_domain_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.measure == OBC_POLYCUBE_SURFACE_MEAN);
  CHECK(options.area_weight == 1);
  options.area_weight = 3;
  obc_polycube_domain_report report{};
  report.struct_size = sizeof report;
  REQUIRE(obc_polycube_optimize_domain(map, &options, nullptr, &report, &best, &error) == OBC_OK);
  CHECK(report.converged == 1);
  CHECK(report.energy == doctest::Approx(4).epsilon(1e-11));
  CHECK(report.energy_before > 4.1);
  CHECK(report.layers == 6);
  CHECK(report.cells == 3);
  CHECK(report.crossing == 0);
  CHECK(report.angle_mean == doctest::Approx(1).epsilon(1e-11));
  CHECK(obc_polycube_corner_count(best) == 8);
  CHECK(obc_polycube_patch_count(best) == 6);
  std::vector<double> energies(obc_polycube_energy_count(best));
  REQUIRE(energies.size() >= 2);
  REQUIRE(obc_polycube_copy_energies(best, energies.data(), &error) == OBC_OK);
  CHECK(energies.front() == report.energy_before);
  CHECK(energies.back() == report.energy);
  CHECK(std::is_sorted(energies.rbegin(), energies.rend()));
  // The area of the box, 56, on a cube with the box's centre.
  std::vector<double> polycube(24), before(24);
  REQUIRE(obc_polycube_copy(best, nullptr, polycube.data(), nullptr, &error) == OBC_OK);
  REQUIRE(obc_polycube_copy(map, nullptr, before.data(), nullptr, &error) == OBC_OK);
  CHECK(before == box);
  const double side = std::sqrt(56 / 6.0);
  for (std::size_t i = 0; i < 24; ++i)
    CHECK(polycube[i] == doctest::Approx((i % 3 == 0 ? 3 : 1) + (cube[i] - 1) * side / 2).epsilon(1e-6));
  obc_polycube_destroy(best);
  options.area_weight = -1;
  CHECK(obc_polycube_optimize_domain(map, &options, nullptr, nullptr, &best, &error) == OBC_INVALID_ARGUMENT);
  CHECK(best == nullptr);
  options.area_weight = 1;
  options.measure = 3;
  CHECK(obc_polycube_optimize_domain(map, &options, nullptr, nullptr, &best, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_optimize_domain(nullptr, nullptr, nullptr, nullptr, &best, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_optimize_domain(map, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_domain_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_copy_energies(nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_energy_count(nullptr) == 0);
  const test::Call call = [&](const obc_host& host) {
    obc_polycube* made = nullptr;
    const obc_status status = obc_polycube_optimize_domain(map, nullptr, &host, nullptr, &made, nullptr);
    obc_polycube_destroy(made);
    return status;
  };
  check_every_end(call);
  obc_polycube_destroy(map);
}

TEST_CASE("Corners in better places, certified, and with the best proportions in turn") {
  obc_mesh* mesh = nullptr;
  obc_surface surface;
  obc_error error;
  REQUIRE(obc_mesh_make("sphere", 600, 0, nullptr, &mesh, &error) == OBC_OK);
  REQUIRE(obc_mesh_surface(mesh, &surface, &error) == OBC_OK);
  obc_polycube_options how;
  REQUIRE(obc_polycube_options_init(&how, sizeof how) == OBC_OK);
  how.corners = 8;
  how.construction = OBC_POLYCUBE_VOXELS;
  obc_polycube* map = nullptr;
  REQUIRE(obc_polycube_compute(&surface, &how, nullptr, &map, &error) == OBC_OK);
  obc_polycube_corner_options options;
  REQUIRE(obc_polycube_corner_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.method == OBC_POLYCUBE_TRUST_REGION);
  CHECK(options.area_weight == 1);
  CHECK(options.domain == 0);
  CHECK(options.rounds >= 1);
  obc_polycube* best = nullptr;
  for (const std::int32_t method : {OBC_POLYCUBE_TRUST_REGION, OBC_POLYCUBE_GRADIENT}) {
    options.method = method;
    options.domain = method == OBC_POLYCUBE_GRADIENT ? 1 : 0;
    options.rounds = 2;
    obc_polycube_corner_report report{};
    report.struct_size = sizeof report;
    REQUIRE(obc_polycube_optimize_corners(map, &options, nullptr, &report, &best, &error) == OBC_OK);
    CHECK(obc_polycube_corner_count(best) == 8);
    CHECK(obc_polycube_patch_count(best) == 6);
    CHECK(obc_polycube_construction(best) == OBC_POLYCUBE_VOXELS);
    CHECK(report.movable > 0);
    CHECK(report.evaluations > 0);
    CHECK(report.map_evaluations > 0);
    CHECK(report.energy < report.energy_before);
    CHECK(report.angle_weighted_mean + report.area_weighted_mean == doctest::Approx(report.energy).epsilon(1e-12));
    std::vector<double> energies(obc_polycube_energy_count(best));
    REQUIRE(energies.size() >= 2);
    REQUIRE(obc_polycube_copy_energies(best, energies.data(), &error) == OBC_OK);
    CHECK(energies.front() == report.energy_before);
    CHECK(energies.back() == report.energy);
    CHECK(std::is_sorted(energies.rbegin(), energies.rend()));
    // The surface's vertices are there, and the map is what certification takes.
    const std::size_t count = obc_polycube_vertex_count(best);
    std::vector<double> positions(3 * count), polycube(3 * count);
    std::vector<std::uint32_t> faces(3 * obc_polycube_triangle_count(best));
    REQUIRE(obc_polycube_copy(best, positions.data(), polycube.data(), faces.data(), &error) == OBC_OK);
    CHECK(std::equal(surface.positions, surface.positions + 3 * surface.vertex_count, positions.begin()));
    const obc_surface refined = {positions.data(), count, faces.data(), faces.size() / 3};
    obc_polycube* again = nullptr;
    CHECK(obc_polycube_create(&refined, polycube.data(), nullptr, nullptr, &again, &error) == OBC_OK);
    obc_polycube_destroy(again);
    obc_polycube_destroy(best);
  }
  const auto refused = [&] {
    return obc_polycube_optimize_corners(map, &options, nullptr, nullptr, &best, &error) == OBC_INVALID_ARGUMENT &&
           best == nullptr;
  };
  options.area_weight = std::numeric_limits<double>::quiet_NaN();
  CHECK(refused());
  options.area_weight = 1;
  options.method = 2;
  CHECK(refused());
  options.method = 0;
  options.domain = 2;
  CHECK(refused());
  options.domain = 0;
  options.rounds = 0;
  CHECK(refused());
  CHECK(obc_polycube_optimize_corners(nullptr, nullptr, nullptr, nullptr, &best, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_optimize_corners(map, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_corner_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  obc_polycube_destroy(map);
  obc_mesh_destroy(mesh);
}

TEST_CASE("Each allocation of better corners that fails ends in out of memory, and each report may cancel") {
  // Each side of the cube as four squares, so that there is room for corners, and the surface a ball.
  std::vector<double> polycube, positions;
  std::vector<std::uint32_t> faces;
  constexpr int n = 2;
  std::vector<int> number((n + 1) * (n + 1) * (n + 1), -1);
  const auto vertex = [&](const int(&at)[3]) {
    int& own = number[static_cast<std::size_t>((at[0] * (n + 1) + at[1]) * (n + 1) + at[2])];
    if (own < 0) {
      own = static_cast<int>(polycube.size() / 3);
      const double x = at[0] - 0.5 * n, y = at[1] - 0.5 * n, z = at[2] - 0.5 * n;
      const double length = std::sqrt(x * x + y * y + z * z);
      polycube.insert(polycube.end(), {x, y, z});
      positions.insert(positions.end(), {x / length, (y + 0.1 * x) / length, z / length});
    }
    return static_cast<std::uint32_t>(own);
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int u, int v) {
            int at[3];
            at[axis] = side;
            at[(axis + (side > 0 ? 1 : 2)) % 3] = i + u;
            at[(axis + (side > 0 ? 2 : 1)) % 3] = j + v;
            return vertex(at);
          };
          const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          faces.insert(faces.end(), {a, b, c, a, c, d});
        }
      }
    }
  }
  const obc_surface surface = {positions.data(), positions.size() / 3, faces.data(), faces.size() / 3};
  obc_polycube* map = nullptr;
  obc_error error;
  REQUIRE(obc_polycube_create(&surface, polycube.data(), nullptr, nullptr, &map, &error) == OBC_OK);
  obc_polycube_corner_options options;
  obc_polycube_corner_options_init(&options, sizeof options);
  options.rounds = 1;
  const test::Call call = [&](const obc_host& host) {
    obc_polycube* made = nullptr;
    const obc_status status = obc_polycube_optimize_corners(map, &options, &host, nullptr, &made, nullptr);
    obc_polycube_destroy(made);
    return status;
  };
  CHECK(test::cancel_everywhere(call).problem == "");
  options.method = OBC_POLYCUBE_GRADIENT;
  check_every_end(call);
  obc_polycube_destroy(map);
}
