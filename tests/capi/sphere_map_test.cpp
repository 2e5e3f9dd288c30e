// The C functions of sphere_map: what they promise about arguments, memory, cancelling and threads. What the maps are
// worth is tested in tests/sphere_map/.
#include "orbicube/sphere_map.h"

#include <doctest/doctest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <map>
#include <thread>
#include <utility>
#include <vector>

#include "failing_allocations.h"
#include "shapes.h"

using namespace orbicube;
using test::Shape;

namespace {

// An octahedron, each triangle split in four `levels` times, stretched along z with a bump.
Shape stretched_octahedron(int levels) {
  Shape shape = test::octahedron;
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [entry, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(shape.positions.size() / 3));
      if (is_new) {
        for (std::size_t k = 0; k < 3; ++k) {
          shape.positions.push_back((shape.positions[3 * a + k] + shape.positions[3 * b + k]) / 2);
        }
      }
      return entry->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t t = 0; t < shape.triangles.size(); t += 3) {
      const std::uint32_t a = shape.triangles[t];
      const std::uint32_t b = shape.triangles[t + 1];
      const std::uint32_t c = shape.triangles[t + 2];
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    shape.triangles = finer;
  }
  for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
    double* p = &shape.positions[i];
    p[2] = 2 * p[2] + 0.5 * std::exp(-10 * ((p[0] - 0.5) * (p[0] - 0.5) + p[1] * p[1]));
  }
  return shape;
}

// Stops at a report.
struct Stop {
  std::size_t at = std::numeric_limits<std::size_t>::max();
  std::size_t reports = 0;

  obc_host host() {
    obc_host result;
    obc_host_init(&result, sizeof result);
    result.thread_count = 1;
    result.progress = [](const char*, std::uint64_t, std::uint64_t, double, void* user) -> std::int32_t {
      auto& stop = *static_cast<Stop*>(user);
      return stop.reports++ >= stop.at ? 1 : 0;
    };
    result.progress_user = this;
    return result;
  }
};

struct TracePoint {
  std::uint64_t iterations, vertices;
  double energy;
};

obc_status compute(const Shape& shape, const obc_host* host, double* directions, obc_error* error = nullptr) {
  const obc_surface surface = shape.surface();
  return obc_sphere_map_compute(&surface, nullptr, host, directions, nullptr, error);
}

}  // namespace

TEST_CASE("A map computed through C is a bijection and its report agrees with measuring it again") {
  const Shape shape = stretched_octahedron(3);
  const obc_surface surface = shape.surface();
  std::vector<double> directions(shape.positions.size());
  obc_sphere_map_report report;
  obc_sphere_map_report measured;
  obc_error error;
  REQUIRE(obc_sphere_map_report_init(&report, sizeof report) == OBC_OK);
  REQUIRE(obc_sphere_map_report_init(&measured, sizeof measured) == OBC_OK);
  REQUIRE(obc_sphere_map_compute(&surface, nullptr, nullptr, directions.data(), &report, &error) == OBC_OK);
  CHECK(error.status == OBC_OK);
  CHECK(report.bijective == 1);
  CHECK(report.flipped == 0);
  for (std::size_t i = 0; i < directions.size(); i += 3) {
    CHECK(std::hypot(directions[i], directions[i + 1], directions[i + 2]) == doctest::Approx(1).epsilon(1e-15));
  }
  REQUIRE(obc_sphere_map_measure(&surface, directions.data(), nullptr, nullptr, &measured, &error) == OBC_OK);
  CHECK(measured.bijective == 1);
  CHECK(measured.energy == doctest::Approx(report.energy).epsilon(1e-12));

  std::vector<float> rounded(directions.size());
  const std::uint32_t nowhere[] = {0, 1, static_cast<std::uint32_t>(surface.vertex_count)};
  const obc_surface broken = {surface.positions, surface.vertex_count, nowhere, 1};
  CHECK(obc_sphere_map_round_to_float(&broken, directions.data(), nullptr, rounded.data(), &error) ==
        OBC_INVALID_ARGUMENT);
  REQUIRE(obc_sphere_map_round_to_float(&surface, directions.data(), nullptr, rounded.data(), &error) == OBC_OK);
  const std::vector<double> again(rounded.begin(), rounded.end());
  REQUIRE(obc_sphere_map_measure(&surface, again.data(), nullptr, nullptr, &measured, &error) == OBC_OK);
  CHECK(measured.bijective == 1);
}

TEST_CASE("Wrong arguments are refused, not followed") {
  const Shape shape = stretched_octahedron(1);
  std::vector<double> directions(shape.positions.size());
  obc_error error;
  obc_surface surface = shape.surface();
  CHECK(obc_sphere_map_compute(nullptr, nullptr, nullptr, directions.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_compute(&surface, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  surface.positions = nullptr;
  CHECK(obc_sphere_map_compute(&surface, nullptr, nullptr, directions.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(error.status == OBC_INVALID_ARGUMENT);
  CHECK(std::strlen(error.message) > 0);

  Shape wrong = shape;
  wrong.triangles[4] = static_cast<std::uint32_t>(shape.positions.size());
  CHECK(compute(wrong, nullptr, directions.data()) == OBC_INVALID_ARGUMENT);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    wrong = shape;
    wrong.positions[7] = bad;
    CHECK(compute(wrong, nullptr, directions.data()) == OBC_INVALID_ARGUMENT);
  }
  wrong = shape;
  wrong.triangles.resize(wrong.triangles.size() - 3);
  CHECK(compute(wrong, nullptr, directions.data()) == OBC_NOT_CLOSED);

  obc_sphere_map_options options;
  CHECK(obc_sphere_map_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  REQUIRE(obc_sphere_map_options_init(&options, sizeof options) == OBC_OK);
  options.method = 1000;
  surface = shape.surface();
  CHECK(obc_sphere_map_compute(&surface, &options, nullptr, directions.data(), nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
}

TEST_CASE("A map that is stopped leaves what there is of it, with no triangle flipped") {
  const Shape shape = stretched_octahedron(3);
  const obc_surface surface = shape.surface();
  const std::vector<double> untouched(shape.positions.size(), 7);
  std::vector<double> whole(shape.positions.size());
  std::size_t placed = 0;
  obc_error error;
  Stop never;
  obc_host host = never.host();
  REQUIRE(obc_sphere_map_compute_partial(&surface, nullptr, &host, whole.data(), &placed, nullptr, &error) == OBC_OK);
  CHECK(placed == surface.vertex_count);
  std::vector<double> plain(shape.positions.size());
  REQUIRE(compute(shape, nullptr, plain.data()) == OBC_OK);
  CHECK(whole == plain);

  std::size_t before = 0;
  bool partly = false, all = false;
  for (std::size_t i = 0; i < 16; ++i) {
    Stop stop{i * (never.reports - 1) / 15};  // the last one too
    host = stop.host();
    std::vector<double> directions = untouched;
    const obc_status status =
        obc_sphere_map_compute_partial(&surface, nullptr, &host, directions.data(), &placed, nullptr, &error);
    // Some reports are made by time: another run may have fewer, and end before the last ones.
    CHECK(status == (stop.reports > stop.at ? OBC_CANCELLED : OBC_OK));
    CHECK(placed >= before);
    before = placed;
    if (placed == 0) {
      CHECK(directions == untouched);
      continue;
    }
    (placed < surface.vertex_count ? partly : all) = true;
    std::size_t positive = 0;
    for (std::size_t t = 0; t < shape.triangles.size(); t += 3) {
      const auto corner = [&](std::size_t k) { return &directions[3 * std::size_t{shape.triangles[t + k]}]; };
      const std::int32_t sign = obc_mesh_orientation_from_origin(corner(0), corner(1), corner(2));
      CHECK(sign >= 0);
      positive += sign > 0;
    }
    // Those of the mesh as it is refined so far, of genus 0.
    CHECK(positive == 2 * placed - 4);
  }
  CHECK(partly);
  CHECK(all);
  CHECK(obc_sphere_map_compute_partial(&surface, nullptr, nullptr, whole.data(), nullptr, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_map_compute_partial(&surface, nullptr, nullptr, nullptr, &placed, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);
  CHECK(placed == 0);
}

TEST_CASE("The method seed reports its course") {
  const Shape shape = stretched_octahedron(3);
  const obc_surface surface = shape.surface();
  std::vector<TracePoint> points;
  obc_sphere_map_options options;
  REQUIRE(obc_sphere_map_options_init(&options, sizeof options) == OBC_OK);
  CHECK((options.trace == nullptr));
  options.method = OBC_SPHERE_MAP_DISSERTATION;
  options.trace = [](std::uint64_t iterations, std::uint64_t vertices, double energy, void* user) {
    static_cast<std::vector<TracePoint>*>(user)->push_back({iterations, vertices, energy});
  };
  options.trace_user = &points;
  std::vector<double> directions(shape.positions.size()), silent(directions.size());
  obc_sphere_map_report report;
  obc_sphere_map_report_init(&report, sizeof report);
  REQUIRE(obc_sphere_map_compute(&surface, &options, nullptr, directions.data(), &report, nullptr) == OBC_OK);
  REQUIRE(points.size() > 3);
  for (std::size_t i = 1; i < points.size(); ++i) {
    CHECK(points[i].iterations > points[i - 1].iterations);
    CHECK(points[i].vertices >= points[i - 1].vertices);
  }
  CHECK(points.back().vertices == surface.vertex_count);
  CHECK(points.back().energy == doctest::Approx(report.energy).epsilon(1e-9));  // sums in another order

  // A program whose header had no trace: what lies behind its struct is not read.
  options.struct_size = offsetof(obc_sphere_map_options, trace);
  const std::size_t told = points.size();
  REQUIRE(obc_sphere_map_compute(&surface, &options, nullptr, silent.data(), nullptr, nullptr) == OBC_OK);
  CHECK(points.size() == told);
  CHECK(silent == directions);
}

TEST_CASE("Parameters of Algorithm 1 and a weight of zero come through C") {
  const Shape shape = stretched_octahedron(3);
  const obc_surface surface = shape.surface();
  obc_sphere_map_options options;
  REQUIRE(obc_sphere_map_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.level_splits == 40);
  CHECK(options.level_tolerance == 1e-4);
  CHECK(options.final_tolerance == 1e-4);
  CHECK(options.max_level_iterations == 0);
  CHECK(options.max_final_iterations == 0);
  options.method = OBC_SPHERE_MAP_DISSERTATION;
  obc_sphere_map_report report;
  obc_sphere_map_report_init(&report, sizeof report);
  const auto map = [&] {
    std::vector<double> directions(shape.positions.size());
    REQUIRE(obc_sphere_map_compute(&surface, &options, nullptr, directions.data(), &report, nullptr) == OBC_OK);
    CHECK(report.bijective == 1);
    CHECK(report.equation_3_4 == report.energy_area);
    CHECK(report.equation_3_1 > 0);
    CHECK(report.equation_3_1 < report.equation_3_3);
    CHECK(report.equation_3_2 < report.equation_3_4);
    return directions;
  };
  const std::vector<double> usual = map();
  options.level_splits = 10;
  CHECK(map() != usual);
  options.angle_weight = 0;
  map();
  CHECK(report.energy == report.energy_area);
  options.struct_size = offsetof(obc_sphere_map_options, level_splits);  // a program with an older header
  options.angle_weight = 0.1;
  CHECK(map() == usual);

  options.struct_size = sizeof options;
  obc_error error;
  for (int wrong = 0; wrong < 5; ++wrong) {
    obc_sphere_map_options_init(&options, sizeof options);
    options.method = OBC_SPHERE_MAP_DISSERTATION;
    if (wrong == 0) options.level_splits = 0;
    if (wrong == 1) options.level_splits = std::numeric_limits<std::uint64_t>::max();
    if (wrong == 2) options.level_tolerance = -1;
    if (wrong == 3) options.final_tolerance = std::numeric_limits<double>::quiet_NaN();
    if (wrong == 4) options.angle_weight = options.area_weight = 0;
    std::vector<double> directions(shape.positions.size());
    CHECK(obc_sphere_map_compute(&surface, &options, nullptr, directions.data(), nullptr, &error) ==
          OBC_INVALID_ARGUMENT);
  }
}

TEST_CASE("Each allocation of a map fails in turn and nothing is leaked") {
  const Shape shape = stretched_octahedron(1);
  const obc_surface surface = shape.surface();
  std::vector<double> directions(shape.positions.size());
  std::vector<float> rounded(directions.size());
  std::vector<double> per_face(surface.triangle_count);
  const test::Outcome computing =
      test::fail_each_allocation([&](const obc_host& host) { return compute(shape, &host, directions.data()); });
  CHECK(computing.problem == "");
  CHECK(computing.runs > 5);
  CHECK(test::fail_each_allocation([&](const obc_host& host) {
          std::size_t placed = 0;
          return obc_sphere_map_compute_partial(&surface, nullptr, &host, directions.data(), &placed, nullptr, nullptr);
        }).problem == "");
  CHECK(test::fail_each_allocation([&](const obc_host& host) {
          obc_sphere_map_report report;
          obc_sphere_map_report_init(&report, sizeof report);
          return obc_sphere_map_measure(&surface, directions.data(), nullptr, &host, &report, nullptr);
        }).problem == "");
  CHECK(test::fail_each_allocation([&](const obc_host& host) {
          return obc_sphere_map_round_to_float(&surface, directions.data(), &host, rounded.data(), nullptr);
        }).problem == "");
  CHECK(test::fail_each_allocation([&](const obc_host& host) {
          return obc_sphere_map_face_distortion(&surface, directions.data(), &host, per_face.data(), nullptr, nullptr);
        }).problem == "");
}

TEST_CASE("A map is cancelled at each of its reports") {
  const Shape shape = stretched_octahedron(4);
  std::vector<double> directions(shape.positions.size());
  const test::Outcome outcome =
      test::cancel_everywhere([&](const obc_host& host) { return compute(shape, &host, directions.data()); }, 8);
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 2);
}

TEST_CASE("Maps are the same bits on any number of threads and beside other maps") {
  const Shape shape = stretched_octahedron(3);
  obc_host host;
  obc_host_init(&host, sizeof host);
  host.thread_count = 1;
  std::vector<double> alone(shape.positions.size());
  REQUIRE(compute(shape, &host, alone.data()) == OBC_OK);

  std::atomic<int> equal{0};
  std::vector<std::thread> threads;
  for (std::uint32_t count = 1; count <= 4; ++count) {
    threads.emplace_back([&, count] {
      obc_host own = host;
      own.thread_count = count;
      std::vector<double> directions(shape.positions.size());
      const bool done = compute(shape, &own, directions.data()) == OBC_OK;
      if (done && std::memcmp(directions.data(), alone.data(), alone.size() * sizeof(double)) == 0) ++equal;
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  CHECK(equal == 4);
}
