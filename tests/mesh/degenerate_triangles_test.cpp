// Triangles that figures leave out, and powers of two that surfaces are scaled by.
#include "mesh/topology/degenerate_triangles.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "mesh/search/measures.h"
#include "mesh/search/unit_scale.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

constexpr double float_unit = 0x1p-24, double_unit = 0x1p-53;

}  // namespace

TEST_CASE("A triangle is degenerate by its height over its longest side, at any scale") {
  for (const int exponent : {-1000, -500, -240, 0, 240, 500, 1000}) {
    const double s = std::ldexp(1.0, exponent);
    CAPTURE(exponent);
    CHECK(is_degenerate({0, 0, 0}, {s, 0, 0}, {0.25 * s, 0.9e-6 * s, 0}, 0));
    CHECK_FALSE(is_degenerate({0, 0, 0}, {s, 0, 0}, {0.25 * s, 1.1e-6 * s, 0}, 0));
    CHECK(is_degenerate({0, 0, 0}, {s, 0, 0}, {0.5 * s, 0, 0}, 0));
    CHECK(is_degenerate({s, 0, 0}, {s, 0, 0}, {0, s, 0}, 0));  // two corners at one point
    CHECK(is_degenerate({s, s, s}, {s, s, s}, {s, s, s}, 0));
    CHECK_FALSE(is_degenerate({0, 0, 0}, {s, 0, 0}, {0, s, 0}, double_unit));
  }
  const double largest = std::numeric_limits<double>::max();
  CHECK_FALSE(is_degenerate({-largest, 0, 0}, {largest, 0, 0}, {0, largest, -largest}, double_unit));
  CHECK(is_degenerate({-largest, 0, 0}, {largest, 0, 0}, {0, 0, 0}, double_unit));
}

TEST_CASE("A triangle is degenerate by its height over the rounding of its coordinates") {
  // Far from the origin, where the last digit is 2^-13 of the triangle's size.
  const double far = 0x1p40, digit = 0x1p-12;
  CHECK(is_degenerate({far, 0, 0}, {far + 1, 0, 0}, {far + 0.5, digit, 0}, double_unit));
  CHECK_FALSE(is_degenerate({far, 0, 0}, {far + 1, 0, 0}, {far + 0.5, 8 * digit, 0}, double_unit));
  CHECK_FALSE(is_degenerate({0, 0, 0}, {1, 0, 0}, {0.5, digit, 0}, double_unit));
  // The same heights where only float32 was kept.
  CHECK(is_degenerate({100, 0, 0}, {101, 0, 0}, {100.5, 1e-5, 0}, float_unit));
  CHECK_FALSE(is_degenerate({100, 0, 0}, {101, 0, 0}, {100.5, 1e-5, 0}, double_unit));
}

TEST_CASE("The rounding unit is that of the digits which coordinates have, of vertices of triangles alone") {
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  std::vector<Vector3> positions = {{0, 0.5, 3}, {float{0.1F}, 1e10F, 7}, {-2, 4, 1e-30F}, {0.1, 0.2, 0.3}};
  CHECK(rounding_unit(positions, triangles) == float_unit);
  CHECK(rounding_unit(positions) == double_unit);
  for (Vector3& p : positions)
    p *= 0x1p-900;  // beyond the range of float32, with its digits
  CHECK(rounding_unit(positions, triangles) == float_unit);
  positions[1].x() = 0.1;
  CHECK(rounding_unit(positions, triangles) == double_unit);
}

TEST_CASE("Degenerate triangles are counted") {
  const std::vector<Vector3> positions = {{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.7, 0}, {0.15, 0, 0}, {0.15, 1e-9, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {2, 1, 3}};
  CHECK(count_degenerate(positions, triangles) == 2);
  CHECK(count_degenerate(positions, {}) == 0);
}

TEST_CASE("A power of two brings the box of the triangles to a size of 1 to 2") {
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  for (const double size : {1e-300, 1e-10, 0.7, 1.0, 3.0, 1e10, 1e300}) {
    std::vector<Vector3> positions = {{-size, 0, 0}, {size, 0, 0}, {0, 0.3 * size, 0}, {1e5, 7, 7}};
    const int exponent = unit_scale_exponent(positions, triangles);
    std::vector<Vector3> scaled = positions;
    scale_by_power(scaled, exponent);
    const double width = scaled[1].x() - scaled[0].x();
    CAPTURE(size);
    CHECK(width >= 1);
    CHECK(width < 2);
    scale_by_power(scaled, -exponent);
    for (std::size_t v = 0; v < 3; ++v)
      CHECK(scaled[v] == positions[v]);
  }
  const std::vector<Vector3> point(3, Vector3(5, 5, 5));
  CHECK(unit_scale_exponent(point, triangles) == 0);
  CHECK(unit_scale_exponent({}, {}) == 0);
}

TEST_CASE("A mesh of extreme size is brought to a size of 1 to 2, and others stay as they are") {
  for (const double size : {1e-30, 1e-5, 1.0, 1e5, 1e30}) {
    for (const bool solid : {false, true}) {
      Mesh m;
      m.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
      solid ? m.tetrahedra.push_back({0, 1, 2, 3}) : m.triangles.push_back({0, 1, 2});
      const bool extreme = size < 1e-6 || size > 1e6;
      const int exponent = bring_to_unit_size(m);
      CHECK((exponent != 0) == extreme);
      CHECK(m.positions[1].x() == std::ldexp(size, exponent));
      if (extreme) CHECK((m.positions[1].x() >= 1 && m.positions[1].x() < 2));
    }
  }
}

TEST_CASE("Volumes too small for double keep their sign, and too large ones are infinite") {
  const std::vector<Triangle> triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (const double size : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    const std::vector<Vector3> positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
    const Measures m = measures(positions, triangles, base::Host());
    std::vector<Triangle> inward = triangles;
    for (Triangle& t : inward)
      std::swap(t[0], t[1]);
    CAPTURE(size);
    CHECK(m.area > 0);
    CHECK(m.volume > 0);
    CHECK(measures(positions, inward, base::Host()).volume == -m.volume);
    CHECK(std::isinf(m.area) == (size > 1e154));
  }
}

TEST_CASE("Vertices of triangles are distinguished from those of none") {
  const std::vector<Triangle> triangles = {{0, 3, 1}, {3, 1, 4}, {9, 0, 0}};
  const auto used = used_vertices(6, triangles, std::pmr::get_default_resource());
  CHECK(std::vector<int>(used.begin(), used.end()) == std::vector<int>{1, 1, 0, 1, 1, 0});
}
