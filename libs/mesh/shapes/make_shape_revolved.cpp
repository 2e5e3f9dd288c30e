// Solids of revolution: a profile turned about the z axis, closed by flat discs.
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "mesh/shapes/make_shape_kinds.h"
#include "mesh/shapes/quad_patches.h"

namespace orbicube::mesh {
namespace {

using std::numbers::pi;

// Each disc is a square with four patches around it; four more go round the side.
class Revolved : public PatchSurface {
 public:
  // The radius at heights from 0 to `height`.
  Revolved(double height, std::function<double(double)> radius) : height_(height), radius_(std::move(radius)) {
    for (const Index top : {0U, 1U}) {
      for (const double part : {inner, 1.0}) {
        for (int k = 0; k < 4; ++k)
          complex_.corners.push_back(on_circle(part, k, top == 1 ? height_ : 0));
      }
    }
    const auto corner = [](Index top, Index outer, Index k) { return 8 * top + 4 * outer + k % 4; };
    constexpr int pieces = 32;
    double slant = 0;
    for (int i = 0; i < pieces; ++i)
      slant += std::hypot(height_ / pieces, radius_(height_ * (i + 1) / pieces) - radius_(height_ * i / pieces));
    for (const Index top : {0U, 1U}) {
      const double r = radius_(top == 1 ? height_ : 0);
      if (top == 1)
        complex_.quads.push_back({corner(1, 0, 0), corner(1, 0, 1), corner(1, 0, 2), corner(1, 0, 3)});
      else
        complex_.quads.push_back({corner(0, 0, 3), corner(0, 0, 2), corner(0, 0, 1), corner(0, 0, 0)});
      const double side = inner * std::numbers::sqrt2 * r;
      lengths_.insert(lengths_.end(), 4, side);
      for (Index k = 0; k < 4; ++k) {
        if (top == 1)
          complex_.quads.push_back({corner(1, 1, k), corner(1, 1, k + 1), corner(1, 0, k + 1), corner(1, 0, k)});
        else
          complex_.quads.push_back({corner(0, 0, k), corner(0, 0, k + 1), corner(0, 1, k + 1), corner(0, 1, k)});
        const double arc = 0.5 * pi * r, spoke = (1 - inner) * r;
        lengths_.insert(lengths_.end(), {top == 1 ? arc : side, spoke, top == 1 ? side : arc, spoke});
      }
    }
    for (Index k = 0; k < 4; ++k) {
      complex_.quads.push_back({corner(0, 1, k), corner(0, 1, k + 1), corner(1, 1, k + 1), corner(1, 1, k)});
      lengths_.insert(lengths_.end(), {0.5 * pi * radius_(0), slant, 0.5 * pi * radius_(height_), slant});
    }
  }

  Mesh make(const ShapeOptions& options, const base::Host& host) {
    return mesh_patches(complex_, *this, lengths_, options.triangles, host);
  }

  void select(std::size_t quad) override { quad_ = quad; }

  Vector3 at(double u, double v) const override {
    if (quad_ >= 10) return on_circle(1, static_cast<double>(quad_ - 10) + u, v == 1 ? height_ : v * height_);
    const auto& q = complex_.quads[quad_];
    const auto corner = [&](std::size_t k) -> const Vector3& { return complex_.corners[q[k]]; };
    const double z = quad_ >= 5 ? height_ : 0;
    Vector3 p = (1 - v) * ((1 - u) * corner(0) + u * corner(1)) + v * ((1 - u) * corner(3) + u * corner(2));
    if (quad_ % 5 != 0) {
      // One side is an arc: the lower ones of the upper disc, the upper ones of the lower disc.
      const double angle = static_cast<double>(quad_ % 5 - 1) + u;
      const bool upper = quad_ >= 5;
      const Vector3 straight =
          upper ? Vector3((1 - u) * corner(0) + u * corner(1)) : Vector3((1 - u) * corner(3) + u * corner(2));
      p += (upper ? 1 - v : v) * (on_circle(1, angle, z) - straight);
    }
    p[2] = z;
    return p;
  }

 private:
  static constexpr double inner = 0.5;

  // At a part of the radius; angles in quarters, from a corner of the square.
  Vector3 on_circle(double part, double quarters, double z) const {
    const double angle = 0.5 * pi * quarters + 0.25 * pi, r = part * radius_(z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

  double height_;
  std::function<double(double)> radius_;
  QuadComplex complex_;
  std::vector<double> lengths_;
  std::size_t quad_ = 0;
};

}  // namespace

Mesh make_cylinder(const ShapeOptions& options, const base::Host& host) {
  Random random(options.seed);
  const double height = options.seed == 0 ? 2 : random.uniform(0.8, 3);
  const double radius = options.seed == 0 ? 0.8 : random.uniform(0.4, 1);
  return Revolved(height, [=](double) { return radius; }).make(options, host);
}

Mesh make_vase(const ShapeOptions& options, const base::Host& host) {
  Random random(options.seed);
  const double wave = options.seed == 0 ? 0.2 : random.uniform(0.08, 0.3);
  const double phase = options.seed == 0 ? 0.6 : random.uniform(0, 2 * pi);
  const double waves = options.seed == 0 ? 1 : random.uniform(0.6, 1.6);
  return Revolved(2, [=](double z) { return 0.7 * (1 + wave * std::sin(phase + waves * pi * z)); }).make(options, host);
}

}  // namespace orbicube::mesh
