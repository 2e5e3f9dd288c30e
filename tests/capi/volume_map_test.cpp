// The C functions of volume_map: what they promise about arguments, memory, cancelling and threads. What the maps are
// worth is tested in tests/volume_map/.
#include "orbicube/volume_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "failing_allocations.h"

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

  obc_volume_map_tangle tangle() const {
    obc_volume_map_tangle t;
    REQUIRE(obc_volume_map_tangle_init(&t, sizeof t) == OBC_OK);
    t.positions = start.data();
    t.vertex_count = start.size() / 3;
    t.tetrahedra = tetrahedra.data();
    t.tetrahedron_count = tetrahedra.size() / 4;
    t.rest = rest.data();
    t.fixed = fixed.data();
    return t;
  }
};

}  // namespace

TEST_CASE("A tangled box is untangled, in place too, and the report says how") {
  Box box;
  obc_volume_map_tangle tangle = box.tangle();
  std::vector<double> result(box.start.size());
  obc_volume_map_untangle_report report;
  REQUIRE(obc_volume_map_untangle_report_init(&report, sizeof report) == OBC_OK);
  obc_error error;
  REQUIRE(obc_volume_map_untangle(&tangle, nullptr, nullptr, result.data(), &report, &error) == OBC_OK);
  CHECK(report.inverted_before > 0);
  CHECK(report.inverted == 0);
  CHECK(report.first_inverted == UINT32_MAX);
  CHECK(report.steps > 0);
  CHECK(report.least_determinant > 0);
  CHECK(report.greatest_determinant >= report.least_determinant);
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
  REQUIRE(obc_volume_map_untangle(&tangle, nullptr, nullptr, box.start.data(), nullptr, &error) == OBC_OK);
  CHECK(box.start == result);
}

TEST_CASE("Ties and options reach the method") {
  const Box box;
  obc_volume_map_tangle tangle = box.tangle();
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
  tangle.ties = ties.data();
  std::vector<double> result(box.start.size());
  REQUIRE(obc_volume_map_untangle(&tangle, nullptr, nullptr, result.data(), nullptr, nullptr) == OBC_OK);
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
  CHECK(obc_volume_map_untangle(&tangle, &options, nullptr, result.data(), &report, &error) == OBC_NO_VALID_RESULT);
  CHECK(report.inverted == report.inverted_before);
  CHECK(std::string(error.kind) == "no-valid-result");
  CHECK(std::string(error.message).find(std::to_string(report.inverted)) != std::string::npos);
  CHECK(std::equal(result.begin(), result.end(), box.start.begin()));
}

TEST_CASE("Wrong arguments are answered, not followed") {
  const Box box;
  const obc_volume_map_tangle tangle = box.tangle();
  std::vector<double> result(box.start.size(), 99);
  obc_error error;
  CHECK(obc_volume_map_untangle(nullptr, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_volume_map_untangle(&tangle, nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_volume_map_tangle wrong = tangle;
  wrong.positions = nullptr;
  CHECK(obc_volume_map_untangle(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  wrong = tangle;
  wrong.vertex_count = 5;
  CHECK(obc_volume_map_untangle(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_MALFORMED_FILE);
  CHECK(std::string(error.kind) == "index-range");
  wrong = tangle;
  wrong.vertex_count = static_cast<std::size_t>(-1);
  CHECK(obc_volume_map_untangle(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  const std::vector<std::uint32_t> ties(box.start.size(), static_cast<std::uint32_t>(box.start.size()));
  wrong = tangle;
  wrong.ties = ties.data();
  CHECK(obc_volume_map_untangle(&wrong, nullptr, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_volume_map_untangle_options options;
  REQUIRE(obc_volume_map_untangle_options_init(&options, sizeof options) == OBC_OK);
  options.volume_weight = std::numeric_limits<double>::quiet_NaN();
  CHECK(obc_volume_map_untangle(&tangle, &options, nullptr, result.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_volume_map_untangle_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  CHECK(std::count(result.begin(), result.end(), 99) == static_cast<std::ptrdiff_t>(result.size()));
}

TEST_CASE("Each allocation that fails ends in out of memory") {
  const Box box;
  const obc_volume_map_tangle tangle = box.tangle();
  std::vector<double> result(box.start.size());
  const test::Outcome outcome = test::fail_each_allocation([&](const obc_host& host) {
    return obc_volume_map_untangle(&tangle, nullptr, &host, result.data(), nullptr, nullptr);
  });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 10);
}

TEST_CASE("Each progress report may cancel") {
  const Box box;
  const obc_volume_map_tangle tangle = box.tangle();
  std::vector<double> result(box.start.size());
  const test::Outcome outcome = test::cancel_everywhere([&](const obc_host& host) {
    return obc_volume_map_untangle(&tangle, nullptr, &host, result.data(), nullptr, nullptr);
  });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 3);
}
