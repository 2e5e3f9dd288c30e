#include "tetrahedra/scaled_surface.h"

#include <algorithm>
#include <cmath>

namespace orbicube::tetrahedra {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

ScaledSurface::ScaledSurface(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                             std::pmr::memory_resource* memory)
    : positions_(memory), triangles_(triangles.begin(), triangles.end(), memory), original_(memory) {
  mesh::Array<Index> number(positions.size(), mesh::no_index, memory);
  for (const Triangle& t : triangles) {
    for (const Index v : t)
      number[v] = 0;
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (number[v] == mesh::no_index) continue;
    number[v] = static_cast<Index>(original_.size());
    original_.push_back(static_cast<Index>(v));
    positions_.push_back(positions[v]);
  }
  for (Triangle& t : triangles_) {
    for (Index& v : t)
      v = number[v];
  }

  Vector3 low = positions_.front(), high = low;
  for (const Vector3& p : positions_) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (low[axis] > 0 && high[axis] - low[axis] <= low[axis]) shift_[axis] = low[axis];
    if (high[axis] < 0 && high[axis] - low[axis] <= -high[axis]) shift_[axis] = high[axis];
    largest = std::max({largest, std::abs(low[axis] - shift_[axis]), std::abs(high[axis] - shift_[axis])});
  }
  std::frexp(largest, &exponent_);
  for (Vector3& p : positions_)
    p = scaled(p);
}

Vector3 ScaledSurface::unscaled(const Vector3& p) const {
  return p.unaryExpr([&](double x) { return std::ldexp(x, exponent_); }) + shift_;
}

Vector3 ScaledSurface::scaled(const Vector3& p) const {
  return (p - shift_).unaryExpr([&](double x) { return std::ldexp(x, -exponent_); });
}

double ScaledSurface::scaled_length(double length) const {
  return std::ldexp(length, -exponent_);
}

double ScaledSurface::scaled_volume(double volume) const {
  return std::ldexp(volume, -3 * exponent_);
}

}  // namespace orbicube::tetrahedra
