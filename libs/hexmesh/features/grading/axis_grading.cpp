#include "hexmesh/features/grading/axis_grading.h"

#include <algorithm>
#include <cmath>

namespace orbicube::hexmesh {
namespace {

// Of a segment of length 1, along an axis: less, and finer cells there hardly help. A diagonal has 1 / sqrt 3.
constexpr double least_share = 0.4;
constexpr double growth = 0.4;       // of the size of cells, for each unit of length away
constexpr double least_size = 0.04;  // of the base size

}  // namespace

AxisGrading::AxisGrading(const Vector3& low, const Vector3& high, double size, const base::Host& host)
    : base_(size),
      low_(low),
      step_((high - low) / static_cast<double>(intervals)),
      size_{Array<double>(intervals, size, host.memory), Array<double>(intervals, size, host.memory),
            Array<double>(intervals, size, host.memory)},
      cells_{Array<double>(host.memory), Array<double>(host.memory), Array<double>(host.memory)} {
  spread();
}

std::size_t AxisGrading::interval(std::size_t axis, double x) const {
  const auto k = static_cast<Eigen::Index>(axis);
  const double at = (x - low_[k]) / step_[k];
  return at > 0 ? std::min(intervals - 1, static_cast<std::size_t>(std::min(at, 1.0 * intervals))) : 0;
}

void AxisGrading::refine(const Vector3& from, const Vector3& to, double size) {
  const double length = (to - from).norm(), wanted = std::max(size, least_size * base_);
  if (!(length > 0) || wanted >= base_) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    if (std::abs(to[k] - from[k]) < least_share * length) continue;
    const auto [first, last] = std::minmax({interval(axis, from[k]), interval(axis, to[k])});
    for (std::size_t i = first; i <= last; ++i)
      size_[axis][i] = std::min(size_[axis][i], wanted);
  }
}

void AxisGrading::spread() {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double step = step_[static_cast<Eigen::Index>(axis)];
    Array<double>& size = size_[axis];
    for (std::size_t i = 1; i < intervals; ++i)
      size[i] = std::min(size[i], size[i - 1] + growth * step);
    for (std::size_t i = intervals - 1; i-- > 0;)
      size[i] = std::min(size[i], size[i + 1] + growth * step);
    cells_[axis].assign(intervals + 1, 0);
    for (std::size_t i = 0; i < intervals; ++i)
      cells_[axis][i + 1] = cells_[axis][i] + step / size[i];
  }
}

Vector3 AxisGrading::cells(const Vector3& p) const {
  Vector3 result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    const std::size_t i = interval(axis, p[k]);
    const double begin = low_[k] + step_[k] * static_cast<double>(i);
    result[k] = cells_[axis][i] + (p[k] - begin) / size_[axis][i];
  }
  return result;
}

Vector3 AxisGrading::position(const Vector3& cells) const {
  Vector3 result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    const auto after = std::upper_bound(cells_[axis].begin() + 1, cells_[axis].end() - 1, cells[k]);
    const auto i = static_cast<std::size_t>(after - cells_[axis].begin()) - 1;
    result[k] = low_[k] + step_[k] * static_cast<double>(i) + (cells[k] - cells_[axis][i]) * size_[axis][i];
  }
  return result;
}

Vector3 AxisGrading::size(const Vector3& p) const {
  return {size_[0][interval(0, p[0])], size_[1][interval(1, p[1])], size_[2][interval(2, p[2])]};
}

}  // namespace orbicube::hexmesh
