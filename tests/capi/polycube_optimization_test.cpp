// The C functions for a polycube's best proportions and corners, and for features.
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
  // The area of the box, 56, on a cube with the box's center.
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

namespace {

// Each side of a cube as four squares, so that there is room for corners, and the surface a ball.
struct Ball {
  std::vector<double> polycube, positions;
  std::vector<std::uint32_t> faces;

  Ball() {
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
  }
  obc_polycube* map() const {
    const obc_surface surface = {positions.data(), positions.size() / 3, faces.data(), faces.size() / 3};
    obc_polycube* result = nullptr;
    obc_error error;
    REQUIRE(obc_polycube_create(&surface, polycube.data(), nullptr, nullptr, &result, &error) == OBC_OK);
    return result;
  }
};

}  // namespace

TEST_CASE("Each allocation of better corners that fails ends in out of memory, and each report may cancel") {
  obc_polycube* const map = Ball().map();
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
  check_every_end(call, 300);
  obc_polycube_destroy(map);
}

TEST_CASE("Points and curves in their target positions on the polycube, and what cannot be there") {
  const Ball ball;
  obc_polycube* const map = ball.map();
  obc_error error;
  // The middles of the sides, and those of their edges, by where they are.
  const auto vertex_at = [&](double x, double y, double z) {
    for (std::uint32_t v = 0; v < ball.polycube.size() / 3; ++v)
      if (ball.polycube[3 * v] == x && ball.polycube[3 * v + 1] == y && ball.polycube[3 * v + 2] == z) return v;
    return UINT32_MAX;
  };
  obc_polycube_feature_options options;
  REQUIRE(obc_polycube_feature_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.point_count == 0);
  CHECK(options.curve_count == 0);
  CHECK(options.feature_angle == 0);
  const std::vector<std::uint32_t> points = {vertex_at(0, 0, 1), vertex_at(1, 0, 0)};
  const std::vector<double> places = {0.25, 0.125, 1, 1, 0.25, 0};
  std::vector<double> weights = {0, 10};
  const std::vector<std::uint32_t> starts = {0, 3},
                                   vertices = {vertex_at(-1, 0, -1), vertex_at(0, 0, -1), vertex_at(1, 0, -1)};
  const std::vector<double> line = {-1, 0.125, -1, 1, 0.125, -1};
  options.point_count = 2;
  options.points = points.data();
  options.targets = places.data();
  options.point_weights = weights.data();
  options.curve_count = 1;
  options.curve_starts = starts.data();
  options.curve_vertices = vertices.data();
  options.curve_lines = line.data();
  obc_polycube_feature_report report{};
  report.struct_size = sizeof report;
  obc_polycube* made = nullptr;
  REQUIRE(obc_polycube_align_features(map, &options, nullptr, &report, &made, &error) == OBC_OK);
  CHECK(obc_polycube_corner_count(made) == 8);
  CHECK(obc_polycube_patch_count(made) == 6);
  std::vector<double> polycube(3 * obc_polycube_vertex_count(made));
  REQUIRE(obc_polycube_copy(made, nullptr, polycube.data(), nullptr, &error) == OBC_OK);
  const auto at = [&](std::uint32_t v) { return &polycube[3 * v]; };
  CHECK(std::equal(places.begin(), places.begin() + 3, at(points[0])));
  CHECK(at(points[1])[0] == 1);
  CHECK(at(points[1])[1] > 0.05);
  CHECK(std::equal(line.begin(), line.begin() + 3, at(vertices[0])));
  CHECK(std::equal(line.begin() + 3, line.end(), at(vertices[2])));
  CHECK(at(vertices[1])[1] == 0.125);
  CHECK(report.distance_before > 0.25);
  CHECK(report.distance < 0.2);
  CHECK(report.angle_mean >= 1);
  CHECK(report.sharp_length == 0);
  obc_polycube_destroy(made);

  const auto status = [&] { return obc_polycube_align_features(map, &options, nullptr, nullptr, &made, &error); };
  const std::vector<double> nowhere = {0, 0, 0, 1, 0.25, 0};
  options.targets = nowhere.data();
  CHECK(status() == OBC_INVALID_ARGUMENT);
  CHECK(made == nullptr);
  CHECK(std::string(error.message).find("not on the polycube") != std::string::npos);
  options.targets = nullptr;
  CHECK(status() == OBC_INVALID_ARGUMENT);
  // Two vertices of a triangle cannot change places while the third stays.
  const auto is_corner = [&](std::uint32_t v) {
    return std::abs(ball.polycube[3 * v]) + std::abs(ball.polycube[3 * v + 1]) + std::abs(ball.polycube[3 * v + 2]) ==
           3;
  };
  const std::uint32_t* t = ball.faces.data();
  while (std::any_of(t, t + 3, is_corner))
    t += 3;
  std::vector<double> swapped;
  for (const std::uint32_t v : {t[1], t[0], t[2]})
    swapped.insert(swapped.end(), &ball.polycube[3 * v], &ball.polycube[3 * v] + 3);
  options.point_count = 3;
  options.points = t;
  options.targets = swapped.data();
  options.point_weights = nullptr;
  options.curve_count = 0;
  CHECK(status() == OBC_NO_VALID_RESULT);
  CHECK(made == nullptr);
  options.curve_count = 1;
  options.curve_lines = nullptr;
  CHECK(status() == OBC_INVALID_ARGUMENT);
  options.curve_count = 0;
  options.feature_angle = -1;
  CHECK(status() == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_align_features(nullptr, nullptr, nullptr, nullptr, &made, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_align_features(map, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_polycube_feature_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  // The map satisfies no target at first.
  REQUIRE(obc_polycube_align_features(map, nullptr, nullptr, nullptr, &made, &error) == OBC_OK);
  std::vector<double> same(ball.polycube.size());
  REQUIRE(obc_polycube_copy(made, nullptr, same.data(), nullptr, &error) == OBC_OK);
  CHECK(same == ball.polycube);
  obc_polycube_destroy(made);
  obc_polycube_destroy(map);
}

TEST_CASE("Each allocation for features that fails ends in out of memory, and each report may cancel") {
  const Ball ball;
  obc_polycube* const map = ball.map();
  obc_polycube_feature_options options;
  obc_polycube_feature_options_init(&options, sizeof options);
  // A side's middle, in which four edges meet that are sharp.
  std::uint32_t middle = 0;
  while (ball.polycube[3 * middle] != 0 || ball.polycube[3 * middle + 1] != 0)
    ++middle;
  const double place[3] = {0.125, 0.25, ball.polycube[3 * middle + 2]};
  options.point_count = 1;
  options.points = &middle;
  options.targets = place;
  options.feature_angle = 30;
  check_every_end([&](const obc_host& host) {
    obc_polycube* made = nullptr;
    const obc_status status = obc_polycube_align_features(map, &options, &host, nullptr, &made, nullptr);
    obc_polycube_destroy(made);
    return status;
  });
  obc_polycube_destroy(map);
}
