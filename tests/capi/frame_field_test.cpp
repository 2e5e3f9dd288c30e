// The C functions of frame_field: what they promise about arguments, memory, cancelling and threads. What fields are
// worth is tested in tests/frame_field/.
#include "orbicube/frame_field.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>

#include "failing_allocations.h"

using namespace orbicube;

namespace {

struct Solid {
  std::vector<double> positions;
  std::vector<std::uint32_t> tetrahedra;

  obc_frame_field_solid view() const {
    return {positions.data(), positions.size() / 3, tetrahedra.data(), tetrahedra.size() / 4};
  }
  std::vector<double> identity() const {
    std::vector<double> frames(tetrahedra.size(), 0.0);
    for (std::size_t i = 0; i < frames.size(); i += 4)
      frames[i] = 1;
    return frames;
  }
};

// A box of n^3 cubes, each cut into six positive tetrahedra, bent towards a ball.
Solid bent_box(std::uint32_t n) {
  Solid solid;
  const auto at = [&](std::array<std::uint32_t, 3> p) { return (p[0] * (n + 1) + p[1]) * (n + 1) + p[2]; };
  for (std::uint32_t v = 0; v < (n + 1) * (n + 1) * (n + 1); ++v) {
    const double x = 2.0 * (v / ((n + 1) * (n + 1))) / n - 1, y = 2.0 * (v / (n + 1) % (n + 1)) / n - 1,
                 z = 2.0 * (v % (n + 1)) / n - 1;
    const double longest = std::max({std::abs(x), std::abs(y), std::abs(z)}), length = std::hypot(x, y, z);
    const double scale = length > 0 ? 0.3 + 0.7 * longest / length : 1;
    solid.positions.insert(solid.positions.end(), {scale * x, scale * y, scale * z});
  }
  for (std::uint32_t cube = 0; cube < n * n * n; ++cube) {
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
      std::array<std::uint32_t, 3> p{cube / (n * n), cube / n % n, cube % n};
      std::array<std::uint32_t, 4> t{};
      t[0] = at(p);
      for (std::size_t k = 0; k < 3; ++k) {
        ++p[order[k]];
        t[k + 1] = at(p);
      }
      // Odd orders of the axes give negative ones.
      const std::size_t inversions = (order[0] > order[1]) + (order[0] > order[2]) + (order[1] > order[2]);
      if (inversions % 2 == 1) std::swap(t[2], t[3]);
      solid.tetrahedra.insert(solid.tetrahedra.end(), t.begin(), t.end());
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return solid;
}

obc_status compute(const Solid& solid, const obc_host* host, std::vector<double>& frames) {
  const obc_frame_field_solid view = solid.view();
  return obc_frame_field_compute(&view, nullptr, nullptr, host, frames.data(), nullptr, nullptr);
}

}  // namespace

TEST_CASE("A field computed through C is aligned, and its report agrees with measuring it again") {
  const Solid solid = bent_box(5);
  const obc_frame_field_solid view = solid.view();
  std::vector<double> frames(solid.tetrahedra.size());
  obc_frame_field_report report, again;
  obc_error error;
  REQUIRE(obc_frame_field_report_init(&report, sizeof report) == OBC_OK);
  REQUIRE(obc_frame_field_report_init(&again, sizeof again) == OBC_OK);
  REQUIRE(obc_frame_field_compute(&view, nullptr, nullptr, nullptr, frames.data(), &report, &error) == OBC_OK);
  CHECK(error.status == OBC_OK);
  CHECK(report.one_face_max < 1e-6);
  CHECK(report.several_best_max < 45);  // half way between two normals of one tetrahedron at most
  CHECK(report.symmetric_max <= 62.80);
  CHECK(report.dead_ends == 0);
  CHECK(report.boundary_index_quarters == 4 * report.euler_characteristic);
  CHECK(report.euler_characteristic == 2);
  for (std::size_t i = 0; i < frames.size(); i += 4)
    CHECK(std::abs(std::hypot(std::hypot(frames[i], frames[i + 1]), std::hypot(frames[i + 2], frames[i + 3])) - 1) <
          1e-14);
  REQUIRE(obc_frame_field_measure(&view, frames.data(), nullptr, &again, &error) == OBC_OK);
  CHECK(again.energy == report.energy);
  CHECK(again.singular_edges == report.singular_edges);
  CHECK(again.curves == report.curves);

  obc_frame_field_singularities* singularities = nullptr;
  REQUIRE(obc_frame_field_singularities_create(&view, frames.data(), nullptr, &singularities, &error) == OBC_OK);
  const std::size_t edges = obc_frame_field_singular_edge_count(singularities);
  const std::size_t curves = obc_frame_field_singular_curve_count(singularities);
  CHECK(edges == report.singular_edges);
  CHECK(curves == report.curves);
  CHECK(obc_frame_field_singular_node_count(singularities) == report.nodes);
  std::vector<std::uint32_t> vertices(2 * edges), curve_edges(edges);
  std::vector<std::uint8_t> rotations(edges);
  std::vector<std::int8_t> turns(edges);
  std::vector<std::size_t> begin(curves + 1);
  REQUIRE(obc_frame_field_singularities_copy(singularities, vertices.data(), rotations.data(), turns.data(),
                                             begin.data(), curve_edges.data(), nullptr, &error) == OBC_OK);
  CHECK(begin.back() == edges);
  for (const std::uint8_t r : rotations)
    CHECK((r > 0 && r < 24));
  std::sort(curve_edges.begin(), curve_edges.end());
  for (std::uint32_t e = 0; e < edges; ++e)
    CHECK(curve_edges[e] == e);
  const std::size_t wrong_edges = obc_frame_field_unmeshable_edge_count(singularities);
  const std::size_t wrong_vertices = obc_frame_field_unmeshable_vertex_count(singularities);
  CHECK(wrong_edges == report.improper_edges);
  CHECK(wrong_vertices == report.turning_points + report.improper_nodes);
  CHECK((report.locally_meshable == 1) == (wrong_edges + wrong_vertices == 0));
  std::vector<std::uint32_t> edge_list(wrong_edges), vertex_list(wrong_vertices);
  REQUIRE(obc_frame_field_unmeshable_copy(singularities, edge_list.data(), vertex_list.data(), &error) == OBC_OK);
  for (const std::uint32_t e : edge_list)
    CHECK((e < edges && turns[e] != 1 && turns[e] != -1));
  CHECK(std::is_sorted(vertex_list.begin(), vertex_list.end()));
  for (const std::uint32_t v : vertex_list)
    CHECK(std::find(vertices.begin(), vertices.end(), v) != vertices.end());
  obc_frame_field_singularities_destroy(singularities);
  obc_frame_field_singularities_destroy(nullptr);
  CHECK(obc_frame_field_unmeshable_edge_count(nullptr) == 0);
  CHECK(obc_frame_field_singular_edge_count(nullptr) == 0);

  std::vector<std::uint8_t> matchings(solid.tetrahedra.size());
  CHECK(obc_frame_field_matchings(&view, frames.data(), nullptr, matchings.data(), &error) == OBC_OK);
  CHECK(*std::max_element(matchings.begin(), matchings.end()) < 24);
}

TEST_CASE("Constraints and a given start are followed") {
  const Solid solid = bent_box(4);
  const obc_frame_field_solid view = solid.view();
  std::vector<double> frames = solid.identity();
  obc_frame_field_options options;
  obc_frame_field_constraints constraints;
  REQUIRE(obc_frame_field_options_init(&options, sizeof options) == OBC_OK);
  REQUIRE(obc_frame_field_constraints_init(&constraints, sizeof constraints) == OBC_OK);
  options.start = OBC_FRAME_FIELD_GIVEN;
  options.align_boundary = 0;
  REQUIRE(obc_frame_field_compute(&view, &options, nullptr, nullptr, frames.data(), nullptr, nullptr) == OBC_OK);
  CHECK(frames == solid.identity());

  const std::array<std::uint32_t, 2> which{3, 77};
  const double c = std::cos(0.2), s = std::sin(0.2);
  const std::array<double, 8> held{c, s, 0, 0, 1, 0, 0, 0};
  constraints.frame_tetrahedra = which.data();
  constraints.frames = held.data();
  constraints.frame_count = 2;
  REQUIRE(obc_frame_field_compute(&view, &options, &constraints, nullptr, frames.data(), nullptr, nullptr) == OBC_OK);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(frames[4 * which[i] + k] == doctest::Approx(held[4 * i + k]).epsilon(1e-14));
  }
}

TEST_CASE("Repairs through C leave fewer unmeshable places and report both energies") {
  const Solid solid = bent_box(7);
  const obc_frame_field_solid view = solid.view();
  std::vector<double> frames(solid.tetrahedra.size());
  obc_frame_field_options options;
  obc_frame_field_report plain, repaired;
  obc_frame_field_options_init(&options, sizeof options);
  obc_frame_field_report_init(&plain, sizeof plain);
  obc_frame_field_report_init(&repaired, sizeof repaired);
  // Smoothing alone leaves a wild field with faults everywhere.
  options.start = OBC_FRAME_FIELD_GIVEN;
  std::vector<double> wild(frames.size());
  for (std::size_t i = 0; i < wild.size(); i += 4) {
    const double a = std::sin(static_cast<double>(i * i)), b = 3 * std::cos(static_cast<double>(i * 7));
    wild[i] = std::cos(a) * std::cos(b);
    wild[i + 1] = std::cos(a) * std::sin(b);
    wild[i + 2] = std::sin(a) * std::cos(3 * b);
    wild[i + 3] = std::sin(a) * std::sin(3 * b);
  }
  frames = wild;
  REQUIRE(obc_frame_field_compute(&view, &options, nullptr, nullptr, frames.data(), &plain, nullptr) == OBC_OK);
  const std::uint64_t before = plain.improper_edges + plain.turning_points + plain.improper_nodes;
  REQUIRE(before > 0);
  CHECK(plain.repair_rounds == 0);
  for (const std::int32_t mode : {OBC_FRAME_FIELD_REPAIR, OBC_FRAME_FIELD_SINGLE_AXIS}) {
    options.repair = mode;
    frames = wild;
    REQUIRE(obc_frame_field_compute(&view, &options, nullptr, nullptr, frames.data(), &repaired, nullptr) == OBC_OK);
    CHECK(repaired.repair_rounds > 0);
    CHECK(repaired.unmeshable_before == before);
    CHECK(repaired.fragments_before == plain.fragments);
    CHECK(repaired.energy_before_repair == doctest::Approx(plain.energy).epsilon(1e-9));
    CHECK(repaired.improper_edges + repaired.turning_points + repaired.improper_nodes < before);
    CHECK(repaired.one_face_max < 1e-6);
    CHECK(repaired.dead_ends == 0);
  }
}

TEST_CASE("Weights make constraints soft") {
  const Solid solid = bent_box(3);
  const obc_frame_field_solid view = solid.view();
  obc_frame_field_options options;
  obc_frame_field_constraints constraints;
  obc_frame_field_options_init(&options, sizeof options);
  obc_frame_field_constraints_init(&constraints, sizeof constraints);
  options.align_boundary = 0;
  options.start = OBC_FRAME_FIELD_GIVEN;
  const std::array<std::uint32_t, 2> which{0, 100};
  const double c = std::cos(0.1), s = std::sin(0.1);
  const std::array<double, 8> wanted{c, s, 0, 0, 1, 0, 0, 0};
  std::array<double, 2> weights{1, std::numeric_limits<double>::infinity()};
  constraints.frame_tetrahedra = which.data();
  constraints.frames = wanted.data();
  constraints.frame_count = 2;
  constraints.frame_weights = weights.data();
  std::vector<double> frames = solid.identity();
  REQUIRE(obc_frame_field_compute(&view, &options, &constraints, nullptr, frames.data(), nullptr, nullptr) == OBC_OK);
  CHECK(frames[400] == doctest::Approx(1).epsilon(1e-14));  // held
  CHECK(frames[1] > 0.01);                                  // pulled at
  CHECK(frames[1] < 0.99 * s);
  weights[0] = -1;
  CHECK(obc_frame_field_compute(&view, &options, &constraints, nullptr, frames.data(), nullptr, nullptr) ==
        OBC_INVALID_ARGUMENT);
}

TEST_CASE("Wrong arguments are refused, not followed") {
  const Solid solid = bent_box(2);
  obc_frame_field_solid view = solid.view();
  std::vector<double> frames = solid.identity();
  obc_error error;
  CHECK(obc_frame_field_compute(nullptr, nullptr, nullptr, nullptr, frames.data(), nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_frame_field_compute(&view, nullptr, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(std::strlen(error.message) > 0);
  CHECK(obc_frame_field_measure(&view, frames.data(), nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_frame_field_matchings(&view, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_frame_field_singularities_create(&view, frames.data(), nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_frame_field_singularities_copy(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  view.tetrahedron_count = 0;
  CHECK(obc_frame_field_compute(&view, nullptr, nullptr, nullptr, frames.data(), nullptr, &error) ==
        OBC_INVALID_ARGUMENT);

  Solid wrong = solid;
  wrong.tetrahedra[5] = static_cast<std::uint32_t>(solid.positions.size());
  CHECK(compute(wrong, nullptr, frames) == OBC_INVALID_ARGUMENT);
  wrong = solid;
  wrong.tetrahedra[1] = wrong.tetrahedra[0];
  CHECK(compute(wrong, nullptr, frames) == OBC_DEGENERATE);
  wrong = solid;
  std::swap(wrong.tetrahedra[0], wrong.tetrahedra[1]);
  CHECK(compute(wrong, nullptr, frames) == OBC_NOT_MANIFOLD);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    wrong = solid;
    wrong.positions[7] = bad;
    CHECK(compute(wrong, nullptr, frames) == OBC_INVALID_ARGUMENT);
    std::vector<double> field = solid.identity();
    field[9] = bad;
    view = solid.view();
    std::vector<std::uint8_t> matchings(solid.tetrahedra.size());
    CHECK(obc_frame_field_matchings(&view, field.data(), nullptr, matchings.data(), &error) == OBC_INVALID_ARGUMENT);
  }
  CHECK(frames == solid.identity());  // nothing was written

  view = solid.view();
  obc_frame_field_options options;
  CHECK(obc_frame_field_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  for (int i = 0; i < 7; ++i) {
    REQUIRE(obc_frame_field_options_init(&options, sizeof options) == OBC_OK);
    if (i == 0) options.start = 77;
    if (i == 1) options.method = -1;
    if (i == 2) options.weighting = 9;
    if (i == 3) options.relative_gain = std::numeric_limits<double>::quiet_NaN();
    if (i == 4) options.feature_angle = -1;
    if (i == 5) options.repair = 3;
    if (i == 6) {
      options.repair = OBC_FRAME_FIELD_REPAIR;
      options.method = OBC_FRAME_FIELD_DISSERTATION;
    }
    CHECK(obc_frame_field_compute(&view, &options, nullptr, nullptr, frames.data(), nullptr, &error) ==
          OBC_INVALID_ARGUMENT);
  }
}

TEST_CASE("Each allocation fails in turn and nothing is leaked") {
  const Solid solid = bent_box(2);
  const obc_frame_field_solid view = solid.view();
  std::vector<double> frames = solid.identity();
  obc_frame_field_options options;
  obc_frame_field_options_init(&options, sizeof options);
  options.rounds = 1;
  const test::Outcome computing = test::fail_each_allocation([&](const obc_host& host) {
    return obc_frame_field_compute(&view, &options, nullptr, &host, frames.data(), nullptr, nullptr);
  });
  CHECK(computing.problem == "");
  CHECK(computing.runs > 50);
  options.rounds = 0;
  options.start = OBC_FRAME_FIELD_IDENTITY;
  options.repair = OBC_FRAME_FIELD_SINGLE_AXIS;
  const test::Outcome repairing = test::fail_each_allocation([&](const obc_host& host) {
    return obc_frame_field_compute(&view, &options, nullptr, &host, frames.data(), nullptr, nullptr);
  });
  CHECK(repairing.problem == "");
  CHECK(repairing.runs > 50);
  frames = solid.identity();
  CHECK(test::fail_each_allocation([&](const obc_host& host) {
          obc_frame_field_report report;
          obc_frame_field_report_init(&report, sizeof report);
          return obc_frame_field_measure(&view, frames.data(), &host, &report, nullptr);
        }).problem == "");
  CHECK(test::fail_each_allocation([&](const obc_host& host) {
          obc_frame_field_singularities* out = nullptr;
          const obc_status status = obc_frame_field_singularities_create(&view, frames.data(), &host, &out, nullptr);
          obc_frame_field_singularities_destroy(out);
          return status;
        }).problem == "");
}

TEST_CASE("A field is cancelled at each of its reports") {
  const Solid solid = bent_box(6);
  std::vector<double> frames = solid.identity();
  const test::Outcome outcome =
      test::cancel_everywhere([&](const obc_host& host) { return compute(solid, &host, frames); }, 8);
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 5);
}

TEST_CASE("Fields are the same bits on any number of threads and beside other fields") {
  const Solid solid = bent_box(9);
  obc_host host;
  obc_host_init(&host, sizeof host);
  host.thread_count = 1;
  std::vector<double> alone(solid.tetrahedra.size());
  REQUIRE(compute(solid, &host, alone) == OBC_OK);
  std::array<std::vector<double>, 2> frames;
  std::vector<std::thread> threads;
  for (std::uint32_t i = 0; i < 2; ++i) {
    threads.emplace_back([&, i] {
      obc_host own = host;
      own.thread_count = i + 2;
      frames[i].resize(alone.size());
      compute(solid, &own, frames[i]);
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  for (const auto& field : frames)
    CHECK(std::memcmp(field.data(), alone.data(), alone.size() * sizeof(double)) == 0);
}
