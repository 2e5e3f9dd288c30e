// Regions of solids through the C functions of hexmesh.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "failing_allocations.h"
#include "orbicube/hexmesh.h"

namespace {

// A box of two cubes of eight, each in six tetrahedra around a diagonal; the regions meet at x = 1.
struct TwoCubes {
  TwoCubes() {
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          positions.insert(positions.end(), {0.5 * i, 0.5 * j, 0.5 * k});
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k)
          add_cube({i, j, k});
  }

  void add_cube(const std::array<int, 3>& at) {
    std::array<std::size_t, 3> order = {0, 1, 2};
    bool even = true;  // permutations in this order are even, odd, odd, even, even, odd
    int number = 0;
    do {
      std::array<int, 3> corner = at;
      std::array<std::uint32_t, 4> t = {vertex(corner), 0, 0, 0};
      for (std::size_t d = 0; d < 3; ++d) {
        ++corner[order[d]];
        t[d + 1] = vertex(corner);
      }
      even = number == 0 || number == 3 || number == 4;
      if (!even) std::swap(t[2], t[3]);
      tetrahedra.insert(tetrahedra.end(), t.begin(), t.end());
      regions.push_back(at[0] < 2 ? 11 : -2);
      ++number;
    } while (std::next_permutation(order.begin(), order.end()));
  }

  static std::uint32_t vertex(const std::array<int, 3>& at) {
    return static_cast<std::uint32_t>((3 * at[0] + at[1]) * 3 + at[2]);
  }

  obc_hexmesh_options options() const {
    obc_hexmesh_options o;
    REQUIRE(obc_hexmesh_options_init(&o, sizeof o) == OBC_OK);
    o.cells = 100;
    o.method = OBC_HEXMESH_METHOD_POLYCUBE;
    o.regions = regions.data();
    o.region_count = regions.size();
    return o;
  }

  obc_status compute(const obc_hexmesh_options& o, const obc_host* host, obc_hexmesh_report* report, obc_hexmesh** out,
                     obc_error* error) const {
    return obc_hexmesh_compute_solid(positions.data(), positions.size() / 3, tetrahedra.data(), tetrahedra.size() / 4,
                                     nullptr, &o, host, report, out, error);
  }

  std::vector<double> positions;
  std::vector<std::uint32_t> tetrahedra;
  std::vector<std::int32_t> regions;
};

}  // namespace

TEST_CASE("Each hexahedron has the number of its region, and none is in two") {
  const TwoCubes solid;
  const obc_hexmesh_options options = solid.options();
  obc_hexmesh_report report{};
  report.struct_size = sizeof report;
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  REQUIRE_MESSAGE(solid.compute(options, nullptr, &report, &hexes, &error) == OBC_OK, error.message);
  CHECK(report.conforming == 1);
  CHECK(report.region_quads > 0);
  CHECK(report.region_hausdorff_percent < 1e-9);
  std::vector<double> positions(3 * obc_hexmesh_vertex_count(hexes));
  std::vector<std::uint32_t> hexahedra(8 * obc_hexmesh_count(hexes));
  std::vector<std::int32_t> regions(obc_hexmesh_count(hexes));
  REQUIRE(obc_hexmesh_copy(hexes, positions.data(), hexahedra.data(), nullptr, nullptr, &error) == OBC_OK);
  REQUIRE(obc_hexmesh_copy_regions(hexes, regions.data(), &error) == OBC_OK);
  std::size_t left = 0;
  double beyond = 0;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    CHECK((regions[i] == 11 || regions[i] == -2));
    left += regions[i] == 11 ? 1 : 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const double x = positions[3 * hexahedra[8 * i + k]];
      beyond = std::max(beyond, regions[i] == 11 ? x - 1 : 1 - x);
    }
  }
  CHECK(left > 0);
  CHECK(left < regions.size());
  CHECK(beyond < 1e-12);
  CHECK(obc_hexmesh_copy_regions(hexes, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_hexmesh_copy_regions(nullptr, regions.data(), &error) == OBC_INVALID_ARGUMENT);
  obc_hexmesh_destroy(hexes);
}

TEST_CASE("Regions of the wrong number are refused, and meshes without have 0 for all hexahedra") {
  const TwoCubes solid;
  obc_hexmesh_options options = solid.options();
  obc_hexmesh* hexes = nullptr;
  obc_error error;
  options.region_count = 5;
  CHECK(solid.compute(options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  CHECK(std::string(error.message).find("region_count") != std::string::npos);
  options.region_count = solid.regions.size();
  options.regions = nullptr;
  CHECK(solid.compute(options, nullptr, nullptr, &hexes, &error) == OBC_INVALID_ARGUMENT);
  options.region_count = 0;
  REQUIRE(solid.compute(options, nullptr, nullptr, &hexes, &error) == OBC_OK);
  std::vector<std::int32_t> regions(obc_hexmesh_count(hexes), 5);
  CHECK(obc_hexmesh_copy_regions(hexes, regions.data(), &error) == OBC_OK);
  CHECK(regions == std::vector<std::int32_t>(regions.size(), 0));
  obc_hexmesh_destroy(hexes);
}

TEST_CASE("With regions, too, failing allocations and cancels lose and leak nothing") {
  const TwoCubes solid;
  const obc_hexmesh_options options = solid.options();
  const auto call = [&](const obc_host& host) {
    obc_hexmesh* hexes = nullptr;
    const obc_status status = solid.compute(options, &host, nullptr, &hexes, nullptr);
    obc_hexmesh_destroy(hexes);
    return status;
  };
  const orbicube::test::Outcome failing = orbicube::test::fail_each_allocation(call, 200);
  CHECK_MESSAGE(failing.problem.empty(), failing.problem);
  const orbicube::test::Outcome cancelled = orbicube::test::cancel_everywhere(call);
  CHECK_MESSAGE(cancelled.problem.empty(), cancelled.problem);
}
