#include "polycube/domain/registration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/random.h"
#include "linear/direct/dense_system.h"

namespace orbicube::polycube {
namespace {

constexpr const char* registration_phase = "registration";
constexpr std::size_t samples_a_point = 10, max_points = 320, min_points = 40, points_a_triangle = 4;
constexpr double width = 1.2;      // of the kernel of the field, in units of the shapes' standard deviation
constexpr double stiffness = 2;    // of the field
constexpr double outliers = 0.05;  // the part of points that belongs to none of the others
constexpr int max_rounds = 80;

using Matrix = Eigen::MatrixXd;

struct Samples {
  explicit Samples(std::pmr::memory_resource* memory) : points(memory), normals(memory) {}
  Array<Vector3> points, normals;
};

// Points spread evenly: of many at random, one after another the farthest from those chosen.
Samples spread_over(const SurfaceSpan& surface, const base::Host& host) {
  const std::size_t spread = std::clamp(points_a_triangle * surface.triangles.size(), min_points, max_points);
  const std::size_t samples = samples_a_point * spread;
  Array<double> sums(host.memory);
  double area = 0;
  for (const mesh::Triangle& t : surface.triangles) {
    const Vector3 &a = surface.positions[t[0]], &b = surface.positions[t[1]], &c = surface.positions[t[2]];
    sums.push_back(area += 0.5 * (b - a).cross(c - a).norm());
  }
  base::Random random(1);
  Samples all(host.memory), result(host.memory);
  for (std::size_t i = 0; i < samples; ++i) {
    // One in each equal part of the area.
    const double at = area * (static_cast<double>(i) + random.unit()) / static_cast<double>(samples);
    const auto place = std::min(std::lower_bound(sums.begin(), sums.end(), at), sums.end() - 1);
    const mesh::Triangle& t = surface.triangles[static_cast<std::size_t>(place - sums.begin())];
    const Vector3 &a = surface.positions[t[0]], &b = surface.positions[t[1]], &c = surface.positions[t[2]];
    double u = random.unit(), v = random.unit();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    all.points.push_back(a + u * (b - a) + v * (c - a));
    all.normals.push_back((b - a).cross(c - a).stableNormalized());
  }
  Array<double> distance(samples, std::numeric_limits<double>::infinity(), host.memory);
  std::size_t next = 0;
  for (std::size_t k = 0; k < spread; ++k) {
    host.report(registration_phase, k, spread);
    result.points.push_back(all.points[next]);
    result.normals.push_back(all.normals[next]);
    for (std::size_t i = 0; i < samples; ++i)
      distance[i] = std::min(distance[i], (all.points[i] - all.points[next]).squaredNorm());
    next = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return result;
}

Matrix rows_of(std::span<const Vector3> points) {
  Matrix result(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return result;
}

// Where the points of `from` drift to. Both are in units in which they are about 1 wide.
Matrix drift(const Matrix& from, const Matrix& from_normals, const Matrix& to, const Matrix& to_normals,
             const base::Host& host) {
  const Eigen::Index m = from.rows(), n = to.rows();
  Matrix kernel(m, m), agreement(m, n);
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j < m; ++j)
      kernel(i, j) = std::exp(-(from.row(i) - from.row(j)).squaredNorm() / (2 * width * width));
    // Sides of thin parts that look away from each other do not belong together.
    for (Eigen::Index j = 0; j < n; ++j) {
      const double same = std::max(0.05, 0.5 + 0.5 * from_normals.row(i).dot(to_normals.row(j)));
      agreement(i, j) = same * same;
    }
  }
  Matrix moved = from, chance(m, n), field = Matrix::Zero(m, 3);
  double variance = 0;
  for (Eigen::Index i = 0; i < m; ++i)
    variance += (to.rowwise() - from.row(i)).squaredNorm();
  variance /= 3.0 * static_cast<double>(m * n);
  for (int round = 0; round < max_rounds && variance > 1e-5; ++round) {
    host.report(registration_phase, static_cast<std::uint64_t>(round), max_rounds);
    const double other = std::pow(2 * std::numbers::pi * variance, 1.5) * outliers / (1 - outliers) *
                         static_cast<double>(m) / static_cast<double>(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      double sum = other;
      for (Eigen::Index i = 0; i < m; ++i)
        sum += chance(i, j) = agreement(i, j) * std::exp(-(moved.row(i) - to.row(j)).squaredNorm() / (2 * variance));
      chance.col(j) /= sum;
    }
    const Eigen::VectorXd weight = chance.rowwise().sum();
    const double total = weight.sum();
    if (!(total > 1e-6)) break;
    Matrix system = weight.asDiagonal() * kernel;
    system.diagonal().array() += stiffness * variance;
    field = linear::solve_dense(system, chance * to - Matrix(weight.asDiagonal() * from));
    moved = from + kernel * field;
    double error = 0;
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < n; ++j)
        error += chance(i, j) * (moved.row(i) - to.row(j)).squaredNorm();
    const double before = variance;
    variance = error / (3 * total);
    if (std::abs(before - variance) < 1e-5 * before) break;
  }
  return moved;
}

Vector3 mean_of(std::span<const Vector3> points) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& p : points)
    sum += p;
  return sum / static_cast<double>(points.size());
}

// Their root mean square distance from the mean.
double radius_of(std::span<const Vector3> points, const Vector3& mean) {
  double sum = 0;
  for (const Vector3& p : points)
    sum += (p - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(points.size()));
}

// Principal axes as columns, right-handed.
Eigen::Matrix3d axes_of(std::span<const Vector3> points, const Vector3& mean) {
  Eigen::Matrix3d spread_matrix = Eigen::Matrix3d::Zero();
  for (const Vector3& p : points)
    spread_matrix += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread_matrix);
  Eigen::Matrix3d axes = eigen.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  return axes;
}

// The rotations of the cube.
template <class Visit>
void for_each_quarter_turn(const Visit& visit) {
  std::array<int, 3> axis = {0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
      for (int k = 0; k < 3; ++k)
        turn(axis[static_cast<std::size_t>(k)], k) = (signs >> k & 1) != 0 ? -1 : 1;
      if (turn.determinant() > 0) visit(turn);
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
}

// How badly points fit that have drifted: what is left between the sets, both ways, sides that disagree included, and
// how far the points went.
double misfit(const Matrix& from, const Matrix& moved, const Matrix& from_normals, const Matrix& to,
              const Matrix& to_normals) {
  constexpr double side_weight = 0.3, way_weight = 0.3;
  const auto distance = [&](Eigen::Index i, Eigen::Index j) {
    return (moved.row(i) - to.row(j)).norm() + side_weight * (1 - from_normals.row(i).dot(to_normals.row(j)));
  };
  double sum = way_weight * (moved - from).rowwise().norm().mean();
  double min_sum = 0;
  for (Eigen::Index i = 0; i < moved.rows(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index j = 0; j < to.rows(); ++j)
      least = std::min(least, distance(i, j));
    min_sum += least;
  }
  sum += min_sum / static_cast<double>(moved.rows());
  min_sum = 0;
  for (Eigen::Index j = 0; j < to.rows(); ++j) {
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < moved.rows(); ++i)
      least = std::min(least, distance(i, j));
    min_sum += least;
  }
  return sum + min_sum / static_cast<double>(to.rows());
}

// Turns and scales the first points to where they fit the second best: as the shapes stand, or by quarter turns of
// their own axes or of their principal ones, each tried by a drift of a few points.
void turn_to_fit(Samples& first, const Samples& second, const base::Host& host) {
  const Vector3 from = mean_of(first.points), to = mean_of(second.points);
  const double from_radius = radius_of(first.points, from), to_radius = radius_of(second.points, to);
  if (!(from_radius > 0) || !(to_radius > 0)) return;
  constexpr std::size_t few = 90;
  const auto rows = [&](const Array<Vector3>& points, const Vector3& centre, double scale) {
    const std::span<const Vector3> part(points.data(), std::min(few, points.size()));
    Matrix result = rows_of(part);
    return Matrix((result.rowwise() - centre.transpose()) / scale);
  };
  const Vector3 none = Vector3::Zero();
  const Matrix points = rows(first.points, from, from_radius), normals = rows(first.normals, none, 1);
  const Matrix target = rows(second.points, to, to_radius), target_normals = rows(second.normals, none, 1);
  const Eigen::Matrix3d own_axes = axes_of(first.points, from), other_axes = axes_of(second.points, to);
  double least = std::numeric_limits<double>::infinity();
  Eigen::Matrix3d best = Eigen::Matrix3d::Identity();
  const auto attempt = [&](const Eigen::Matrix3d& turn) {
    const Matrix turned = points * turn.transpose(), turned_normals = normals * turn.transpose();
    const double now = misfit(turned, drift(turned, turned_normals, target, target_normals, host), turned_normals,
                              target, target_normals);
    // The first is to stand as it does, unless another is clearly better.
    constexpr double clearly = 0.98;
    if (!(now < clearly * least)) return;
    least = now;
    best = turn;
  };
  attempt(Eigen::Matrix3d::Identity());
  for_each_quarter_turn(attempt);
  for_each_quarter_turn([&](const Eigen::Matrix3d& turn) { attempt(other_axes * turn * own_axes.transpose()); });
  for (Vector3& p : first.points)
    p = to + (to_radius / from_radius) * (best * (p - from));
  for (Vector3& n : first.normals)
    n = best * n;
}

}  // namespace

ScatteredMap bend_shape(const SurfaceSpan& from, const SurfaceSpan& to, std::span<const PointPair> pairs,
                        const base::Host& host) {
  Samples first = spread_over(from, host);
  const Samples second = spread_over(to, host);
  Array<Vector3> points(first.points, host.memory);
  const auto bend = [&](const ScatteredMap& map) {
    for (std::size_t i = 0; i < first.points.size(); ++i) {
      const Eigen::Matrix3d derivative = map.derivative(first.points[i]);
      first.points[i] = map(first.points[i]);
      if (derivative.determinant() > 0)
        first.normals[i] = (derivative.inverse().transpose() * first.normals[i]).stableNormalized();
    }
  };
  // Pairs that span the space say how the shapes stand; fewer only count at the end.
  constexpr std::size_t enough_pairs = 4;
  if (pairs.size() >= enough_pairs) {
    Array<Vector3> from_pairs(host.memory), to_pairs(host.memory);
    for (const PointPair& pair : pairs) {
      from_pairs.push_back(pair.first);
      to_pairs.push_back(pair.second);
    }
    bend(ScatteredMap(from_pairs, to_pairs, 0, host));
  } else {
    turn_to_fit(first, second, host);
  }

  Matrix target = rows_of(second.points), moving = rows_of(first.points);
  const Eigen::RowVector3d centre = target.colwise().mean();
  target.rowwise() -= centre;
  moving.rowwise() -= centre;
  const double scale = std::sqrt(target.squaredNorm() / static_cast<double>(target.rows()));
  const double unit = scale > 0 ? scale : 1;
  const Matrix moved = drift(moving / unit, rows_of(first.normals), target / unit, rows_of(second.normals), host);
  Array<Vector3> images(host.memory);
  for (Eigen::Index i = 0; i < moved.rows(); ++i)
    images.push_back((unit * moved.row(i) + centre).transpose());
  // Pairs are met whatever the drift.
  for (const PointPair& pair : pairs) {
    points.push_back(pair.first);
    images.push_back(pair.second);
  }
  constexpr double smoothing = 1e-3;
  return ScatteredMap(points, images, smoothing, host);
}

}  // namespace orbicube::polycube
