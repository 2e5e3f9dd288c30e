#include "polycube/layout/scattered_map.h"

#include <Eigen/Dense>
#include <algorithm>

#include "linear/direct/dense_system.h"

namespace orbicube::polycube {
namespace {

bool span_space(std::span<const Vector3> points) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Vector3 mean = Vector3::Zero();
  for (const Vector3& p : points)
    mean += p / static_cast<double>(n);
  for (const Vector3& p : points)
    spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread, Eigen::EigenvaluesOnly);
  return n >= 4 && eigen.eigenvalues()[0] > 1e-6 * eigen.eigenvalues()[2];
}

}  // namespace

ScatteredMap::ScatteredMap(std::span<const Vector3> points, std::span<const Vector3> images, double smoothing,
                           const base::Host& host)
    : points_(host.memory), weights_(host.memory) {
  if (points.empty()) return;
  for (const Vector3& p : points)
    centre_ += p / static_cast<double>(points.size());
  double radius = 0;
  for (const Vector3& p : points)
    radius = std::max(radius, (p - centre_).norm());
  if (radius > 0) scale_ = radius;
  Array<Vector3> target(host.memory);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 p = (points[i] - centre_) / scale_;
    const bool again =
        std::any_of(points_.begin(), points_.end(), [&](const Vector3& q) { return (p - q).norm() < 1e-12; });
    if (again) continue;
    points_.push_back(p);
    target.push_back(images[i] - points[i]);  // what the identity misses
  }
  const auto n = static_cast<Eigen::Index>(points_.size());
  const bool affine = span_space(points_);
  const Eigen::Index more = affine ? 4 : 1;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + more, n + more);
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(n + more, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    host.report("scattered map", static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(n));
    const Vector3& p = points_[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j)
      system(i, j) = -(p - points_[static_cast<std::size_t>(j)]).norm();
    system(i, i) += smoothing;
    system(i, n) = system(n, i) = 1;
    for (Eigen::Index k = 0; k + 1 < more; ++k)
      system(i, n + 1 + k) = system(n + 1 + k, i) = p[k];
    rhs.row(i) = target[static_cast<std::size_t>(i)].transpose();
  }
  const Eigen::MatrixXd solution = linear::solve_dense(system, rhs);
  for (Eigen::Index i = 0; i < n; ++i)
    weights_.push_back(solution.row(i).transpose());
  shift_ = solution.row(n).transpose();
  if (affine) linear_ += solution.bottomRows<3>().transpose() / scale_;
}

Vector3 ScatteredMap::operator()(const Vector3& x) const {
  const Vector3 p = (x - centre_) / scale_;
  Vector3 result = centre_ + linear_ * (x - centre_) + shift_;
  for (std::size_t i = 0; i < points_.size(); ++i)
    result -= (p - points_[i]).norm() * weights_[i];
  return result;
}

Eigen::Matrix3d ScatteredMap::derivative(const Vector3& x) const {
  const Vector3 p = (x - centre_) / scale_;
  Eigen::Matrix3d result = linear_;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vector3 away = p - points_[i];
    if (const double distance = away.norm(); distance > 0)
      result -= weights_[i] * away.transpose() / (distance * scale_);
  }
  return result;
}

}  // namespace orbicube::polycube
