// Small solids of tetrahedra for tests: cubes.h, and balls, rings and more.
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "frame_field/frame_field.h"
#include "mesh/topology/tetrahedral_connectivity.h"
#include "quaternion/quaternion.h"
#include "quaternion/rotation.h"
#include "tests/mesh/cubes.h"

namespace orbicube::test {

inline Solid ball(Index n) {
  Solid solid = cubes(n, n, n);
  for (Vector3& p : solid.positions) {
    p = p * (2.0 / n) - Vector3::Ones();
    const double longest = p.cwiseAbs().maxCoeff();
    // Less than all the way to the sphere, so that cells along the cube's edges are not flat.
    if (longest > 0) p *= 0.2 + 0.8 * longest / p.norm();
  }
  solid.orient();
  return solid;
}

// A bent bar closed to a ring about the z axis, of square cross section.
inline Solid ring(Index m, Index n) {
  Solid solid = cubes(m, n, n, true);
  for (Vector3& p : solid.positions) {
    const double angle = 2 * std::numbers::pi * p[0] / m, radius = 3 + p[1] / n;
    p = Vector3(radius * std::cos(angle), radius * std::sin(angle), p[2] / n);
  }
  solid.orient();
  return solid;
}

// A bar about the z axis, along which it has vertices.
inline Solid bar() {
  Solid solid = cubes(8, 8, 5);
  for (Vector3& p : solid.positions)
    p -= Vector3(4, 4, 0);
  return solid;
}

// Moves inner and outer vertices a little, so that nothing is regular.
inline Solid shaken(Solid solid, double amount) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> move(-amount, amount);
  for (Vector3& p : solid.positions) {
    for (int c = 0; c < 3; ++c)
      p[c] += move(random);
  }
  return solid;
}

inline frame_field::Outcome computed(const Solid& solid, const frame_field::Options& options = {},
                                     const frame_field::Given& given = {}, const base::Host& host = {}) {
  return frame_field::compute(solid.positions, solid.tetrahedra, options, given, host);
}

inline quaternion::Quaternion random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return quaternion::normalized({w, x, y, z});
}

inline Vector3 rotated(const quaternion::Quaternion& q, const Vector3& p) {
  const quaternion::Vector v = quaternion::rotate(q, {p[0], p[1], p[2]});
  return {v.x, v.y, v.z};
}

// Largest angle in degrees by which frames are off where the boundary wants an axis: along the normal; for a
// tetrahedron with several faces along one of the normals, and where two of them are neither within 5 degrees of each
// other nor of being perpendicular, also between them or along their edge.
inline double off_boundary(const Solid& solid, const mesh::TetrahedralConnectivity& connectivity,
                           std::span<const quaternion::Quaternion> field) {
  const auto sine_to_axes = [](const quaternion::Quaternion& q, const Vector3& direction) {
    double least = 1;
    for (int axis = 0; axis < 3; ++axis)
      least = std::min(least, rotated(q, Vector3::Unit(axis)).cross(direction).norm());
    return least;
  };
  double worst = 0;
  for (Index t = 0; t < solid.tetrahedra.size(); ++t) {
    std::vector<Vector3> normals;
    for (Index k = 0; k < 4; ++k) {
      if (!connectivity.on_boundary(4 * t + k)) continue;
      const mesh::Triangle v = connectivity.vertices(4 * t + k);
      const auto& p = solid.positions;
      normals.push_back((p[v[1]] - p[v[0]]).cross(p[v[2]] - p[v[0]]).normalized());
    }
    if (normals.empty()) continue;
    double off = 1;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      off = std::min(off, sine_to_axes(field[t], normals[i]));
      for (std::size_t j = 0; j < i; ++j) {
        const double cosine = normals[i].dot(normals[j]);
        if (std::abs(cosine) > std::cos(5 * std::numbers::pi / 180) ||
            std::abs(cosine) < std::cos(85 * std::numbers::pi / 180))
          continue;
        const Vector3 other = cosine < 0 ? Vector3(-normals[j]) : normals[j];
        const Vector3 edge = normals[i].cross(other).normalized();
        off = std::min(off, sine_to_axes(field[t], edge));
        for (int axis = 0; axis < 3; ++axis) {
          const Vector3 a = rotated(field[t], Vector3::Unit(axis));
          // Between them, either way round.
          if (normals[i].cross(a).dot(edge) * a.cross(other).dot(edge) >= 0) off = std::min(off, std::abs(a.dot(edge)));
        }
      }
    }
    worst = std::max(worst, std::asin(off) * 180 / std::numbers::pi);
  }
  return worst;
}

}  // namespace orbicube::test
