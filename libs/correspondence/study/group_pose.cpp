#include "correspondence/study/group_pose.h"

#include <cmath>

#include "base/error.h"
#include "mesh/search/rotations.h"

namespace orbicube::correspondence {

namespace {

constexpr std::size_t max_rounds = 100;
constexpr double still = 1e-12;  // change of the mean, of its size: rounding of the sums

using Points = Eigen::Map<Eigen::Matrix3Xd>;
using ConstPoints = Eigen::Map<const Eigen::Matrix3Xd>;

Points points_of(Population& shapes, Eigen::Index i) {
  return {shapes.row(i).data(), 3, shapes.cols() / 3};
}

// Returns the rotation of `from` to the least-squares fit with `to`, both centered.
Eigen::Matrix3d best_rotation(const ConstPoints& from, const ConstPoints& to) {
  return mesh::nearest_rotation(to * from.transpose());
}

double size_of(const ConstPoints& centered) {
  return std::sqrt(centered.squaredNorm() / static_cast<double>(centered.cols()));
}

ConstPoints as_const(const Points& points) {
  return {points.data(), 3, points.cols()};
}

void require_shapes(const Population& shapes) {
  base::require(shapes.rows() > 0 && shapes.cols() > 0 && shapes.cols() % 3 == 0,
                "a group needs shapes with three coordinates a point");
  base::require(shapes.allFinite(), "a coordinate of a shape is not finite");
}

// Centers all shapes and scales them to one size if requested.
void center(Pose pose, Population& shapes, std::vector<Similarity>& moved) {
  std::vector<double> size;
  double mean_size = 0;
  for (Eigen::Index i = 0; i < shapes.rows(); ++i) {
    Points x = points_of(shapes, i);
    const Eigen::Vector3d middle = x.rowwise().mean();
    x.colwise() -= middle;
    moved[static_cast<std::size_t>(i)].shift = -middle;
    size.push_back(size_of(as_const(x)));
    if (!(size.back() > 0)) throw base::Error("degenerate-geometry", "all points of a shape are in one place");
    mean_size += size.back() / static_cast<double>(shapes.rows());
  }
  for (Eigen::Index i = 0; pose == Pose::scaled && i < shapes.rows(); ++i) {
    Similarity& s = moved[static_cast<std::size_t>(i)];
    s.scale = mean_size / size[static_cast<std::size_t>(i)];
    points_of(shapes, i) *= s.scale;
    s.shift *= s.scale;
  }
}

}  // namespace

void move_shape(Population& shapes, Eigen::Index i, const Eigen::Matrix3d& rotation, const mesh::Vector3& shift,
                Similarity& moved) {
  Points x = points_of(shapes, i);
  x = ((rotation * x).colwise() + shift).eval();
  moved.rotation = rotation * moved.rotation;
  moved.shift = rotation * moved.shift + shift;
}

GroupPose place_group(Pose pose, Population& shapes, const base::Host& host) {
  require_shapes(shapes);
  GroupPose result;
  result.moved.resize(static_cast<std::size_t>(shapes.rows()));
  if (pose == Pose::kept) return result;
  const Eigen::Vector3d place_of_first = points_of(shapes, 0).rowwise().mean();
  center(pose, shapes, result.moved);
  const Eigen::RowVectorXd first = shapes.row(0);
  Eigen::RowVectorXd mean = first;
  const Eigen::Index points = shapes.cols() / 3;
  for (result.converged = false; !result.converged && result.rounds < max_rounds; ++result.rounds) {
    for (Eigen::Index i = 0; i < shapes.rows(); ++i) {
      host.report("aligning the group", 0, 0);
      const Eigen::Matrix3d rotation =
          best_rotation(as_const(points_of(shapes, i)), ConstPoints(mean.data(), 3, points));
      move_shape(shapes, i, rotation, mesh::Vector3::Zero(), result.moved[static_cast<std::size_t>(i)]);
    }
    const Eigen::RowVectorXd next = shapes.colwise().mean();
    result.converged = (next - mean).norm() <= still * next.norm();
    mean = next;
  }
  const Eigen::Matrix3d back = best_rotation(ConstPoints(mean.data(), 3, points), ConstPoints(first.data(), 3, points));
  for (Eigen::Index i = 0; i < shapes.rows(); ++i)
    move_shape(shapes, i, back, place_of_first, result.moved[static_cast<std::size_t>(i)]);
  return result;
}

Eigen::MatrixXd distances_between(const Population& shapes, const base::Host& host) {
  require_shapes(shapes);
  const Eigen::Index n = shapes.rows();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      host.report("distances", static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(n));
      result(i, j) = result(j, i) =
          std::sqrt(3 * (shapes.row(i) - shapes.row(j)).squaredNorm() / static_cast<double>(shapes.cols()));
    }
  }
  return result;
}

}  // namespace orbicube::correspondence
