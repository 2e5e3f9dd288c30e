// The C function of hexmesh for hexahedra along frames: arguments, memory and cancelling. What the meshes are worth
// is tested in tests/hexmesh/.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "boxes.h"
#include "orbicube/hexmesh.h"
#include "promises.h"

using namespace orbicube;

namespace {

// 2 x 2 x 1 cubes, each of six tetrahedra, with the frame of the axes.
struct FramedBox {
  std::vector<double> positions, frames;
  std::vector<std::uint32_t> tetrahedra;

  FramedBox() {
    const auto at = [](const std::array<int, 3>& p) {
      return static_cast<std::uint32_t>((p[0] * 3 + p[1]) * 2 + p[2]);
    };
    for (int x = 0; x <= 2; ++x) {
      for (int y = 0; y <= 2; ++y) {
        for (int z = 0; z <= 1; ++z) {
          for (const int c : {x, y, z})
            positions.push_back(c);
          if (x < 2 && y < 2 && z < 1) test::append_cube({x, y, z}, at, tetrahedra);
        }
      }
    }
    for (std::size_t t = 0; t < tetrahedra.size() / 4; ++t)
      frames.insert(frames.end(), {2, 0, 0, 0});  // lengths do not matter
  }

  obc_status hexes(const double* of, const obc_hexmesh_options* options, const obc_host* host,
                   obc_hexmesh_report* report, obc_hexmesh** out, obc_error* error) const {
    return obc_hexmesh_compute_solid(positions.data(), positions.size() / 3, tetrahedra.data(), tetrahedra.size() / 4,
                                     of, options, host, report, out, error);
  }
};

obc_hexmesh_options few() {
  obc_hexmesh_options options;
  REQUIRE(obc_hexmesh_options_init(&options, sizeof options) == OBC_OK);
  options.method = OBC_HEXMESH_METHOD_FRAMES;
  options.cells = 4;
  options.rounds = 1;
  return options;
}

}  // namespace

TEST_CASE("A box with the frames of the axes becomes its cubes, and so it does without frames") {
  const FramedBox box;
  const obc_hexmesh_options options = few();
  for (const double* frames : {box.frames.data(), static_cast<const double*>(nullptr)}) {
    obc_hexmesh_report report{};
    report.struct_size = sizeof report;
    obc_hexmesh* hexes = nullptr;
    obc_error error;
    REQUIRE(box.hexes(frames, &options, nullptr, &report, &hexes, &error) == OBC_OK);
    CHECK(obc_hexmesh_count(hexes) == 4);
    CHECK(obc_hexmesh_vertex_count(hexes) == 18);
    CHECK(obc_hexmesh_quad_count(hexes) == 16);
    CHECK(report.volume == doctest::Approx(4).epsilon(1e-9));
    CHECK(report.min_scaled_jacobian == doctest::Approx(1).epsilon(1e-6));
    CHECK(report.singular_edges == 0);
    CHECK(report.irregular_edges == 0);
    CHECK(report.integers == 6);
    CHECK(report.integers_optimal == 1);
    CHECK(report.hausdorff_percent < 1e-6);
    CHECK(report.volume_error_percent < 1e-6);
    CHECK(report.inverted_at_start == 0);
    CHECK(report.tetrahedra >= box.tetrahedra.size() / 4);
    obc_hexmesh_destroy(hexes);
  }
}

TEST_CASE("Wrong arguments of hexahedra along frames are refused") {
  const FramedBox box;
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  CHECK(box.hexes(nullptr, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_hexmesh_options options = few();
  options.cells = 0;
  CHECK(box.hexes(box.frames.data(), &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  options = few();
  options.rounds = -1;
  CHECK(box.hexes(box.frames.data(), &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  options = few();
  options.feature_angle = std::numeric_limits<double>::quiet_NaN();
  CHECK(box.hexes(box.frames.data(), &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  for (const double distance : {-1.0, 101.0, std::numeric_limits<double>::quiet_NaN()}) {
    options = few();
    options.max_hausdorff_percent = distance;
    CHECK(box.hexes(box.frames.data(), &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  }
  options = few();
  options.max_cells = 20'000'000;
  CHECK(box.hexes(box.frames.data(), &options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  FramedBox wrong = box;
  wrong.frames[5] = std::numeric_limits<double>::infinity();
  CHECK(wrong.hexes(wrong.frames.data(), nullptr, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  wrong = box;
  wrong.frames[0] = 0;
  CHECK(wrong.hexes(wrong.frames.data(), nullptr, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  wrong = box;
  wrong.positions[7] = std::numeric_limits<double>::quiet_NaN();
  CHECK(wrong.hexes(wrong.frames.data(), nullptr, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  wrong = box;
  wrong.tetrahedra[3] = 1000;
  CHECK(wrong.hexes(wrong.frames.data(), nullptr, nullptr, nullptr, &hexes, &error) == OBC_MALFORMED_FILE);
  wrong = box;
  std::swap(wrong.tetrahedra[0], wrong.tetrahedra[1]);
  CHECK(wrong.hexes(wrong.frames.data(), nullptr, nullptr, nullptr, &hexes, &error) == OBC_DEGENERATE);
  CHECK(std::string(error.kind) == "inverted-cell");
  CHECK(obc_hexmesh_compute_solid(nullptr, 4, box.tetrahedra.data(), 1, nullptr, nullptr, nullptr, nullptr, &hexes,
                                  &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_hexmesh_compute_solid(box.positions.data(), 18, nullptr, 0, nullptr, nullptr, nullptr, nullptr, &hexes,
                                  &error) == OBC_INVALID_ARGUMENT);
  CHECK(hexes == nullptr);
}

TEST_CASE("Each allocation that fails, and each report that cancels, ends the making of hexahedra along frames") {
  const FramedBox box;
  const obc_hexmesh_options options = few();
  const test::Call call = test::destroying(obc_hexmesh_destroy, [&](const obc_host* host, obc_hexmesh** out) {
    return box.hexes(box.frames.data(), &options, host, nullptr, out, nullptr);
  });
  test::check_failing_allocations(call, 50);
  test::check_cancelling(call);
}

namespace {

// A cube of six tetrahedra around its diagonal, whose surface has all its vertices.
struct Cube {
  std::vector<double> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
  std::vector<std::uint32_t> tetrahedra = {0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7, 0, 6, 4, 7, 0, 4, 5, 7, 0, 5, 1, 7};
  obc_mesh* boundary = nullptr;
  obc_surface surface{};

  Cube() {
    obc_mesh* const solid = mesh(positions, tetrahedra, nullptr);
    REQUIRE(obc_mesh_boundary(solid, nullptr, &boundary, nullptr) == OBC_OK);
    obc_mesh_destroy(solid);
    REQUIRE(obc_mesh_surface(boundary, &surface, nullptr) == OBC_OK);
  }
  Cube(const Cube&) = delete;
  Cube& operator=(const Cube&) = delete;
  ~Cube() { obc_mesh_destroy(boundary); }

  static obc_mesh* mesh(const std::vector<double>& positions, const std::vector<std::uint32_t>& tetrahedra,
                        const obc_host* host) {
    obc_mesh_cells cells;
    REQUIRE(obc_mesh_cells_init(&cells, sizeof cells) == OBC_OK);
    cells.positions = positions.data();
    cells.vertex_count = positions.size() / 3;
    cells.tetrahedra = tetrahedra.data();
    cells.tetrahedron_count = tetrahedra.size() / 4;
    obc_mesh* result = nullptr;
    return obc_mesh_create(&cells, host, &result, nullptr) == OBC_OK ? result : nullptr;
  }

  // The tetrahedra on the vertices of the surface, which has them in another order; the first one may be moved.
  obc_mesh* filled(const obc_surface& of, double move, const obc_host* host) const {
    std::vector<double> places(of.positions, of.positions + 3 * of.vertex_count);
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t v : tetrahedra) {
      std::uint32_t w = 0;
      while (!std::equal(&positions[3 * v], &positions[3 * v] + 3, &places[3 * w]))
        ++w;
      numbers.push_back(w);
    }
    places[0] += move;
    return mesh(places, numbers, host);
  }
};

// What a filling function gets and does.
struct Filling {
  const Cube* cube = nullptr;
  obc_status status = OBC_OK;
  const char* kind = "";
  double move = 0;
  int calls = 0;
  double max_volume = 0;
};

obc_status fill_cube(const obc_surface* surface, double max_volume, const obc_host* host, obc_mesh** out,
                     obc_error* error, void* user) {
  auto* const filling = static_cast<Filling*>(user);
  ++filling->calls;
  filling->max_volume = max_volume;
  CHECK(surface->vertex_count == 8);
  CHECK(surface->triangle_count == 12);
  if (filling->status != OBC_OK) {
    std::strcpy(error->kind, filling->kind);
    std::strcpy(error->message, "refused");
    return filling->status;
  }
  if (host->progress != nullptr && host->progress("filling", 0, 1, 0, host->progress_user) != 0) return OBC_CANCELLED;
  *out = filling->cube->filled(*surface, filling->move, host);
  return *out != nullptr ? OBC_OK : OBC_OUT_OF_MEMORY;
}

obc_hexmesh_options filled_by(Filling& filling) {
  obc_hexmesh_options options = few();
  options.cells = 8;
  options.fill = fill_cube;
  options.fill_user = &filling;
  return options;
}

}  // namespace

TEST_CASE("A surface goes along frames by a filling function, and not without one") {
  const Cube cube;
  Filling filling{&cube};
  obc_hexmesh_options options = filled_by(filling);
  obc_hexmesh_report report{};
  report.struct_size = sizeof report;
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  for (const int method : {OBC_HEXMESH_METHOD_FRAMES, OBC_HEXMESH_METHOD_AUTO}) {
    options.method = method;
    const obc_status status = obc_hexmesh_compute(&cube.surface, &options, nullptr, &report, &hexes, &error);
    CAPTURE(std::string(error.message));
    REQUIRE(status == OBC_OK);
    CHECK(report.method == OBC_HEXMESH_METHOD_FRAMES);
    CHECK(report.fields > 0);
    CHECK(obc_hexmesh_count(hexes) == 8);
    obc_hexmesh_destroy(hexes);
  }
  CHECK(filling.calls == 2);
  CHECK(filling.max_volume > 0);
  options.fill = nullptr;
  REQUIRE(obc_hexmesh_compute(&cube.surface, &options, nullptr, &report, &hexes, &error) == OBC_OK);
  CHECK(report.method == OBC_HEXMESH_METHOD_POLYCUBE);
  CHECK(report.fields == 0);
  obc_hexmesh_destroy(hexes);
  options.method = OBC_HEXMESH_METHOD_FRAMES;
  CHECK(obc_hexmesh_compute(&cube.surface, &options, nullptr, &report, &hexes, &error) == OBC_UNSUPPORTED);
}

TEST_CASE("Errors of a filling function are passed on, and what it makes is checked") {
  const Cube cube;
  Filling filling{&cube, OBC_NOT_CLOSED, "not-closed"};
  const obc_hexmesh_options options = filled_by(filling);
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  CHECK(obc_hexmesh_compute(&cube.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_NOT_CLOSED);
  CHECK(std::string(error.kind) == "not-closed");
  CHECK(std::string(error.message) == "refused");
  filling.kind = "no word of ours";
  filling.status = OBC_NO_VALID_RESULT;
  CHECK(obc_hexmesh_compute(&cube.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_NO_VALID_RESULT);
  filling.status = OBC_OK;
  filling.move = 0.25;
  CHECK(obc_hexmesh_compute(&cube.surface, &options, nullptr, nullptr, &hexes, &error) == OBC_NO_VALID_RESULT);
  CHECK(std::string(error.message).find("moved vertices") != std::string::npos);
}

TEST_CASE("Each allocation that fails, and each report that cancels, ends hexahedra of a filled surface") {
  const Cube cube;
  Filling filling{&cube};
  const obc_hexmesh_options options = filled_by(filling);
  const test::Call call = test::destroying(obc_hexmesh_destroy, [&](const obc_host* host, obc_hexmesh** out) {
    return obc_hexmesh_compute(&cube.surface, &options, host, nullptr, out, nullptr);
  });
  test::check_failing_allocations(call, 200);
  test::check_cancelling(call);
}
