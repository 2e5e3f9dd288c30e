// The C functions of hexmesh: what they promise about arguments, memory, cancelling and threads. What the meshes are
// worth is tested in tests/hexmesh/.
#include "orbicube/hexmesh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "boxes.h"
#include "promises.h"

using namespace orbicube;
using test::BoxSurface;
using test::TwoBoxes;

namespace {

obc_hexmesh_options few_hexes() {
  obc_hexmesh_options options;
  REQUIRE(obc_hexmesh_options_init(&options, sizeof options) == OBC_OK);
  options.cells = 12;
  options.padding = OBC_HEXMESH_PADDING_WITHOUT;
  options.rounds = 1;
  options.max_hausdorff_percent = 0;
  return options;
}

}  // namespace

TEST_CASE("A box is filled with hexahedra that fill it") {
  const BoxSurface box;
  obc_hexmesh_options options = few_hexes();
  options.cells = 100;
  options.rounds = 10;
  options.max_hausdorff_percent = 0.1;
  obc_hexmesh_report report{};
  report.struct_size = sizeof report;
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  REQUIRE(obc_hexmesh_compute(&box.surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
  const std::size_t vertices = obc_hexmesh_vertex_count(hexes), count = obc_hexmesh_count(hexes);
  const std::size_t quads = obc_hexmesh_quad_count(hexes);
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
  REQUIRE(obc_hexmesh_copy(hexes, positions.data(), cells.data(), outer.data(), faces.data(), &error) == OBC_OK);
  obc_hexmesh_destroy(hexes);
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
  obc_hexmesh_options options = few_hexes();
  options.cells = 450;
  const auto fill_with = [&](double scale, double move, bool turned, obc_hexmesh_report* report, obc_hexmesh** hexes,
                             obc_error* error) {
    const TwoBoxes both(scale, move, turned);
    return obc_hexmesh_compute(&both.surface, &options, nullptr, report, hexes, error);
  };
  obc_hexmesh_report report{};
  report.struct_size = sizeof report;
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  REQUIRE(fill_with(2, 10, false, &report, &hexes, &error) == OBC_OK);
  CHECK(report.volume == doctest::Approx(12 + 96).epsilon(1e-6));
  CHECK(report.polycube_corners == 16);
  CHECK(report.min_scaled_jacobian > 0.9);
  const std::size_t count = obc_hexmesh_count(hexes);
  std::vector<double> positions(3 * obc_hexmesh_vertex_count(hexes));
  std::vector<std::uint32_t> cells(8 * count), faces(obc_hexmesh_quad_count(hexes));
  REQUIRE(obc_hexmesh_copy(hexes, positions.data(), cells.data(), nullptr, faces.data(), &error) == OBC_OK);
  obc_hexmesh_destroy(hexes);
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
  obc_hexmesh_destroy(hexes);
  hexes = nullptr;
  // Those that look the other way are turned.
  REQUIRE(fill_with(0.4, 0.25, false, &report, &hexes, &error) == OBC_OK);
  CHECK(report.volume == doctest::Approx(12 * (1 - 0.064)).epsilon(1e-6));
  obc_hexmesh_destroy(hexes);
  REQUIRE(fill_with(1, 10, true, &report, &hexes, &error) == OBC_OK);
  CHECK(report.volume == doctest::Approx(24).epsilon(1e-6));
  obc_hexmesh_destroy(hexes);
  hexes = nullptr;
  CHECK(fill_with(1, 1.5, false, nullptr, &hexes, &error) == OBC_NOT_MANIFOLD);
  CHECK(std::string(error.message).find("meet where they should not") != std::string::npos);
  CHECK(hexes == nullptr);
}

TEST_CASE("Cells of a grid in space fill a box, and one with a cavity, without a polycube") {
  obc_hexmesh_options options = few_hexes();
  options.cells = 500;
  options.rounds = 20;
  options.method = OBC_HEXMESH_METHOD_GRID;
  options.padding = OBC_HEXMESH_PADDING_AUTO;
  options.features = OBC_HEXMESH_FEATURES_OFF;
  obc_hexmesh_report report{};
  report.struct_size = sizeof report;
  obc_error error;
  const TwoBoxes hollow(0.4, 0.25, true);
  const BoxSurface box;
  const auto fill = [&](const obc_surface& surface, double volume) {
    obc_hexmesh* hexes = nullptr;
    REQUIRE(obc_hexmesh_compute(&surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
    CHECK(report.grid_based == 1);
    CHECK(report.padded == 1);
    CHECK(report.polycube_corners == 0);
    CHECK(report.min_scaled_jacobian > 0.2);
    // Edges of the box are cut off by less than a cell.
    CHECK(report.volume == doctest::Approx(volume).epsilon(0.05));
    CHECK(obc_hexmesh_count(hexes) > 300);
    CHECK(obc_hexmesh_count(hexes) < 800);
    std::vector<std::uint32_t> faces(obc_hexmesh_quad_count(hexes));
    REQUIRE(obc_hexmesh_copy(hexes, nullptr, nullptr, nullptr, faces.data(), &error) == OBC_OK);
    CHECK(*std::max_element(faces.begin(), faces.end()) == 0);
    obc_hexmesh_destroy(hexes);
  };
  fill(box.surface, 12);
  fill(hollow.surface, 12 * (1 - 0.064));
  obc_hexmesh* hexes = nullptr;
  options.padding = OBC_HEXMESH_PADDING_WITHOUT;
  CHECK(obc_hexmesh_compute(&box.surface, &options, nullptr, &report, &hexes, &error) == OBC_INVALID_ARGUMENT);
  options.padding = OBC_HEXMESH_PADDING_AUTO;
  options.method = 4;
  CHECK(obc_hexmesh_compute(&box.surface, &options, nullptr, &report, &hexes, &error) == OBC_INVALID_ARGUMENT);
}

TEST_CASE("Sharp edges are followed from the angle that the options give") {
  const BoxSurface box;
  for (const double angle : {0.0, 89.0, 91.0}) {
    obc_hexmesh_options options = few_hexes();
    options.feature_angle = angle;
    obc_hexmesh_report report{};
    report.struct_size = sizeof report;
    obc_hexmesh* hexes = nullptr;
    obc_error error;
    REQUIRE(obc_hexmesh_compute(&box.surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
    obc_hexmesh_destroy(hexes);
    CHECK(report.follows_sharp_edges == (angle == 89 ? 1 : 0));
  }
}

TEST_CASE(
    "Options of hexahedra that end before the sharp angle leave it at its default, and a report there stays as it is") {
  const BoxSurface box;
  obc_hexmesh_options options = few_hexes();
  options.feature_angle = -1;
  options.struct_size = offsetof(obc_hexmesh_options, feature_angle);
  obc_hexmesh_report report{};
  report.struct_size = offsetof(obc_hexmesh_report, follows_sharp_edges);
  report.follows_sharp_edges = 7;
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  REQUIRE(obc_hexmesh_compute(&box.surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
  obc_hexmesh_destroy(hexes);
  CHECK(report.follows_sharp_edges == 7);
  CHECK(report.volume > 0);
}

TEST_CASE("Wrong arguments of hexahedra are refused") {
  const BoxSurface box;
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  CHECK(obc_hexmesh_compute(nullptr, nullptr, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_hexmesh_compute(&box.surface, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_hexmesh_options options = few_hexes();
  options.padding = 3;
  CHECK(obc_hexmesh_compute(&box.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  options = few_hexes();
  options.cells = 0;
  CHECK(obc_hexmesh_compute(&box.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  for (const double distance : {-1.0, 101.0, std::numeric_limits<double>::quiet_NaN()}) {
    options = few_hexes();
    options.max_hausdorff_percent = distance;
    CHECK(obc_hexmesh_compute(&box.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  }
  for (const double angle : {-0.5, 180.0, std::numeric_limits<double>::quiet_NaN()}) {
    options = few_hexes();
    options.feature_angle = angle;
    CHECK(obc_hexmesh_compute(&box.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  }
  options = few_hexes();
  options.max_cells = 10'000'001;
  CHECK(obc_hexmesh_compute(&box.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  obc_surface opened = box.surface;
  --opened.triangle_count;
  CHECK(obc_hexmesh_compute(&opened, nullptr, nullptr, nullptr, &hexes, &error) == OBC_NOT_CLOSED);
  CHECK(hexes == nullptr);
  CHECK(obc_hexmesh_copy(nullptr, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_hexmesh_count(nullptr) + obc_hexmesh_vertex_count(nullptr) + obc_hexmesh_quad_count(nullptr) == 0);
  obc_hexmesh_destroy(nullptr);
}

TEST_CASE("Each allocation that fails, and each report that cancels, ends the making of hexahedra") {
  const BoxSurface box;
  const TwoBoxes hollow(0.4, 0.25, true);
  obc_hexmesh_options options = few_hexes();
  for (const auto& [surface, method] :
       {std::pair{&box.surface, OBC_HEXMESH_METHOD_AUTO}, std::pair{&hollow.surface, OBC_HEXMESH_METHOD_AUTO},
        std::pair{&box.surface, OBC_HEXMESH_METHOD_GRID}}) {
    options.method = method;
    options.padding = method == OBC_HEXMESH_METHOD_GRID ? OBC_HEXMESH_PADDING_AUTO : OBC_HEXMESH_PADDING_WITHOUT;
    const test::Call call =
        test::destroying(obc_hexmesh_destroy, [&, of = surface](const obc_host* host, obc_hexmesh** out) {
          return obc_hexmesh_compute(of, &options, host, nullptr, out, nullptr);
        });
    test::check_failing_allocations(call, 50);
    test::check_cancelling(call);
  }
}
