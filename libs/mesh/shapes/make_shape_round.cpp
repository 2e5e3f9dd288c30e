// Sphere, blob, star and torus: patches with a formula for their points.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "mesh/shapes/make_shape_kinds.h"
#include "mesh/shapes/quad_patches.h"

namespace orbicube::mesh {
namespace {

using std::numbers::pi;

QuadComplex unit_cube() {
  QuadComplex cube;
  for (int i = 0; i < 8; ++i)
    cube.corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  cube.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return cube;
}

// A surface that every ray from the origin meets once, so that it cannot meet itself: the faces of a cube blown up.
class StarShaped : public PatchSurface {
 public:
  explicit StarShaped(std::function<double(const Vector3&)> radius) : radius_(std::move(radius)) {}

  const QuadComplex& complex() const { return cube_; }

  void select(std::size_t quad) override { quad_ = quad; }

  Vector3 at(double u, double v) const override {
    const Quad& quad = cube_.quads[quad_];
    const Vector3& origin = cube_.corners[quad[0]];
    const Vector3 first = 0.5 * (cube_.corners[quad[1]] - origin);
    const Vector3 last = 0.5 * (cube_.corners[quad[3]] - origin);
    const Vector3 centre = origin + first + last;
    // Equal angles rather than equal lengths: no triangle gets much smaller than another.
    const auto warped = [](double t) { return std::tan(0.25 * pi * (2 * t - 1)); };
    const Vector3 direction = (centre + warped(u) * first + warped(v) * last).normalized();
    return radius_(direction) * direction;
  }

 private:
  QuadComplex cube_ = unit_cube();
  std::function<double(const Vector3&)> radius_;
  std::size_t quad_ = 0;
};

Mesh make_star_shaped(std::function<double(const Vector3&)> radius, const ShapeOptions& options,
                      const base::Host& host) {
  StarShaped surface(std::move(radius));
  const std::vector<double> lengths(4 * surface.complex().quads.size(), 1.0);
  return mesh_patches(surface.complex(), surface, lengths, options.triangles, host);
}

Vector3 random_direction(Random& random) {
  for (;;) {
    // One after the other: compilers differ in which argument of a call comes first.
    const double z = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const Vector3 v(random.uniform(-1, 1), y, z);
    const double norm = v.norm();
    if (norm > 0.1 && norm <= 1) return v / norm;
  }
}

struct Bump {
  Vector3 direction;
  double height;
  double sharpness;

  double at(const Vector3& d) const { return height * std::exp(sharpness * (direction.dot(d) - 1)); }
};

}  // namespace

Mesh make_sphere(const ShapeOptions& options, const base::Host& host) {
  return make_star_shaped([](const Vector3&) { return 1.0; }, options, host);
}

Mesh make_blob(const ShapeOptions& options, const base::Host& host) {
  Random random(options.seed);
  std::vector<Bump> bumps(static_cast<std::size_t>(random.whole(12, 30)));
  for (Bump& bump : bumps)
    bump = {random_direction(random), random.uniform(-0.45, 0.45), random.uniform(4, 25)};
  return make_star_shaped(
      [&](const Vector3& d) {
        double logarithm = 0;
        for (const Bump& bump : bumps)
          logarithm += bump.at(d);
        return std::exp(logarithm);
      },
      options, host);
}

Mesh make_star(const ShapeOptions& options, const base::Host& host) {
  Random random(options.seed);
  // Directions far from one another: of a few tries, the one farthest from those that are there.
  std::vector<Bump> spikes;
  const int count = random.whole(8, 20);
  while (static_cast<int>(spikes.size()) < count) {
    Vector3 best;
    double nearest = 2;
    for (int attempt = 0; attempt < 20; ++attempt) {
      const Vector3 candidate = random_direction(random);
      double cosine = -1;
      for (const Bump& spike : spikes)
        cosine = std::max(cosine, spike.direction.dot(candidate));
      if (cosine >= nearest) continue;
      nearest = cosine;
      best = candidate;
    }
    spikes.push_back({best, random.uniform(0.5, 1.5), random.uniform(25, 60)});
  }
  return make_star_shaped(
      [&](const Vector3& d) {
        double radius = 0.6;
        for (const Bump& spike : spikes)
          radius += spike.at(d);
        return radius;
      },
      options, host);
}

Mesh make_torus(const ShapeOptions& options, const base::Host& host) {
  constexpr Index around = 4;  // patches each way; with three or more, no two share two sides
  class Torus : public PatchSurface {
   public:
    Torus(double radius, double wave, int waves) : radius_(radius), wave_(wave), waves_(waves) {}
    void select(std::size_t quad) override { quad_ = quad; }
    Vector3 at(double u, double v) const override {
      const double a = 2 * pi * (static_cast<double>(quad_ / around) + u) / around;
      const double b = 2 * pi * (static_cast<double>(quad_ % around) + v) / around;
      const double thickness = radius_ * (1 + wave_ * std::sin(waves_ * a));
      const double distance = 1 + thickness * std::cos(b);
      return {distance * std::cos(a), distance * std::sin(a), thickness * std::sin(b)};
    }

   private:
    double radius_, wave_;
    int waves_;
    std::size_t quad_ = 0;
  };

  Random random(options.seed);
  const double radius = options.seed == 0 ? 0.35 : random.uniform(0.15, 0.6);
  const double wave = options.seed == 0 ? 0 : random.uniform(0, 0.3);
  Torus torus(radius, wave, random.whole(2, 6));
  QuadComplex complex;
  const auto corner = [](Index i, Index j) { return (i % around) * around + j % around; };
  std::vector<double> lengths;
  for (Index i = 0; i < around; ++i) {
    for (Index j = 0; j < around; ++j) {
      complex.quads.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
      lengths.insert(lengths.end(), {1, radius, 1, radius});
      torus.select(complex.quads.size() - 1);
      complex.corners.push_back(torus.at(0, 0));
    }
  }
  return mesh_patches(complex, torus, lengths, options.triangles, host);
}

}  // namespace orbicube::mesh
