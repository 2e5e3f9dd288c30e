#include "untangle/triangles/planar_triangles.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "untangle/foldover.h"

namespace orbicube::untangle {

TriangleDerivatives differentiate(const Eigen::Matrix2d& jacobian, double eps, double lambda) {
  const Eigen::Matrix2d& j = jacobian;
  const double d = j.determinant();
  const auto [x, root] = chi_of(d, eps);
  // chi' / chi. Not 1 / root, which differs in the last bits.
  const double t = x / root / x, squares = j.squaredNorm();
  const Eigen::Vector4d a(j(0, 0), j(0, 1), j(1, 0), j(1, 1));
  const Eigen::Vector4d c(j(1, 1), -j(1, 0), -j(0, 1), j(0, 0));
  const double q = t * t * squares + lambda * ((1 - d * t) * (1 - d * t) + t * t);
  return {a / x + (lambda * d / x - 0.5 * (squares + lambda * (d * d + 1)) * t / x) * c,
          (Eigen::Matrix4d::Identity() - t * (c * a.transpose() + a * c.transpose()) + q * c * c.transpose()) / x};
}

void PlanarTriangles::clear() {
  variables.clear();
  signs.clear();
  hats.clear();
  weights.clear();
}

void PlanarTriangles::add(const std::array<Vector3, 3>& space, const std::array<Index, 6>& coordinates,
                          const std::array<double, 6>& sign, double whole_area, double min_area) {
  // Slivers are widened a little, so that their hat functions stay finite.
  constexpr double min_height = 1e-7;
  const Vector3 first = space[1] - space[0], second = space[2] - space[0];
  const double longest =
      std::sqrt(std::max({first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm(), 1e-300}));
  const double base = std::max(first.norm(), min_height * longest);
  const double along = first.norm() > 0 ? second.dot(first) / first.norm() : 0;
  const double height = std::max(first.cross(second).norm() / base, min_height * longest);
  const Vector2d at_1(1 / base, -along / (base * height)), at_2(0, 1 / height);
  variables.push_back(coordinates);
  signs.push_back(sign);
  hats.push_back({Vector2d(-at_1 - at_2), at_1, at_2});
  weights.push_back(std::max(0.5 * base * height, min_area) / whole_area);
}

double PlanarTriangles::energy(std::span<const double> values, double lambda, double eps) const {
  double sum = 0;
  for (std::size_t t = 0; t < size(); ++t) {
    const Eigen::Matrix2d j = jacobian(values, t);
    const double d = j.determinant();
    if (eps <= 0 && !(d > 0)) return std::numeric_limits<double>::infinity();
    sum += weights[t] * 0.5 * (j.squaredNorm() + lambda * (d * d + 1)) / chi_of(d, eps).value;
  }
  return sum;
}

}  // namespace orbicube::untangle
