#include "polycube/labels/normal_turning.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "linear/sparse_system.h"

namespace orbicube::polycube {
namespace {

constexpr int steps = 150;
constexpr double step_length = 0.5;  // of the flow; second derivatives of the integrand are 2 at most at an axis

// The turn by the flow of the integrand alone, as a rotation vector.
Vector3 turn_towards_axes(const Vector3& n) {
  const Vector3 square = n.cwiseProduct(n);
  const Vector3 gradient = 2 * n.cwiseProduct(Vector3::Constant(square.sum()) - square);
  return -step_length * n.cross(gradient);
}

// mass + step_length * length^2 * Laplacian, of the dual graph.
linear::SparseSystem::Triplets smoothing_of(const Surface& surface, double length, const base::Host& host) {
  const auto half_edges = static_cast<Index>(3 * surface.triangles.size());
  const auto centre = [&](Index t) -> Vector3 {
    const Triangle& c = surface.triangles[t];
    return (surface.positions[c[0]] + surface.positions[c[1]] + surface.positions[c[2]]) / 3;
  };
  linear::SparseSystem::Triplets triplets(host.memory);
  for (Index h = 0; h < half_edges; ++h) {
    const Index a = h / 3, b = surface.neighbor(h);
    const Vector3 middle = (surface.positions[surface.start(h)] + surface.positions[surface.end(h)]) / 2;
    const double distance = (centre(a) - middle).norm() + (middle - centre(b)).norm();
    // Each edge is met twice, once from each side.
    const double weight = step_length * length * length * surface.length(h) / std::max(distance, 1e-12);
    triplets.emplace_back(static_cast<int>(a), static_cast<int>(a), weight);
    if (a > b) triplets.emplace_back(static_cast<int>(a), static_cast<int>(b), -weight);
  }
  for (Index t = 0; t < surface.triangles.size(); ++t)
    triplets.emplace_back(static_cast<int>(t), static_cast<int>(t), surface.areas[t] + 1e-12);
  return triplets;
}

}  // namespace

Array<Vector3> turned_normals(const Surface& surface, double length, const base::Host& host) {
  const std::size_t count = surface.triangles.size();
  linear::SparseSystem::Triplets entries = smoothing_of(surface, length, host);
  linear::SparseSystem smoothing(count, entries);
  if (!smoothing.factorize()) throw base::Error("no-valid-result", "normals of the surface could not be turned");
  Array<Eigen::Quaterniond> rotations(count, Eigen::Quaterniond::Identity(), host.memory);
  Array<Vector3> result(surface.normals, host.memory);
  Eigen::MatrixXd right(static_cast<Eigen::Index>(count), 4);
  for (int s = 0; s < steps; ++s) {
    host.report("normals", static_cast<std::uint64_t>(s), static_cast<std::uint64_t>(steps));
    for (std::size_t t = 0; t < count; ++t) {
      const Vector3 half = turn_towards_axes(result[t]) / 2;
      const Eigen::Quaterniond q = Eigen::Quaterniond(1, half.x(), half.y(), half.z()).normalized() * rotations[t];
      right.row(static_cast<Eigen::Index>(t)) = (surface.areas[t] + 1e-12) * q.coeffs().transpose();
    }
    // Neighbors differ by far less than half a turn, so that their quaternions can be averaged as vectors.
    for (Eigen::Index k = 0; k < 4; ++k)
      right.col(k) = smoothing.solve(right.col(k));
    for (std::size_t t = 0; t < count; ++t) {
      rotations[t].coeffs() = right.row(static_cast<Eigen::Index>(t)).transpose();
      rotations[t].normalize();
      result[t] = rotations[t] * surface.normals[t];
    }
  }
  return result;
}

}  // namespace orbicube::polycube
