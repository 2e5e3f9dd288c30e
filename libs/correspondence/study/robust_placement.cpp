#include "correspondence/study/robust_placement.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "mesh/search/vertex_measures.h"

namespace orbicube::correspondence {

namespace {

constexpr std::size_t max_steps = 500;   // 200 shapes with a difference at one end converge in 120
constexpr double converged_step = 1e-8;  // a step of the poses: an angle, or a length in sizes of the mean
// Weight of distances in all directions beside those along normals. It decides where normals leave a rotation open, as
// on a sphere; with 0.2, the fit distributes a local difference again.
constexpr double tangential = 0.01;
// Weights are as if this many further subjects varied as the median point does: variances of few subjects are
// uncertain, and a point that a few poses can fit must not take over. Half and twice as many change little with 200
// subjects.
constexpr double prior_subjects = 10;
constexpr Eigen::Index points_at_once = 256;  // points that a thread takes at once

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// The mean, its normals and the weights of its points.
struct Reference {
  Eigen::Matrix3Xd mean, normals;  // the mean about its weighted center
  Eigen::VectorXd weights;         // their sum is one
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double size = 0;  // root mean square distance of the mean's points from its center
};

base::Array<mesh::Vector3> normals_of(const Eigen::Matrix3Xd& positions, std::span<const mesh::Triangle> triangles,
                                      const base::Host& host) {
  const base::Array<mesh::Vector3> points(positions.colwise().begin(), positions.colwise().end(), host.memory);
  return mesh::vertex_normals(points, triangles, host);
}

class RobustPlacement {
 public:
  RobustPlacement(Population& shapes, std::span<const mesh::Triangle> triangles, const base::Host& host)
      : shapes_(shapes), triangles_(triangles), host_(host), points_(shapes.cols() / 3) {
    reference_.mean.resize(3, points_);
    reference_.normals.resize(3, points_);
    reference_.weights.resize(points_);
    variances_.resize(points_);
  }

  // Moves all shapes one step nearer; returns the largest step.
  double step(std::vector<Similarity>& moved) {
    ++round_;
    update_mean();
    update_weights();
    const Eigen::LDLT<Matrix6> normal_equations(normal_matrix());
    std::vector<double> steps(static_cast<std::size_t>(shapes_.rows()), 0.0);
    for_each(steps.size(), [&](std::size_t i) {
      const Vector6 s = normal_equations.solve(right_side(static_cast<Eigen::Index>(i)));
      if (!s.allFinite()) return;  // the mean has no extent
      const Eigen::Vector3d turn = s.tail<3>(), &center = reference_.center;
      const double angle = turn.norm();
      const Eigen::Matrix3d rotation =
          angle > 0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
      move_shape(shapes_, static_cast<Eigen::Index>(i), rotation, center + s.head<3>() - rotation * center, moved[i]);
      steps[i] = std::max(angle, s.head<3>().norm() / reference_.size);
    });
    return *std::ranges::max_element(steps);
  }

 private:
  // body(i) for each i below count on all threads, with reports between blocks of them.
  template <class Body>
  void for_each(std::size_t count, const Body& body) const {
    constexpr std::size_t block = 16;
    for (std::size_t first = 0; first < count; first += block) {
      host_.report("placing the group", round_, max_steps + 1);
      host_.parallel_for(std::min(block, count - first), [&](std::size_t i) { body(first + i); });
    }
  }

  // body(first, count) for pieces of the points, on all threads.
  template <class Body>
  void for_pieces(const Body& body) const {
    const Eigen::Index pieces = (points_ + points_at_once - 1) / points_at_once;
    for_each(static_cast<std::size_t>(pieces), [&](std::size_t k) {
      const Eigen::Index first = static_cast<Eigen::Index>(k) * points_at_once;
      body(first, std::min(points_at_once, points_ - first));
    });
  }

  void update_mean() {
    for_pieces([&](Eigen::Index first, Eigen::Index count) {
      reference_.mean.middleCols(first, count).reshaped() =
          shapes_.middleCols(3 * first, 3 * count).colwise().mean().transpose();
    });
    const base::Array<mesh::Vector3> normals = normals_of(reference_.mean, triangles_, host_);
    for (Eigen::Index v = 0; v < points_; ++v)
      reference_.normals.col(v) = normals[static_cast<std::size_t>(v)];
  }

  double distance(Eigen::Index i, Eigen::Index v) const {
    return reference_.normals.col(v).dot(shapes_.row(i).segment<3>(3 * v).transpose() - reference_.mean.col(v));
  }

  // Weights from the variances along the normals; then centers the mean by them.
  void update_weights() {
    const auto subjects = static_cast<double>(shapes_.rows());
    for_pieces([&](Eigen::Index first, Eigen::Index count) {
      variances_.segment(first, count).setZero();
      for (Eigen::Index i = 0; i < shapes_.rows(); ++i)
        for (Eigen::Index v = first; v < first + count; ++v)
          variances_(v) += distance(i, v) * distance(i, v) / subjects;
    });
    std::vector<double> sorted(variances_.begin(), variances_.end());
    const auto middle = sorted.begin() + points_ / 2;
    std::ranges::nth_element(sorted, middle);
    const double typical = std::max(*middle, 1e-6 * variances_.mean());  // where most points coincide exactly
    if (typical > 0)
      reference_.weights = (subjects * variances_.array() + prior_subjects * typical).inverse();
    else
      reference_.weights.setOnes();
    reference_.weights /= reference_.weights.sum();
    reference_.center = reference_.mean * reference_.weights;
    reference_.size =
        std::sqrt((reference_.mean.colwise() - reference_.center).squaredNorm() / static_cast<double>(points_));
  }

  // How point v moves by the six parameters, a translation and a rotation about the center: the identity, and minus the
  // matrix of the cross product.
  Eigen::Matrix<double, 3, 6> motion(Eigen::Index v) const {
    const Eigen::Vector3d p = reference_.mean.col(v) - reference_.center;
    Eigen::Matrix<double, 3, 6> result;
    result.leftCols<3>().setIdentity();
    result.rightCols<3>() << 0, p.z(), -p.y(), -p.z(), 0, p.x(), p.y(), -p.x(), 0;
    return result;
  }

  Matrix6 normal_matrix() const {
    Matrix6 result = Matrix6::Zero();
    for (Eigen::Index v = 0; v < points_; ++v) {
      const Eigen::Matrix<double, 3, 6> by_parameters = motion(v);
      const Vector6 along_normal = by_parameters.transpose() * reference_.normals.col(v);
      result += reference_.weights(v) *
                (along_normal * along_normal.transpose() + tangential * by_parameters.transpose() * by_parameters);
    }
    return result;
  }

  Vector6 right_side(Eigen::Index i) const {
    Vector6 result = Vector6::Zero();
    for (Eigen::Index v = 0; v < points_; ++v) {
      const Eigen::Vector3d away = shapes_.row(i).segment<3>(3 * v).transpose() - reference_.mean.col(v);
      const Eigen::Vector3d pull = reference_.normals.col(v).dot(away) * reference_.normals.col(v) + tangential * away;
      result.head<3>() -= reference_.weights(v) * pull;
      result.tail<3>() -= reference_.weights(v) * (reference_.mean.col(v) - reference_.center).cross(pull);
    }
    return result;
  }

  Population& shapes_;
  std::span<const mesh::Triangle> triangles_;
  const base::Host& host_;
  Eigen::Index points_;
  std::size_t round_ = 0;
  Reference reference_;
  Eigen::VectorXd variances_;  // along the normals
};

}  // namespace

base::Array<mesh::Vector3> normals_of_mean(const Population& shapes, std::span<const mesh::Triangle> triangles,
                                           const base::Host& host) {
  return normals_of(shapes.colwise().mean().reshaped(3, shapes.cols() / 3), triangles, host);
}

GroupPose place_robustly(Population& shapes, std::span<const mesh::Triangle> triangles, const base::Host& host) {
  GroupPose result = place_group(Pose::turned, shapes, host);
  RobustPlacement placement(shapes, triangles, host);
  result.rounds = 0;
  for (result.converged = false; !result.converged && result.rounds < max_steps; ++result.rounds)
    result.converged = placement.step(result.moved) <= converged_step;
  return result;
}

}  // namespace orbicube::correspondence
