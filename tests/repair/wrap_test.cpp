// Surfaces around any triangles.
#include "repair/wrap/wrap.h"

#include <doctest/doctest.h>

#include <numbers>

#include "base/error.h"
#include "damage.h"

using namespace orbicube;
using namespace orbicube::test;

namespace {

void check_wrap(const repair::Repaired& r, std::size_t parts, std::int64_t genus) {
  CHECK(repair::shortcomings(r.report.certificate) == "");
  CHECK(r.report.certificate.is_solid());
  CHECK(r.report.certificate.parts == parts);
  CHECK(r.report.certificate.genus == genus);
  CHECK(r.report.certificate.volume > 0);
}

}  // namespace

TEST_CASE("The wrap of a sphere is one with a radius larger by the offset") {
  const Mesh m = mesh::make_shape("sphere", {.triangles = 2000}, base::Host());
  const double radius = m.positions[0].norm();
  const repair::Repaired r = repaired(m, {.wrap_offset = 0.1});
  check_wrap(r, 1, 0);
  CHECK(r.report.certificate.volume ==
        doctest::Approx(4.0 / 3 * std::numbers::pi * std::pow(radius + 0.1, 3)).epsilon(0.02));
  CHECK(r.report.move.patches < 0.2);
  CHECK(r.report.move.from_input < 0.2);
}

TEST_CASE("Parts that intersect and gaps narrower than twice the offset become one surface") {
  // A cube in three pieces that overlap, without a side, and a plate through them.
  Mesh m = together(cube(), cube({0.5, 0.25, 0.25}));
  m = together(m, cube({0.3, -0.5, 0.1}, 0.9));
  m.triangles.push_back({0, 13, 20});
  m.triangles.erase(m.triangles.begin() + 3);
  CHECK(repaired(m, {.parts = {.keep = 0}}).report.certificate.self_intersections > 0);
  const repair::Repaired r = repaired(m, {.parts = {.keep = 0}, .wrap_offset = 0.03});
  check_wrap(r, 1, 0);
  CHECK(r.report.certificate.volume > 1.5);
  // Two cubes at a distance of 1: apart with a small offset, one part with a large one.
  const Mesh two = together(cube(), cube({1.5, 0, 0}));
  check_wrap(repaired(two, {.parts = {.keep = 0}, .wrap_offset = 0.05}), 2, 0);
  check_wrap(repaired(two, {.parts = {.keep = 0}, .wrap_offset = 0.4}), 1, 0);
  check_wrap(repaired(mesh::make_shape("torus", {.triangles = 1000}, base::Host()), {.wrap_offset = 0.05}), 1, 1);
}

TEST_CASE("Random triangles have a wrap without self-intersection") {
  base::Random random(9);
  Mesh m;
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 3; ++k)
      m.positions.push_back(Vector3(random.unit(), random.unit(), random.unit()));
    const auto v = static_cast<Index>(3 * i);
    m.triangles.push_back({v, v + 1, v + 2});
  }
  const repair::Repaired r = repaired(m, {.fill_holes = false, .wrap_offset = 0.03});
  CHECK(repair::shortcomings(r.report.certificate) == "");
  CHECK(r.report.certificate.is_solid());
}

TEST_CASE("An offset too small for the grid is refused with the smallest") {
  try {
    repaired(cube(), {.wrap_offset = 1e-4});
    FAIL("a grid of 1e12 nodes");
  } catch (const base::Error& e) {
    CHECK(std::string(e.kind()) == "invalid-argument");
    CHECK(std::string(e.what()).find("smallest") != std::string::npos);
  }
}
