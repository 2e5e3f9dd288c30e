// Sums of squared distances to planes, weighted by area (Garland and Heckbert 1997), by which both decimations choose.
#pragma once

#include "mesh/mesh.h"

namespace orbicube::polycube {

struct Quadric {  // x'Ax + 2b'x + c
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  mesh::Vector3 b = mesh::Vector3::Zero();
  double c = 0;

  void add_plane(const mesh::Vector3& normal, double offset, double weight) {
    a += weight * normal * normal.transpose();
    b += weight * offset * normal;
    c += weight * offset * offset;
  }
  void add(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
  }
  // Rounding can make it negative.
  double at(const mesh::Vector3& p) const { return p.dot(a * p) + 2 * b.dot(p) + c; }
};

}  // namespace orbicube::polycube
