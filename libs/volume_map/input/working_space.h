// The coordinates in which a solid is filled with hexahedra: those of the solid itself, unless these are far from 1, or
// it is a straight rod or a plate so thin that equal cells would leave it few across. Such a solid is compressed along
// its length, or stretched along its thickness, filled, and taken back: volumes keep their proportions, and hexahedra
// become as long as the solid requires.
#pragma once

#include <Eigen/Core>
#include <span>

#include "volume_map/types.h"

namespace orbicube::volume_map {

class WorkingSpace {
 public:
  WorkingSpace() = default;
  // For a closed surface, with the size_exponent() of the solid that it is a piece of.
  WorkingSpace(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles, int exponent);

  // Whether coordinates stay as they are, to the bit.
  bool same() const { return exponent_ == 0 && !stretched_; }
  Vector3 to(const Vector3& p) const;
  void take(std::span<Vector3> positions) const {
    if (same()) return;
    for (Vector3& p : positions)
      p = to(p);
  }
  // What to() came from, but for rounding, times 2^-exponent(): in the range of double whatever the solid's size.
  Vector3 back(const Vector3& p) const { return stretched_ ? Vector3(back_ * p + center_) : p; }
  int exponent() const { return exponent_; }

 private:
  int exponent_ = 0;  // of two: the solid's size where that is far from 1
  bool stretched_ = false;
  Vector3 center_ = Vector3::Zero();
  Eigen::Matrix3d to_ = Eigen::Matrix3d::Identity(), back_ = Eigen::Matrix3d::Identity();
};

// The power of two that coordinates are divided by: 0 where products of four of them are in the range of double.
int size_exponent(std::span<const Vector3> positions);

// p times 2^exponent, for any exponent.
Vector3 times_power_of_two(const Vector3& p, int exponent);

}  // namespace orbicube::volume_map
