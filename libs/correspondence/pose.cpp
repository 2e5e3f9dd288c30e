#include "correspondence/pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/search/rotations.h"

namespace orbicube::correspondence {
namespace {

using mesh::Triangle;
using mesh::Vector3;
using Matrix3 = Eigen::Matrix3d;

// Of each vertex in both states, each state's whole area being one: neither a dense nor a large one counts more.
std::vector<double> weights_of(std::span<const Triangle> triangles, std::span<const Vector3> a,
                               std::span<const Vector3> b) {
  std::vector<double> weights(a.size(), 0.0);
  for (const std::span<const Vector3> x : {a, b}) {
    std::vector<double> own(a.size(), 0.0);
    double whole = 0;
    for (const Triangle& t : triangles) {
      const double area = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
      whole += area;
      for (const mesh::Index v : t)
        own[v] += area;
    }
    for (std::size_t v = 0; whole > 0 && v < own.size(); ++v)
      weights[v] += own[v] / (6 * whole);  // 3 for the corners, 2 for the states
  }
  return weights;
}

Similarity best_similarity(std::span<const Vector3> from, std::span<const Vector3> to, std::span<const double> weights,
                           bool scaled) {
  Vector3 from_mean = Vector3::Zero(), to_mean = Vector3::Zero();
  for (std::size_t v = 0; v < from.size(); ++v) {
    from_mean += weights[v] * from[v];
    to_mean += weights[v] * to[v];
  }
  Matrix3 covariance = Matrix3::Zero();
  double spread = 0;
  for (std::size_t v = 0; v < from.size(); ++v) {
    covariance += weights[v] * (to[v] - to_mean) * (from[v] - from_mean).transpose();
    spread += weights[v] * (from[v] - from_mean).squaredNorm();
  }
  Similarity placement;
  placement.rotation = mesh::nearest_rotation(covariance);
  const double correlation = (placement.rotation.transpose() * covariance).trace();
  if (scaled && spread > 0 && correlation > 0) placement.scale = correlation / spread;
  placement.shift = to_mean - placement.scale * (placement.rotation * from_mean);
  return placement;
}

}  // namespace

std::vector<Similarity> place(Pose pose, std::span<const Triangle> triangles, std::span<base::Array<Vector3>> states) {
  std::vector<Similarity> result(states.size());
  for (std::size_t i = 1; i < states.size() && pose != Pose::kept; ++i) {
    const std::vector<double> weights = weights_of(triangles, states[0], states[i]);
    const Similarity& s = result[i] = best_similarity(states[i], states[0], weights, pose == Pose::scaled);
    for (Vector3& x : states[i])
      x = s.scale * (s.rotation * x) + s.shift;
  }
  return result;
}

}  // namespace orbicube::correspondence
