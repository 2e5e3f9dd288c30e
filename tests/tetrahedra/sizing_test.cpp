// Lengths that edges should have at places: the field of lengths, and the solids that follow it.
#include "tetrahedra/sizing.h"

#include <cmath>
#include <limits>
#include <random>

#include "shapes.h"

using namespace orbicube;
using namespace orbicube::test;
using mesh::Vector3;
using tetrahedra::SizePoint;

namespace {

std::vector<SizePoint> scattered(std::size_t count, double shortest, double longest) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1), length(shortest, longest);
  std::vector<SizePoint> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({Vector3(place(random), place(random), place(random)), length(random)});
  return points;
}

}  // namespace

TEST_CASE("The length at a place is the least of what all points allow") {
  for (const double growth : {0.0, 0.1, 1.0, 30.0}) {
    auto points = scattered(300, 0.1, 0.5);
    points.insert(points.end(), 20, points.front());  // several at one place
    const tetrahedra::Sizing sizing(points, growth, host.memory);
    for (const SizePoint& from : scattered(200, 1, 1)) {
      const Vector3 place = 3 * from.position;
      double least = std::numeric_limits<double>::infinity();
      for (const SizePoint& p : points)
        least = std::min(least, p.length + growth * (p.position - place).norm());
      // Boxes that a distance just misses by rounding may be passed over.
      CHECK(sizing.length_at(place) == doctest::Approx(least).epsilon(1e-14));
    }
  }
  const tetrahedra::Sizing none({}, 1, host.memory);
  CHECK(none.empty());
  CHECK(none.length_at({1, 2, 3}) == std::numeric_limits<double>::infinity());
}

TEST_CASE("Tetrahedra are small where they should be, and large elsewhere") {
  const Surface surface = made("sphere", 800);
  const Vector3 place(0.2, 0.1, -0.3);
  const std::vector<SizePoint> one = {{place, 0.03}};
  const double growth = 0.4;
  const tetrahedra::Sizing sizing(one, growth, host.memory);
  const tetrahedra::Solid solid = filled(surface, {.sizes = one, .size_growth = growth});
  check_kept(surface, solid);
  std::size_t larger = 0, inner = 0, near = 0;
  for (const mesh::Tetrahedron& t : solid.tetrahedra) {
    const auto& x = solid.positions;
    const Vector3 center = (x[t[0]] + x[t[1]] + x[t[2]] + x[t[3]]) / 4;
    near += (center - place).norm() < 0.25;
    // Beside the surface, which is kept, they are as large as its triangles make them.
    if (std::ranges::min(t) < surface.positions.size()) continue;
    const double length = sizing.length_at(center), largest = length * length * length / (6 * std::sqrt(2.0));
    const double volume = mesh::shape_of(x[t[0]], x[t[1]], x[t[2]], x[t[3]]).volume;
    ++inner;
    larger += volume > largest * (1 + 1e-9);
    CHECK(volume < 3 * largest);
  }
  // TetGen's last step, for better angles, lets some grow again.
  CHECK(static_cast<double>(larger) < 0.05 * static_cast<double>(inner));
  // A ball of that radius has 1.6 % of the volume.
  CHECK(static_cast<double>(near) > 0.2 * static_cast<double>(solid.tetrahedra.size()));
}

TEST_CASE("Lengths at the surface's vertices grade the inside, and the surface stays") {
  const Surface surface = made("sphere", 800);
  std::vector<SizePoint> sizes;
  for (const Vector3& p : surface.positions)
    sizes.push_back({p, p[0] < 0 ? 0.08 : 1.0});
  const tetrahedra::Solid solid = filled(surface, {.sizes = sizes, .size_growth = 0.2});
  check_kept(surface, solid);
  std::size_t left = 0;
  for (std::size_t v = surface.positions.size(); v < solid.positions.size(); ++v)
    left += solid.positions[v][0] < 0;
  // Of volume it is half.
  CHECK(3 * left > 2 * (solid.positions.size() - surface.positions.size()));
}

TEST_CASE("Sizes mean the same at any scale") {
  const Surface surface = made("cube", 200);
  const std::vector<SizePoint> sizes = {{surface.positions[3], 0.05}, {surface.positions[40], 0.1}};
  const tetrahedra::Solid solid = filled(surface, {.sizes = sizes});
  for (const int exponent : {-500, 500}) {
    const double scale = std::ldexp(1.0, exponent);
    Surface other;
    other.add(surface, scale, Vector3::Zero());
    auto scaled = sizes;
    for (SizePoint& size : scaled)
      size = {scale * size.position, scale * size.length};
    CHECK(filled(other, {.sizes = scaled}).tetrahedra == solid.tetrahedra);
  }
}

TEST_CASE("Sizes that mean nothing are refused") {
  const Surface surface = made("cube", 12);
  for (const SizePoint& bad : {SizePoint{{0, 0, 0}, 0.0}, SizePoint{{0, 0, 0}, -1.0},
                               SizePoint{{0, 0, 0}, std::numeric_limits<double>::infinity()},
                               SizePoint{{0, std::numeric_limits<double>::quiet_NaN(), 0}, 1.0}}) {
    const std::vector<SizePoint> sizes = {{{1, 0, 0}, 0.5}, bad};
    CHECK(refusal(surface, {.sizes = sizes}) == "invalid-argument");
  }
  CHECK(refusal(surface, {.size_growth = -1}) == "invalid-argument");
}
