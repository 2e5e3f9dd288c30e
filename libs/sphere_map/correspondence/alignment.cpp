#include "sphere_map/correspondence/alignment.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/rotations.h"
#include "sphere_map/sampling/locator.h"

namespace orbicube::sphere_map {

Matrix3 best_rotation(std::span<const Vector3> from, std::span<const Vector3> to) {
  if (from.size() != to.size() || from.empty()) {
    throw base::Error("invalid-argument", base::counted(from.size(), "direction is", "directions are") +
                                              " to be turned onto " + std::to_string(to.size()));
  }
  Matrix3 sum = Matrix3::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) {
    require_direction(from[i], "direction", i);
    require_direction(to[i], "goal of direction", i);
    sum += to[i].stableNormalized() * from[i].stableNormalized().transpose() / static_cast<double>(from.size());
  }
  // A touch of the identity decides what pairs along one line do not.
  constexpr double along_a_line = 1e-6, touch = 1e-9;
  if (Eigen::JacobiSVD<Matrix3>(sum).singularValues()[1] < along_a_line) sum += touch * Matrix3::Identity();
  return mesh::nearest_rotation(sum);
}

Alignment::Alignment(const Matrix3& rotation) : rotation_(rotation), still_(rotation == Matrix3::Identity()) {
  const double error = (rotation * rotation.transpose() - Matrix3::Identity()).norm();
  if (!(error < 1e-9) || !(rotation.determinant() > 0))
    throw base::Error("invalid-argument", "the matrix is no rotation");
}

void Alignment::add_warp(std::span<const Vector3> from, std::span<const Vector3> to, const base::Host& host) {
  Array<Vector3> turned(host.memory);
  turned.reserve(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    require_direction(from[i], "landmark", i);
    turned.push_back(rotation_ * from[i].stableNormalized());
  }
  warp_ = std::make_shared<const SphereWarp>(turned, to, host);
}

Vector3 Alignment::to_common(const Vector3& direction) const {
  const Vector3 turned = still_ ? direction : Vector3((rotation_ * direction).normalized());
  return warp_ ? warp_->forward(turned) : turned;
}

Vector3 Alignment::from_common(const Vector3& direction) const {
  const Vector3 turned = warp_ ? warp_->backward(direction) : direction;
  return still_ ? turned : Vector3((rotation_.transpose() * turned).normalized());
}

}  // namespace orbicube::sphere_map
