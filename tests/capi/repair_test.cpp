// The C functions of repair: what they promise about arguments, memory, cancelling and threads. What repaired surfaces
// are worth is tested in tests/repair/.
#include "orbicube/repair.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "failing_allocations.h"
#include "shapes.h"

using namespace orbicube;
using test::octahedron, test::Shape;

namespace {

// Two octahedra that touch at a vertex, one of them with a hole, a flipped face, a copy of a face, a degenerate face
// and a corner torn off; and a vertex in no face.
Shape damaged() {
  Shape shape = octahedron;
  for (std::size_t i = 0; i < 18; ++i)
    shape.positions.push_back(octahedron.positions[i] + (i % 3 == 0 ? 2 : 0));
  for (const std::uint32_t v : octahedron.triangles)
    shape.triangles.push_back(v == 1 ? 0 : v + 6);
  shape.positions.insert(shape.positions.end(), {9, 9, 9, 0, 1, 0});
  std::vector<std::uint32_t>& t = shape.triangles;
  t.erase(t.begin(), t.begin() + 3);
  std::swap(t[1], t[2]);
  t[9] = 13;  // at the place of vertex 2 is another
  t.insert(t.end(), {3, 1, 5, 4, 4, 1});
  return shape;
}

obc_repair_report report_of(const obc_repair* repaired) {
  obc_repair_report report;
  REQUIRE(obc_repair_report_init(&report, sizeof report) == OBC_OK);
  REQUIRE(obc_repair_get_report(repaired, &report, nullptr) == OBC_OK);
  return report;
}

}  // namespace

TEST_CASE("A damaged surface comes back closed, with figures, places and sources") {
  const Shape shape = damaged();
  const obc_surface surface = shape.surface();
  obc_repair_options options;
  REQUIRE(obc_repair_options_init(&options, sizeof options) == OBC_OK);
  options.keep_parts = 0;
  obc_repair* repaired = nullptr;
  obc_error error;
  REQUIRE(obc_repair_compute(&surface, &options, nullptr, &repaired, &error) == OBC_OK);
  const obc_repair_report report = report_of(repaired);
  CHECK(report.struct_size == sizeof report);
  CHECK(report.changed == 1);
  CHECK(report.closed == 1);
  CHECK(report.manifold == 1);
  CHECK(report.oriented == 1);
  CHECK(report.parts == 2);
  CHECK(report.genus == 0);
  CHECK(report.volume == doctest::Approx(8.0 / 3).epsilon(1e-14));
  CHECK(report.duplicate_faces == 1);
  CHECK(report.degenerate_faces == 1);
  CHECK(report.contact_vertices == 1);
  CHECK(report.filled_holes == 1);
  CHECK(report.reversed_triangles == 1);
  CHECK(report.welded_vertices == 1);
  const std::size_t vertices = obc_repair_vertex_count(repaired), triangles = obc_repair_triangle_count(repaired),
                    events = obc_repair_event_count(repaired);
  CHECK(vertices == 12);
  CHECK(triangles == 16);
  std::vector<double> positions(3 * vertices), places(3 * events), sizes(events);
  std::vector<std::uint32_t> corners(3 * triangles), vertex_source(vertices), triangle_source(triangles),
      counts(events);
  std::vector<std::int32_t> actions(events);
  REQUIRE(obc_repair_copy(repaired, positions.data(), corners.data(), vertex_source.data(), triangle_source.data(),
                          &error) == OBC_OK);
  REQUIRE(obc_repair_copy_events(repaired, actions.data(), counts.data(), places.data(), sizes.data(), &error) ==
          OBC_OK);
  CHECK(obc_repair_copy(repaired, nullptr, nullptr, nullptr, nullptr, &error) == OBC_OK);
  CHECK(obc_repair_copy_events(repaired, nullptr, nullptr, nullptr, nullptr, &error) == OBC_OK);
  std::size_t made = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    REQUIRE(vertex_source[v] < shape.positions.size() / 3);
    CHECK(std::memcmp(&positions[3 * v], &shape.positions[3 * vertex_source[v]], 3 * sizeof(double)) == 0);
  }
  for (const std::uint32_t source : triangle_source)
    made += source == UINT32_MAX;
  CHECK(made == 1);
  for (std::size_t i = 0; i < events; ++i)
    CHECK(std::string(obc_repair_action_name(actions[i])) != "unknown");
  CHECK(std::string(obc_repair_action_name(OBC_REPAIR_FILLED_HOLE)) == "filled-hole");
  CHECK(std::string(obc_repair_action_name(-1)) == "unknown");
  CHECK(std::string(obc_repair_action_name(13)) == "unknown");
  obc_repair_destroy(repaired);
}

TEST_CASE("A clean surface comes back bit for bit") {
  const obc_surface surface = octahedron.surface();
  obc_repair* repaired = nullptr;
  REQUIRE(obc_repair_compute(&surface, nullptr, nullptr, &repaired, nullptr) == OBC_OK);
  CHECK(report_of(repaired).changed == 0);
  CHECK(obc_repair_event_count(repaired) == 0);
  std::vector<double> positions(18);
  std::vector<std::uint32_t> triangles(24);
  REQUIRE(obc_repair_copy(repaired, positions.data(), triangles.data(), nullptr, nullptr, nullptr) == OBC_OK);
  CHECK(positions == octahedron.positions);
  CHECK(triangles == octahedron.triangles);
  obc_repair_destroy(repaired);
}

TEST_CASE("Wrong arguments are refused, not followed") {
  const obc_surface surface = octahedron.surface();
  obc_repair* repaired = nullptr;
  obc_error error;
  CHECK(obc_repair_compute(nullptr, nullptr, nullptr, &repaired, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_repair_compute(&surface, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_repair_copy(nullptr, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_repair_copy_events(nullptr, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_repair_get_report(nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_repair_options_init(nullptr, sizeof(obc_repair_options)) == OBC_INVALID_ARGUMENT);
  CHECK(obc_repair_report_init(nullptr, sizeof(obc_repair_report)) == OBC_INVALID_ARGUMENT);
  CHECK(obc_repair_vertex_count(nullptr) + obc_repair_triangle_count(nullptr) + obc_repair_event_count(nullptr) == 0);
  obc_repair_destroy(nullptr);
  obc_repair_options options;
  const auto refused = [&](auto member, double value) {
    obc_repair_options_init(&options, sizeof options);
    options.*member = value;
    return obc_repair_compute(&surface, &options, nullptr, &repaired, &error) == OBC_INVALID_ARGUMENT;
  };
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1.0}) {
    CHECK(refused(&obc_repair_options::weld_distance, bad));
    CHECK(refused(&obc_repair_options::sliver_ratio, bad));
    CHECK(refused(&obc_repair_options::sliver_move, bad));
    CHECK(refused(&obc_repair_options::t_junction_distance, bad));
    CHECK(refused(&obc_repair_options::contact_gap, bad));
    CHECK(refused(&obc_repair_options::min_area_percent, bad));
    CHECK(refused(&obc_repair_options::max_handle_length, bad));
    CHECK(refused(&obc_repair_options::wrap_offset, bad));
  }
  Shape wrong = octahedron;
  wrong.triangles[5] = 6;
  obc_surface s = wrong.surface();
  CHECK(obc_repair_compute(&s, nullptr, nullptr, &repaired, &error) == OBC_INVALID_ARGUMENT);
  wrong = octahedron;
  wrong.positions[4] = std::numeric_limits<double>::quiet_NaN();
  s = wrong.surface();
  CHECK(obc_repair_compute(&s, nullptr, nullptr, &repaired, &error) == OBC_INVALID_ARGUMENT);
  s = octahedron.surface();
  s.triangle_count = 0;
  CHECK(obc_repair_compute(&s, nullptr, nullptr, &repaired, &error) == OBC_MALFORMED_FILE);
  CHECK(repaired == nullptr);
}

TEST_CASE("Handles are cut, and parts wrapped, as the options request") {
  obc_mesh* mesh = nullptr;
  obc_surface torus;
  REQUIRE(obc_mesh_make("torus", 1000, 0, nullptr, &mesh, nullptr) == OBC_OK);
  REQUIRE(obc_mesh_surface(mesh, &torus, nullptr) == OBC_OK);
  obc_repair_options options;
  REQUIRE(obc_repair_options_init(&options, sizeof options) == OBC_OK);
  for (const std::int32_t genus : {-1, 0, 1}) {
    options.max_genus = genus;
    obc_repair* repaired = nullptr;
    REQUIRE(obc_repair_compute(&torus, &options, nullptr, &repaired, nullptr) == OBC_OK);
    const obc_repair_report report = report_of(repaired);
    CHECK(report.cut_handles == (genus == 0 ? 1 : 0));
    CHECK(report.genus == (genus == 0 ? 0 : 1));
    obc_repair_destroy(repaired);
  }
  options.max_genus = -1;
  options.wrap_offset = 0.1;
  obc_repair* wrapped = nullptr;
  REQUIRE(obc_repair_compute(&torus, &options, nullptr, &wrapped, nullptr) == OBC_OK);
  const obc_repair_report report = report_of(wrapped);
  CHECK(report.closed + report.manifold + report.oriented == 3);
  CHECK(report.self_intersections == 0);
  CHECK(report.genus == 1);
  obc_repair_destroy(wrapped);
  obc_mesh_destroy(mesh);
}

TEST_CASE("Each allocation that fails ends in out of memory") {
  const Shape shape = damaged();
  const obc_surface surface = shape.surface();
  obc_repair_options options;
  REQUIRE(obc_repair_options_init(&options, sizeof options) == OBC_OK);
  options.max_genus = 0;
  options.wrap_offset = 1;
  constexpr std::size_t each_until = 300;  // of some thousands; from there on every seventh
  const test::Outcome outcome = test::fail_each_allocation(
      [&](const obc_host& host) {
        obc_repair* repaired = nullptr;
        const obc_status status = obc_repair_compute(&surface, &options, &host, &repaired, nullptr);
        obc_repair_destroy(repaired);
        return status;
      },
      each_until);
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 20);
}

TEST_CASE("Each progress report may cancel") {
  const Shape shape = damaged();
  const obc_surface surface = shape.surface();
  obc_repair_options options;
  REQUIRE(obc_repair_options_init(&options, sizeof options) == OBC_OK);
  options.max_genus = 0;
  options.wrap_offset = 0.5;
  const test::Outcome outcome = test::cancel_everywhere([&](const obc_host& host) {
    obc_repair* repaired = nullptr;
    const obc_status status = obc_repair_compute(&surface, &options, &host, &repaired, nullptr);
    obc_repair_destroy(repaired);
    return status;
  });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 5);
}

TEST_CASE("A label's surface comes with figures; mistakes, memory, cancelling and threads are as everywhere") {
  // Label 3: a block with a tunnel along z; label 4: a voxel.
  const std::array<std::size_t, 3> size = {9, 8, 7};
  std::vector<std::int32_t> labels(9 * 8 * 7, 0);
  for (std::size_t z = 1; z < 6; ++z) {
    for (std::size_t y = 1; y < 7; ++y) {
      for (std::size_t x = 1; x < 7; ++x)
        labels[x + 9 * (y + 8 * z)] = x == 2 && y == 3 ? 0 : 3;
    }
  }
  labels[8] = 4;
  const std::array<double, 16> to_world = {0, 0, 2, 5, 1, 0, 0, 6, 0, 1, 0, 7, 0, 0, 0, 1};
  obc_repair_label_options options;
  REQUIRE(obc_repair_label_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.max_slide == 0.45);
  options.label = 3;
  obc_repair* made = nullptr;
  obc_error error;
  const auto compute = [&](const obc_host* host) {
    return obc_repair_surface_of_label(labels.data(), size.data(), to_world.data(), &options, host, &made, &error);
  };
  REQUIRE(compute(nullptr) == OBC_OK);
  obc_repair_label_report figures;
  REQUIRE(obc_repair_label_report_init(&figures, sizeof figures) == OBC_OK);
  REQUIRE(obc_repair_get_label_report(made, &figures, nullptr) == OBC_OK);
  CHECK(figures.label == 3);
  CHECK(figures.voxels == 36 * 5 - 5);
  CHECK(figures.handles == 1);
  CHECK(figures.added_voxels + figures.removed_voxels > 0);
  const obc_repair_report report = report_of(made);
  CHECK(report.closed == 1);
  CHECK(report.genus == 0);
  CHECK(report.self_intersections == 0);
  CHECK(report.volume > 200);
  const std::size_t vertices = obc_repair_vertex_count(made);
  std::vector<double> positions(3 * vertices), again(3 * vertices);
  std::vector<std::uint32_t> source(vertices);
  REQUIRE(obc_repair_copy(made, positions.data(), nullptr, source.data(), nullptr, nullptr) == OBC_OK);
  CHECK(source[0] == UINT32_MAX);
  for (std::size_t v = 0; v < vertices; ++v) {  // z is first in the world, of spacing 2
    CHECK(std::abs(positions[3 * v] - 11) <= 2 * 3);
    CHECK(std::abs(positions[3 * v + 1] - 9.5) <= 3.5);
  }
  obc_repair_destroy(made);
  // Threads, allocations that fail, cancelling.
  obc_host host;
  REQUIRE(obc_host_init(&host, sizeof host) == OBC_OK);
  host.thread_count = 3;
  REQUIRE(compute(&host) == OBC_OK);
  REQUIRE(obc_repair_copy(made, again.data(), nullptr, nullptr, nullptr, nullptr) == OBC_OK);
  CHECK(positions == again);
  obc_repair_destroy(made);
  host.progress = [](const char*, uint64_t, uint64_t, double, void*) -> std::int32_t { return 1; };
  CHECK(compute(&host) == OBC_CANCELLED);
  CHECK(made == nullptr);
  // Mistakes.
  options.label = 0;
  CHECK(compute(nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(std::string(error.message).find("3 (175 voxels), 4 (1 voxel)") != std::string::npos);
  options.label = 9;
  CHECK(compute(nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_repair_surface_of_label(nullptr, size.data(), nullptr, nullptr, nullptr, &made, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_repair_surface_of_label(labels.data(), nullptr, nullptr, nullptr, nullptr, &made, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_repair_surface_of_label(labels.data(), size.data(), nullptr, nullptr, nullptr, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  const std::array<std::size_t, 3> huge = {SIZE_MAX, 2, 2};
  CHECK(obc_repair_surface_of_label(labels.data(), huge.data(), nullptr, nullptr, nullptr, &made, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(std::string(error.message).find("overflow") != std::string::npos);
  CHECK(obc_repair_get_label_report(nullptr, &figures, nullptr) == OBC_INVALID_ARGUMENT);
}
