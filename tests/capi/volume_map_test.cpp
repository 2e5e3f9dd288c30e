// The C functions of volume_map: what they promise about arguments, memory, cancelling and threads. What the maps are
// worth is tested in tests/volume_map/.
#include "orbicube/volume_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "promises.h"

using namespace orbicube;

namespace {

// A box of 3 x 2 x 2 cubes, each of six tetrahedra; its boundary is fixed, vertices inside are at one corner.
struct Box {
  std::vector<double> rest, start;
  std::vector<std::uint32_t> tetrahedra;
  std::vector<std::uint8_t> fixed;

  Box() {
    const int size[] = {3, 2, 2};
    const auto at = [](const int* p) { return static_cast<std::uint32_t>((p[0] * 3 + p[1]) * 3 + p[2]); };
    for (int x = 0; x <= 3; ++x) {
      for (int y = 0; y <= 2; ++y) {
        for (int z = 0; z <= 2; ++z) {
          const bool inside = x > 0 && x < 3 && y == 1 && z == 1;
          for (const int c : {x, y, z}) {
            rest.push_back(c);
            start.push_back(inside ? 0 : c);
            fixed.push_back(!inside);
          }
          if (x == size[0] || y == size[1] || z == size[2]) continue;
          const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
          for (int o = 0; o < 6; ++o) {
            int p[3] = {x, y, z};
            std::uint32_t t[4] = {at(p), 0, 0, 0};
            for (int k = 0; k < 3; ++k) {
              ++p[orders[o][k]];
              t[k + 1] = at(p);
            }
            if (o >= 3) std::swap(t[2], t[3]);
            tetrahedra.insert(tetrahedra.end(), t, t + 4);
          }
        }
      }
    }
  }

  obc_mesh* mesh() const {
    obc_mesh_cells cells;
    REQUIRE(obc_mesh_cells_init(&cells, sizeof cells) == OBC_OK);
    cells.positions = rest.data();
    cells.vertex_count = rest.size() / 3;
    cells.tetrahedra = tetrahedra.data();
    cells.tetrahedron_count = tetrahedra.size() / 4;
    obc_mesh* result = nullptr;
    REQUIRE(obc_mesh_create(&cells, nullptr, &result, nullptr) == OBC_OK);
    return result;
  }

  obc_volume_map_untangle_problem problem() const {
    obc_volume_map_untangle_problem t;
    REQUIRE(obc_volume_map_untangle_problem_init(&t, sizeof t) == OBC_OK);
    t.positions = start.data();
    t.vertex_count = start.size() / 3;
    t.tetrahedra = tetrahedra.data();
    t.tetrahedron_count = tetrahedra.size() / 4;
    t.rest = rest.data();
    t.fixed = fixed.data();
    return t;
  }
};

// Its surface, with what keeps it.
struct BoxSurface {
  obc_mesh* mesh = nullptr;
  obc_surface surface{};

  BoxSurface() {
    obc_mesh* const solid = Box().mesh();
    REQUIRE(obc_mesh_boundary(solid, nullptr, &mesh, nullptr) == OBC_OK);
    obc_mesh_destroy(solid);
    REQUIRE(obc_mesh_surface(mesh, &surface, nullptr) == OBC_OK);
  }
  BoxSurface(const BoxSurface&) = delete;
  BoxSurface& operator=(const BoxSurface&) = delete;
  ~BoxSurface() { obc_mesh_destroy(mesh); }
};

// The surface of the box, 3 by 2 by 2, and the same scaled about its middle and moved along x; with `turned`, that one
// is inward-oriented.
struct TwoBoxes {
  std::vector<double> positions;
  std::vector<std::uint32_t> corners;
  obc_surface surface{};

  TwoBoxes(double scale, double move, bool turned) {
    constexpr std::array<double, 3> middle = {1.5, 1, 1};
    const BoxSurface box;
    const std::size_t vertices = box.surface.vertex_count, triangles = box.surface.triangle_count;
    positions.assign(box.surface.positions, box.surface.positions + 3 * vertices);
    corners.assign(box.surface.triangles, box.surface.triangles + 3 * triangles);
    for (std::size_t i = 0; i < 3 * vertices; ++i)
      positions.push_back(middle[i % 3] + scale * (positions[i] - middle[i % 3]) + (i % 3 == 0 ? move : 0));
    for (std::size_t t = 0; t < triangles; ++t) {
      for (std::size_t k = 0; k < 3; ++k)
        corners.push_back(static_cast<std::uint32_t>(vertices) + corners[3 * t + (turned ? 2 - k : k)]);
    }
    surface = {positions.data(), 2 * vertices, corners.data(), 2 * triangles};
  }
};

obc_volume_map_hexes_options few_hexes() {
  obc_volume_map_hexes_options options;
  REQUIRE(obc_volume_map_hexes_options_init(&options, sizeof options) == OBC_OK);
  options.cells = 12;
  options.padding = OBC_VOLUME_MAP_PADDING_WITHOUT;
  options.rounds = 1;
  options.max_hausdorff_percent = 0;
  return options;
}

}  // namespace

TEST_CASE("An inverted box is untangled, in place too, and the report says how") {
  Box box;
  obc_volume_map_untangle_problem problem = box.problem();
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
  obc_volume_map_untangle_problem problem = box.problem();
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
  const obc_volume_map_untangle_problem problem = box.problem();
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
  const obc_volume_map_untangle_problem problem = box.problem();
  std::vector<double> result(box.start.size());
  const test::Call call = [&](const obc_host& host) {
    return obc_volume_map_untangle(&problem, nullptr, &host, result.data(), nullptr, nullptr);
  };
  test::check_failing_allocations(call);
  test::check_cancelling(call);
}

TEST_CASE("A box is filled with hexahedra that fill it") {
  const BoxSurface box;
  obc_volume_map_hexes_options options = few_hexes();
  options.cells = 100;
  options.rounds = 10;
  options.max_hausdorff_percent = 0.1;
  obc_volume_map_hexes_report report{};
  report.struct_size = sizeof report;
  obc_volume_map_hexes* hexes = nullptr;
  obc_error error;
  REQUIRE(obc_volume_map_hexes_compute(&box.surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
  const std::size_t vertices = obc_volume_map_hexes_vertex_count(hexes), count = obc_volume_map_hexes_count(hexes);
  const std::size_t quads = obc_volume_map_hexes_quad_count(hexes);
  CHECK(count > 50);
  CHECK(report.padded == 0);
  CHECK(report.polycube_corners == 8);
  CHECK(report.volume == doctest::Approx(12).epsilon(1e-6));
  CHECK(report.min_scaled_jacobian > 0.9);
  CHECK(report.hausdorff_percent < 0.1);
  CHECK(report.volume_error_percent < 1e-4);
  CHECK(count < 200);
  std::vector<double> positions(3 * vertices);
  std::vector<std::uint32_t> cells(8 * count), outer(4 * quads), faces(quads);
  REQUIRE(obc_volume_map_hexes_copy(hexes, positions.data(), cells.data(), outer.data(), faces.data(), &error) ==
          OBC_OK);
  obc_volume_map_hexes_destroy(hexes);
  obc_mesh_cells given;
  REQUIRE(obc_mesh_cells_init(&given, sizeof given) == OBC_OK);
  given.positions = positions.data();
  given.vertex_count = vertices;
  given.hexahedra = cells.data();
  given.hexahedron_count = count;
  obc_mesh *mesh = nullptr, *boundary = nullptr;
  REQUIRE(obc_mesh_create(&given, nullptr, &mesh, &error) == OBC_OK);
  CHECK(obc_mesh_check_cells(mesh, nullptr, &error) == OBC_OK);
  REQUIRE(obc_mesh_boundary(mesh, nullptr, &boundary, &error) == OBC_OK);
  CHECK(obc_mesh_triangle_count(boundary) == 2 * quads);
  obc_mesh_destroy(boundary);
  obc_mesh_destroy(mesh);
  CHECK(*std::max_element(faces.begin(), faces.end()) == 5);
}

TEST_CASE("Pieces that lie apart are filled together, cavities are left out, and pieces that meet are refused") {
  obc_volume_map_hexes_options options = few_hexes();
  options.cells = 450;
  const auto fill_with = [&](double scale, double move, bool turned, obc_volume_map_hexes_report* report,
                             obc_volume_map_hexes** hexes, obc_error* error) {
    const TwoBoxes both(scale, move, turned);
    return obc_volume_map_hexes_compute(&both.surface, &options, nullptr, report, hexes, error);
  };
  obc_volume_map_hexes_report report{};
  report.struct_size = sizeof report;
  obc_volume_map_hexes* hexes = nullptr;
  obc_error error;
  REQUIRE(fill_with(2, 10, false, &report, &hexes, &error) == OBC_OK);
  CHECK(report.volume == doctest::Approx(12 + 96).epsilon(1e-6));
  CHECK(report.polycube_corners == 16);
  CHECK(report.min_scaled_jacobian > 0.9);
  const std::size_t count = obc_volume_map_hexes_count(hexes);
  std::vector<double> positions(3 * obc_volume_map_hexes_vertex_count(hexes));
  std::vector<std::uint32_t> cells(8 * count), faces(obc_volume_map_hexes_quad_count(hexes));
  REQUIRE(obc_volume_map_hexes_copy(hexes, positions.data(), cells.data(), nullptr, faces.data(), &error) == OBC_OK);
  obc_volume_map_hexes_destroy(hexes);
  hexes = nullptr;
  // Each hexahedron is in one of the pieces; a ninth of the volume has about a ninth of them.
  std::size_t in_first = 0, in_both = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t first = 0;
    for (std::size_t k = 0; k < 8; ++k)
      first += positions[3 * cells[8 * i + k]] < 5;
    in_first += first == 8;
    in_both += first != 0 && first != 8;
  }
  CHECK(in_both == 0);
  CHECK(count > 5 * in_first);
  CHECK(count < 20 * in_first);
  CHECK(*std::max_element(faces.begin(), faces.end()) == 11);

  // A wall that looks into its cavity, and one that does not.
  REQUIRE(fill_with(0.4, 0.25, true, &report, &hexes, &error) == OBC_OK);
  CHECK(report.volume == doctest::Approx(12 * (1 - 0.064)).epsilon(1e-6));
  CHECK(report.polycube_corners == 16);
  CHECK(report.min_scaled_jacobian > 0.5);
  obc_volume_map_hexes_destroy(hexes);
  hexes = nullptr;
  CHECK(fill_with(0.4, 0.25, false, nullptr, &hexes, &error) == OBC_NOT_MANIFOLD);
  CHECK(std::string(error.message).find("boundaries of cavities") != std::string::npos);
  CHECK(fill_with(1, 1.5, false, nullptr, &hexes, &error) == OBC_NOT_MANIFOLD);
  CHECK(std::string(error.message).find("meet where they should not") != std::string::npos);
  CHECK(fill_with(1, 10, true, nullptr, &hexes, &error) == OBC_NOT_MANIFOLD);
  CHECK(std::string(error.message).find("look into the solid") != std::string::npos);
  CHECK(hexes == nullptr);
}

TEST_CASE("Cells of a grid in space fill a box, and one with a cavity, without a polycube") {
  obc_volume_map_hexes_options options = few_hexes();
  options.cells = 500;
  options.rounds = 20;
  options.method = OBC_VOLUME_MAP_METHOD_GRID;
  options.padding = OBC_VOLUME_MAP_PADDING_AUTO;
  obc_volume_map_hexes_report report{};
  report.struct_size = sizeof report;
  obc_error error;
  const TwoBoxes hollow(0.4, 0.25, true);
  const BoxSurface box;
  const auto fill = [&](const obc_surface& surface, double volume) {
    obc_volume_map_hexes* hexes = nullptr;
    REQUIRE(obc_volume_map_hexes_compute(&surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
    CHECK(report.grid_based == 1);
    CHECK(report.padded == 1);
    CHECK(report.polycube_corners == 0);
    CHECK(report.min_scaled_jacobian > 0.2);
    // Edges of the box are cut off by less than a cell.
    CHECK(report.volume == doctest::Approx(volume).epsilon(0.05));
    CHECK(obc_volume_map_hexes_count(hexes) > 300);
    CHECK(obc_volume_map_hexes_count(hexes) < 800);
    std::vector<std::uint32_t> faces(obc_volume_map_hexes_quad_count(hexes));
    REQUIRE(obc_volume_map_hexes_copy(hexes, nullptr, nullptr, nullptr, faces.data(), &error) == OBC_OK);
    CHECK(*std::max_element(faces.begin(), faces.end()) == 0);
    obc_volume_map_hexes_destroy(hexes);
  };
  fill(box.surface, 12);
  fill(hollow.surface, 12 * (1 - 0.064));
  obc_volume_map_hexes* hexes = nullptr;
  options.padding = OBC_VOLUME_MAP_PADDING_WITHOUT;
  CHECK(obc_volume_map_hexes_compute(&box.surface, &options, nullptr, &report, &hexes, &error) == OBC_INVALID_ARGUMENT);
  options.padding = OBC_VOLUME_MAP_PADDING_AUTO;
  options.method = 3;
  CHECK(obc_volume_map_hexes_compute(&box.surface, &options, nullptr, &report, &hexes, &error) == OBC_INVALID_ARGUMENT);
}

TEST_CASE("Sharp edges are followed from the angle that the options give") {
  const BoxSurface box;
  for (const double angle : {0.0, 89.0, 91.0}) {
    obc_volume_map_hexes_options options = few_hexes();
    options.feature_angle = angle;
    obc_volume_map_hexes_report report{};
    report.struct_size = sizeof report;
    obc_volume_map_hexes* hexes = nullptr;
    obc_error error;
    REQUIRE(obc_volume_map_hexes_compute(&box.surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
    obc_volume_map_hexes_destroy(hexes);
    CHECK(report.follows_sharp_edges == (angle == 89 ? 1 : 0));
  }
}

TEST_CASE(
    "Options of hexahedra that end before the sharp angle leave it at its default, and a report there stays as it is") {
  const BoxSurface box;
  obc_volume_map_hexes_options options = few_hexes();
  options.feature_angle = -1;
  options.struct_size = offsetof(obc_volume_map_hexes_options, feature_angle);
  obc_volume_map_hexes_report report{};
  report.struct_size = offsetof(obc_volume_map_hexes_report, follows_sharp_edges);
  report.follows_sharp_edges = 7;
  obc_volume_map_hexes* hexes = nullptr;
  obc_error error;
  REQUIRE(obc_volume_map_hexes_compute(&box.surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
  obc_volume_map_hexes_destroy(hexes);
  CHECK(report.follows_sharp_edges == 7);
  CHECK(report.volume > 0);
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

TEST_CASE("Wrong arguments of solids and hexahedra are refused") {
  const BoxSurface box;
  const Box solid_box;
  obc_volume_map_hexes* hexes = nullptr;
  obc_volume_map_solid* solid = nullptr;
  obc_error error;
  CHECK(obc_volume_map_hexes_compute(nullptr, nullptr, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_volume_map_hexes_compute(&box.surface, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_volume_map_hexes_options options = few_hexes();
  options.padding = 3;
  CHECK(obc_volume_map_hexes_compute(&box.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  options = few_hexes();
  options.cells = 0;
  CHECK(obc_volume_map_hexes_compute(&box.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  for (const double distance : {-1.0, 101.0, std::numeric_limits<double>::quiet_NaN()}) {
    options = few_hexes();
    options.max_hausdorff_percent = distance;
    CHECK(obc_volume_map_hexes_compute(&box.surface, &options, nullptr, nullptr, &hexes, &error) ==
          OBC_INVALID_ARGUMENT);
  }
  for (const double angle : {-1.0, 180.0, std::numeric_limits<double>::quiet_NaN()}) {
    options = few_hexes();
    options.feature_angle = angle;
    CHECK(obc_volume_map_hexes_compute(&box.surface, &options, nullptr, nullptr, &hexes, &error) ==
          OBC_INVALID_ARGUMENT);
  }
  options = few_hexes();
  options.max_cells = 10'000'001;
  CHECK(obc_volume_map_hexes_compute(&box.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  obc_surface opened = box.surface;
  --opened.triangle_count;
  CHECK(obc_volume_map_hexes_compute(&opened, nullptr, nullptr, nullptr, &hexes, &error) == OBC_NOT_CLOSED);
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
  CHECK(hexes == nullptr);
  CHECK(solid == nullptr);
  CHECK(obc_volume_map_hexes_copy(nullptr, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_volume_map_solid_copy(nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_volume_map_hexes_count(nullptr) + obc_volume_map_hexes_vertex_count(nullptr) +
            obc_volume_map_hexes_quad_count(nullptr) + obc_volume_map_solid_vertex_count(nullptr) +
            obc_volume_map_solid_tetrahedron_count(nullptr) ==
        0);
  obc_volume_map_hexes_destroy(nullptr);
  obc_volume_map_solid_destroy(nullptr);
}

TEST_CASE("Each allocation that fails, and each report that cancels, ends the making of hexahedra") {
  const BoxSurface box;
  const TwoBoxes hollow(0.4, 0.25, true);
  obc_volume_map_hexes_options options = few_hexes();
  for (const auto& [surface, method] :
       {std::pair{&box.surface, OBC_VOLUME_MAP_METHOD_AUTO}, std::pair{&hollow.surface, OBC_VOLUME_MAP_METHOD_AUTO},
        std::pair{&box.surface, OBC_VOLUME_MAP_METHOD_GRID}}) {
    options.method = method;
    options.padding =
        method == OBC_VOLUME_MAP_METHOD_GRID ? OBC_VOLUME_MAP_PADDING_AUTO : OBC_VOLUME_MAP_PADDING_WITHOUT;
    const test::Call call = test::destroying(
        obc_volume_map_hexes_destroy, [&, of = surface](const obc_host* host, obc_volume_map_hexes** out) {
          return obc_volume_map_hexes_compute(of, &options, host, nullptr, out, nullptr);
        });
    test::check_failing_allocations(call, 50);
    test::check_cancelling(call);
  }
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
