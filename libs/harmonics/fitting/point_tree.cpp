#include "harmonics/fitting/point_tree.h"

#include <algorithm>

namespace orbicube::harmonics {
namespace {

// Parts of so few points are searched one by one.
constexpr std::size_t leaf = 8;

}  // namespace

PointTree::PointTree(std::span<const Vector3> points, const base::Host& host)
    : points_(points.begin(), points.end(), host.memory), axis_(points.size(), host.memory) {
  build(0, points_.size(), host);
}

void PointTree::build(std::size_t begin, std::size_t end, const base::Host& host) {
  if (end - begin <= leaf) return;
  constexpr std::size_t worth_a_report = 4096;
  if (end - begin >= worth_a_report) host.report("sorting points", begin, points_.size());
  Vector3 low = points_[begin], high = points_[begin];
  for (std::size_t i = begin; i < end; ++i) {
    low = low.cwiseMin(points_[i]);
    high = high.cwiseMax(points_[i]);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [axis](const Vector3& a, const Vector3& b) { return a[axis] < b[axis]; });
  axis_[middle] = static_cast<std::uint8_t>(axis);
  build(begin, middle, host);
  build(middle + 1, end, host);
}

void PointTree::search(std::size_t begin, std::size_t end, const Vector3& p, double& best) const {
  if (end - begin <= leaf) {
    for (std::size_t i = begin; i < end; ++i)
      best = std::min(best, (points_[i] - p).squaredNorm());
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  best = std::min(best, (points_[middle] - p).squaredNorm());
  const double across = p[axis_[middle]] - points_[middle][axis_[middle]];
  if (across < 0) {
    search(begin, middle, p, best);
    if (across * across < best) search(middle + 1, end, p, best);
  } else {
    search(middle + 1, end, p, best);
    if (across * across < best) search(begin, middle, p, best);
  }
}

}  // namespace orbicube::harmonics
