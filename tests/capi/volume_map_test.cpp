// The C functions of volume_map: what they promise about arguments, memory, cancelling and threads. What the maps are
// worth is tested in tests/volume_map/.
#include "orbicube/volume_map.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "boxes.h"
#include "promises.h"

using namespace orbicube;
using test::Box;

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

TEST_CASE("Wrong arguments of solids are refused") {
  const Box solid_box;
  obc_volume_map_solid* solid = nullptr;
  obc_error error;
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
  CHECK(solid == nullptr);
  CHECK(obc_volume_map_solid_copy(nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_volume_map_solid_vertex_count(nullptr) + obc_volume_map_solid_tetrahedron_count(nullptr) == 0);
  obc_volume_map_solid_destroy(nullptr);
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
