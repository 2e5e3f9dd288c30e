#include "polycube/surface/alignment.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "base/random.h"

namespace orbicube::polycube {
namespace {

constexpr int starts = 150;
constexpr int refinements = 150;
constexpr std::size_t max_normals = 4000;

// Uniform over all rotations (Shoemake 1992).
Eigen::Matrix3d random_rotation(base::Random& random) {
  const double a = random.unit(), b = 2 * std::numbers::pi * random.unit(), c = 2 * std::numbers::pi * random.unit();
  return Eigen::Quaterniond(std::sqrt(a) * std::cos(c), std::sqrt(1 - a) * std::sin(b), std::sqrt(1 - a) * std::cos(b),
                            std::sqrt(a) * std::sin(c))
      .normalized()
      .toRotationMatrix();
}

// Of R and what the rotations of the cube make of it, the one nearest to the identity.
Eigen::Matrix3d nearest_to_identity(const Eigen::Matrix3d& r) {
  Eigen::Matrix3d best = r;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (x == y) continue;
      for (int signs = 0; signs < 4; ++signs) {
        Eigen::Matrix3d turn;
        turn.row(0) = (signs & 1 ? -1 : 1) * Eigen::RowVector3d::Unit(x);
        turn.row(1) = (signs & 2 ? -1 : 1) * Eigen::RowVector3d::Unit(y);
        turn.row(2) = turn.row(0).cross(turn.row(1));
        if ((turn * r).trace() > best.trace()) best = turn * r;
      }
    }
  }
  return best;
}

}  // namespace

Eigen::Matrix3d best_alignment(const Surface& surface, std::uint64_t seed, const base::Host& host) {
  const std::size_t stride = (surface.triangles.size() + max_normals - 1) / max_normals;
  Array<Vector3> normals(host.memory);
  for (std::size_t i = 0; i < surface.triangles.size(); i += stride)
    normals.push_back(surface.areas[i] * surface.normals[i]);
  const auto sum_of = [&](const Eigen::Matrix3d& r) {
    host.report("alignment", 0, 0);
    double sum = 0;
    for (const Vector3& n : normals)
      sum += (r * n).lpNorm<1>();
    return sum;
  };
  base::Random random(seed);
  Eigen::Matrix3d best = Eigen::Matrix3d::Identity();
  double least = 0.99 * sum_of(best);
  for (int i = 0; i < starts; ++i) {
    const Eigen::Matrix3d r = random_rotation(random);
    const double sum = sum_of(r);
    if (sum >= least) continue;
    least = sum;
    best = r;
  }
  double angle = 0.3;
  for (int i = 0; i < refinements; ++i) {
    const Vector3 axis(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
    const Eigen::Matrix3d r = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix() * best;
    const double sum = sum_of(r);
    if (sum < least) {
      least = sum;
      best = r;
    }
    angle *= 0.98;
  }
  return nearest_to_identity(best);
}

}  // namespace orbicube::polycube
