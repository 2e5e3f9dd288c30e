#include "polycube/outputs/inverse_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mesh/search/predicates.h"

namespace orbicube::polycube {
namespace {

constexpr const char* inverse_map_phase = "inverse map";

Eigen::Vector2d in_plane(const Vector3& p, AxisLabel label) {
  const Eigen::Vector2d flat(p[(axis_of(label) + 1) % 3], p[(axis_of(label) + 2) % 3]);
  return sign_of(label) > 0 ? flat : Eigen::Vector2d(flat[1], flat[0]);
}

double doubled_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Weights of a point that is in a positive triangle, borders included, by exact signs; false for others.
bool weights_in(const Eigen::Vector2d& p, const std::array<Eigen::Vector2d, 3>& corner, Vector3& weights) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d &a = corner[(k + 1) % 3], &b = corner[(k + 2) % 3];
    const int sign = mesh::orientation_2d(a, b, p);
    if (sign < 0) return false;
    weights[static_cast<Eigen::Index>(k)] = sign == 0 ? 0 : std::max(0.0, doubled_area(a, b, p));
  }
  const double sum = weights.sum();
  if (sum > 0) {
    weights /= sum;
    return true;
  }
  // All areas are lost in rounding: the nearest corner.
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if ((corner[k] - p).norm() < (corner[nearest] - p).norm()) nearest = k;
  weights = Vector3::Unit(static_cast<Eigen::Index>(nearest));
  return true;
}

// The points sorted by their coordinate along an axis, then row by row in the plane.
class Rows {
 public:
  using Place = std::array<double, 3>;

  Rows(std::span<const Vector3> points, int axis, std::pmr::memory_resource* memory)
      : order_(points.size(), memory), places_(memory) {
    std::iota(order_.begin(), order_.end(), Index{0});
    const auto place = [&](Index i) {
      return Place{points[i][axis], points[i][(axis + 1) % 3], points[i][(axis + 2) % 3]};
    };
    std::sort(order_.begin(), order_.end(), [&](Index a, Index b) { return place(a) < place(b); });
    places_.reserve(order_.size());
    for (const Index i : order_)
      places_.push_back(place(i));
  }

  // visit(point) for those in a plane and in a box in it.
  template <class Visit>
  void for_each_in(const Place& low, const Place& high, const Visit& visit) const {
    Place from = low;
    for (auto at = std::lower_bound(places_.begin(), places_.end(), from);
         at != places_.end() && (*at)[0] == low[0] && (*at)[1] <= high[1];
         at = std::lower_bound(at, places_.end(), from)) {
      if ((*at)[1] != from[1]) {
        // The row that was requested has ended; what comes is another.
        from[1] = (*at)[1];
        continue;
      }
      for (; at != places_.end() && (*at)[0] == low[0] && (*at)[1] == from[1] && (*at)[2] <= high[2]; ++at)
        visit(order_[static_cast<std::size_t>(at - places_.begin())]);
      from[1] = std::nextafter(from[1], std::numeric_limits<double>::infinity());
    }
  }

 private:
  Array<Index> order_;
  Array<Place> places_;
};

}  // namespace

LocatedPoints locate(const SurfaceMap& map, std::span<const Vector3> points, const base::Host& host) {
  LocatedPoints result(host.memory);
  result.triangles.assign(points.size(), no_index);
  result.weights.assign(points.size(), Vector3::Zero());
  for (int axis = 0; axis < 3; ++axis) {
    host.report(inverse_map_phase, 0, 0);
    const Rows rows(points, axis, host.memory);
    for (Index t = 0; t < map.triangles.size(); ++t) {
      if (t % 256 == 0) host.report(inverse_map_phase, t, map.triangles.size());
      if (axis_of(map.labels[t]) != axis) continue;
      std::array<Eigen::Vector2d, 3> corner;
      Vector3 low = map.polycube[map.triangles[t][0]], high = low;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3& p = map.polycube[map.triangles[t][k]];
        corner[k] = in_plane(p, map.labels[t]);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      rows.for_each_in({low[axis], low[u], low[v]}, {high[axis], high[u], high[v]}, [&](Index i) {
        if (result.triangles[i] != no_index) return;
        Vector3 weights;
        if (!weights_in(in_plane(points[i], map.labels[t]), corner, weights)) return;
        result.triangles[i] = t;
        result.weights[i] = weights;
      });
    }
  }
  return result;
}

}  // namespace orbicube::polycube
