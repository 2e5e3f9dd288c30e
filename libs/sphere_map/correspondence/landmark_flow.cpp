#include "sphere_map/correspondence/landmark_flow.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "sphere_map/optimization/distortion.h"
#include "sphere_map/optimization/pieces.h"

namespace orbicube::sphere_map {

LandmarkFlow::LandmarkFlow(std::span<const Vector3> from, std::span<const Vector3> to, const base::Host& host)
    : from_(from.begin(), from.end(), host.memory),
      along_(from.size(), Vector3::Zero(), host.memory),
      angle_(from.size(), 0, host.memory),
      sources_(host.memory) {
  double farthest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double angle = std::atan2(from[i].cross(to[i]).norm(), from[i].dot(to[i]));
    const Vector3 towards = to[i] - from[i].dot(to[i]) * from[i];
    // Opposite points have no shortest way between them: any is as good.
    along_[i] = towards.norm() > 1e-12 ? towards.normalized() : TangentBasis(from[i]).first;
    angle_[i] = angle;
    farthest = std::max(farthest, angle);
  }
  // A kernel as wide as landmarks are apart takes their surroundings along; beside it stands a wide one, so that what
  // all landmarks have in common moves the whole sphere.
  const double apart = nearest_on_the_way();
  constexpr double min_apart = 2e-3;
  if (apart < min_apart) {
    throw base::Error("no-valid-result", "the paths of two landmarks cross (at a distance of " + std::to_string(apart) +
                                             "): do their pairs belong together?");
  }
  const double reach = std::clamp(apart, 0.02, 0.5);
  inverse_square_reach_ = 1 / (reach * reach);
  // Twelve steps in the time that a landmark takes to cross the reach of the kernel: the error of each is below 1e-5.
  steps_ = static_cast<std::size_t>(std::clamp(std::ceil(12 * farthest / reach), 4.0, 400.0));
  sources_.resize((2 * steps_ + 1) * from_.size());
  for (std::size_t k = 0; k <= 2 * steps_; ++k) {
    host.report("velocities of the landmarks", k, 2 * steps_ + 1);
    solve(0.5 * static_cast<double>(k) / static_cast<double>(steps_),
          std::span(sources_).subspan(k * from_.size(), from_.size()));
  }
}

Vector3 LandmarkFlow::landmark(std::size_t i, double time) const {
  return std::cos(angle_[i] * time) * from_[i] + std::sin(angle_[i] * time) * along_[i];
}

Vector3 LandmarkFlow::landmark_velocity(std::size_t i, double time) const {
  return angle_[i] * (std::cos(angle_[i] * time) * along_[i] - std::sin(angle_[i] * time) * from_[i]);
}

// Sums of inverse multiquadrics: positive definite for any distinct points, and smooth.
double LandmarkFlow::kernel(const Vector3& a, const Vector3& b) const {
  const double square = (a - b).squaredNorm();
  return 1 / (1 + square) + 1 / (1 + square * inverse_square_reach_);
}

double LandmarkFlow::nearest_on_the_way() const {
  constexpr int times = 64;
  double nearest = 2;
  for (int k = 0; k <= times; ++k) {
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const Vector3 at = landmark(i, static_cast<double>(k) / times);
      for (std::size_t j = 0; j < i; ++j)
        nearest = std::min(nearest, (landmark(j, static_cast<double>(k) / times) - at).norm());
    }
  }
  return nearest;
}

// The strengths with which the kernels at the landmarks add up to the landmarks' velocities: of all fields that do, the
// one of minimum norm. Unknowns are tangent coordinates, two a landmark.
void LandmarkFlow::solve(double time, std::span<Source> sources) const {
  const auto count = static_cast<Eigen::Index>(from_.size());
  Eigen::MatrixXd matrix(2 * count, 2 * count);
  Eigen::VectorXd target(2 * count);
  Array<TangentBasis> bases(from_.get_allocator().resource());
  for (std::size_t i = 0; i < from_.size(); ++i) {
    sources[i].at = landmark(i, time);
    bases.emplace_back(sources[i].at.normalized());
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto a = static_cast<std::size_t>(i);
    const Vector3 velocity_wanted = landmark_velocity(a, time);
    target[2 * i] = velocity_wanted.dot(bases[a].first);
    target[2 * i + 1] = velocity_wanted.dot(bases[a].second);
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto b = static_cast<std::size_t>(j);
      const double k = kernel(sources[a].at, sources[b].at);
      matrix(2 * i, 2 * j) = k * bases[a].first.dot(bases[b].first);
      matrix(2 * i, 2 * j + 1) = k * bases[a].first.dot(bases[b].second);
      matrix(2 * i + 1, 2 * j) = k * bases[a].second.dot(bases[b].first);
      matrix(2 * i + 1, 2 * j + 1) = k * bases[a].second.dot(bases[b].second);
    }
  }
  const Eigen::VectorXd strength = matrix.ldlt().solve(target);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto a = static_cast<std::size_t>(i);
    sources[a].strength = strength[2 * i] * bases[a].first + strength[2 * i + 1] * bases[a].second;
  }
}

// Tangential at the point.
Vector3 LandmarkFlow::velocity(std::span<const Source> sources, const Vector3& point) const {
  Vector3 sum = Vector3::Zero();
  for (const Source& source : sources)
    sum += kernel(point, source.at) * source.strength;
  return sum - sum.dot(point) / point.squaredNorm() * point;
}

void LandmarkFlow::move(std::span<Vector3> points, const base::Host& host) const {
  const double step = 1 / static_cast<double>(steps_);
  const auto at = [&](std::size_t k) { return std::span(sources_).subspan(k * from_.size(), from_.size()); };
  for (std::size_t k = 0; k < steps_; ++k) {
    for_each_in_pieces(points.size(), "warping the sphere", host, [&](std::size_t i) {
      const Vector3 p = points[i];
      const Vector3 a = velocity(at(2 * k), p);
      const Vector3 b = velocity(at(2 * k + 1), p + 0.5 * step * a);
      const Vector3 c = velocity(at(2 * k + 1), p + 0.5 * step * b);
      const Vector3 d = velocity(at(2 * k + 2), p + step * c);
      points[i] = (p + step / 6 * (a + 2 * b + 2 * c + d)).normalized();
    });
  }
}

}  // namespace orbicube::sphere_map
