#include "polycube/registration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/bounding_volume_tree.h"
#include "polycube/random.h"

namespace orbicube::polycube {
namespace {

constexpr const char* phase = "registration";
constexpr std::size_t samples = 3000, spread = 320;
constexpr double width = 1.2;      // of the kernel of the field, in units of the shapes' standard deviation
constexpr double stiffness = 2;    // of the field
constexpr double outliers = 0.05;  // the part of points that belongs to none of the others
constexpr int most_rounds = 80;

using Matrix = Eigen::MatrixXd;

struct Samples {
  explicit Samples(std::pmr::memory_resource* memory) : points(memory), normals(memory) {}
  Array<Vector3> points, normals;
};

// Points spread evenly: of many at random, one after another the farthest from those chosen.
Samples spread_over(const SurfaceSpan& surface, const base::Host& host) {
  Array<double> sums(host.memory);
  double area = 0;
  for (const mesh::Triangle& t : surface.triangles) {
    const Vector3 &a = surface.positions[t[0]], &b = surface.positions[t[1]], &c = surface.positions[t[2]];
    sums.push_back(area += 0.5 * (b - a).cross(c - a).norm());
  }
  Random random(1);
  Samples all(host.memory), result(host.memory);
  for (std::size_t i = 0; i < samples; ++i) {
    // One in each equal part of the area.
    const double at = area * (static_cast<double>(i) + random.unit()) / samples;
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
    host.report(phase, k, spread);
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
  for (int round = 0; round < most_rounds && variance > 1e-5; ++round) {
    host.report(phase, static_cast<std::uint64_t>(round), most_rounds);
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
    field = system.partialPivLu().solve(chance * to - Matrix(weight.asDiagonal() * from));
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

mesh::Box box_of(const SurfaceSpan& surface) {
  mesh::Box box;
  for (const mesh::Triangle& t : surface.triangles)
    for (const mesh::Index v : t)
      box.add(surface.positions[v]);
  return box;
}

// The corners of both boxes.
ScatteredMap between_boxes(const mesh::Box& from, const mesh::Box& to, const base::Host& host) {
  Array<Vector3> first(host.memory), second(host.memory);
  for (int corner = 0; corner < 8; ++corner) {
    Vector3 a, b;
    for (int axis = 0; axis < 3; ++axis) {
      a[axis] = (corner >> axis & 1) != 0 ? from.high[axis] : from.low[axis];
      b[axis] = (corner >> axis & 1) != 0 ? to.high[axis] : to.low[axis];
    }
    first.push_back(a);
    second.push_back(b);
  }
  return ScatteredMap(first, second, 0, host);
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
  constexpr std::size_t enough_pairs = 4;
  const ScatteredMap boxes = between_boxes(box_of(from), box_of(to), host);
  Array<Vector3> from_pairs(host.memory), to_pairs(host.memory);
  for (const PointPair& pair : pairs) {
    from_pairs.push_back(pairs.size() < enough_pairs ? boxes(pair.first) : pair.first);
    to_pairs.push_back(pair.second);
  }
  if (pairs.size() < enough_pairs) bend(boxes);
  if (!pairs.empty()) bend(ScatteredMap(from_pairs, to_pairs, 0, host));

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
