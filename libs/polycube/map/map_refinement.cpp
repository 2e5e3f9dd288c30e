#include "polycube/map/map_refinement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/backtracking.h"
#include "base/error.h"
#include "mesh/search/predicates.h"

namespace orbicube::polycube {
namespace {

using mesh::Connectivity;
using Vector2 = Eigen::Vector2d;

// One triangle of a star as a function of the place p of its first corner on the polycube, x and y the others, all in
// the plane of its patch seen from outside.
struct StarTriangle {
  std::array<int, 2> axes;
  Vector2 x, y;
  double area;              // in space
  double at_x, at_y, at_p;  // cotangents in space

  Vector2 in_plane(const Vector3& p) const { return {p[axes[0]], p[axes[1]]}; }
};

class MapRefinement {
 public:
  MapRefinement(const Surface& surface, std::span<const AxisLabel> labels, Decimation& decimation, double area_weight,
                std::span<Vector3> polycube, const base::Host& host)
      : surface_(surface),
        labels_(labels),
        decimation_(decimation),
        lambda_(area_weight),
        polycube_(polycube),
        host_(host),
        star_(host.memory),
        polygon_(host.memory),
        clipped_(host.memory) {}

  void run(int sweeps) {
    std::size_t alive = 0;
    for (const Index h : decimation_.outgoing)
      alive += h != no_index;
    std::size_t next_sweep = 2 * alive;
    for (std::size_t i = decimation_.collapses.size(); i-- > 0;) {
      if (i % 256 == 0) host_.report("refinement", decimation_.collapses.size() - i, decimation_.collapses.size());
      const Collapse& c = decimation_.collapses[i];
      decimation_.undo(c);
      insert(c);
      relax(c.removed);
      decimation_.for_each_outgoing(c.removed, [&](Index h) { relax(decimation_.end(h)); });
      if (++alive < next_sweep) continue;
      next_sweep = 2 * alive;
      sweep();
      sweep();
    }
    for (int i = 0; i < sweeps; ++i)
      sweep();
  }

 private:
  void sweep() {
    for (Index v = 0; v < polycube_.size(); ++v) {
      if (v % 1024 == 0) host_.report("refinement", 0, 0);
      if (decimation_.outgoing[v] != no_index) relax(v);
    }
  }

  // Axes along which a vertex may move: those of no patch that it is on.
  std::array<bool, 3> free_axes(Index vertex) const {
    std::array<bool, 3> result = {true, true, true};
    decimation_.for_each_outgoing(vertex,
                                  [&](Index h) { result[static_cast<std::size_t>(axis_of(labels_[h / 3]))] = false; });
    return result;
  }

  void gather_star(Index vertex) {
    star_.clear();
    const Vector3& p = surface_.positions[vertex];
    decimation_.for_each_outgoing(vertex, [&](Index h) {
      const AxisLabel label = labels_[h / 3];
      StarTriangle t;
      t.axes = {(axis_of(label) + 1) % 3, (axis_of(label) + 2) % 3};
      if (sign_of(label) < 0) std::swap(t.axes[0], t.axes[1]);
      const Index x = decimation_.end(h), y = decimation_.start(Connectivity::previous(h));
      t.x = t.in_plane(polycube_[x]);
      t.y = t.in_plane(polycube_[y]);
      const Vector3 e = surface_.positions[x] - p, g = surface_.positions[y] - p;
      // Slivers are widened a little, so that cotangents stay finite.
      constexpr double min_height = 1e-7;
      t.area = std::max({0.5 * e.cross(g).norm(), min_height * std::max(e.squaredNorm(), g.squaredNorm()), 1e-300});
      const double scale = 0.5 / t.area;
      t.at_p = scale * e.dot(g);
      t.at_x = scale * -e.dot(g - e);
      t.at_y = scale * g.dot(g - e);
      star_.push_back(t);
    });
  }

  bool positive(const Vector3& p) const {
    return std::all_of(star_.begin(), star_.end(),
                       [&](const StarTriangle& t) { return mesh::orientation_2d(t.in_plane(p), t.x, t.y) > 0; });
  }

  double energy(const Vector3& place) const {
    double sum = 0;
    for (const StarTriangle& t : star_) {
      const Vector2 p = t.in_plane(place);
      const Vector2 a = t.x - p, b = t.y - p;
      const double d = 0.5 * (a.x() * b.y() - a.y() * b.x()) / t.area;
      if (!(d > 0)) return std::numeric_limits<double>::infinity();
      const double squares =
          (t.at_y * a.squaredNorm() + t.at_x * b.squaredNorm() + t.at_p * (t.x - t.y).squaredNorm()) / (2 * t.area);
      sum += t.area * (squares / d + lambda_ * (d + 1 / d));
    }
    return sum;
  }

  // One step of Newton's method on the vertex; it stays where it is when that lowers nothing.
  void relax(Index vertex) {
    const std::array<bool, 3> free = free_axes(vertex);
    if (!free[0] && !free[1] && !free[2]) return;
    gather_star(vertex);
    Vector3 gradient = Vector3::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    double before = 0;
    for (const StarTriangle& t : star_) {
      const Vector2 p = t.in_plane(polycube_[vertex]);
      const Vector2 a = t.x - p, b = t.y - p;
      const double d = 0.5 * (a.x() * b.y() - a.y() * b.x()) / t.area;
      if (!(d > 0)) return;  // below the smallest number: leave it
      const Vector2 slope = 0.5 / t.area * Vector2(t.x.y() - t.y.y(), t.y.x() - t.x.x());
      const double squares =
          (t.at_y * a.squaredNorm() + t.at_x * b.squaredNorm() + t.at_p * (t.x - t.y).squaredNorm()) / (2 * t.area);
      const Vector2 pull = -(t.at_y * a + t.at_x * b) / t.area;
      const Vector2 g = pull / d - squares / (d * d) * slope + lambda_ * (1 - 1 / (d * d)) * slope;
      const Eigen::Matrix2d mixed = pull * slope.transpose();
      const Eigen::Matrix2d h = (t.at_x + t.at_y) / (t.area * d) * Eigen::Matrix2d::Identity() -
                                (mixed + mixed.transpose()) / (d * d) +
                                2 * (squares + lambda_) / (d * d * d) * slope * slope.transpose();
      before += t.area * (squares / d + lambda_ * (d + 1 / d));
      for (std::size_t i = 0; i < 2; ++i) {
        const auto r = static_cast<Eigen::Index>(i);
        gradient[t.axes[i]] += t.area * g[r];
        for (std::size_t j = 0; j < 2; ++j)
          hessian(t.axes[i], t.axes[j]) += t.area * h(r, static_cast<Eigen::Index>(j));
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (free[static_cast<std::size_t>(axis)]) continue;
      gradient[axis] = 0;
      hessian.row(axis).setZero();
      hessian.col(axis).setZero();
      hessian(axis, axis) = 1;
    }
    const Vector3 step = -hessian.ldlt().solve(gradient);
    if (!step.allFinite() || !(gradient.dot(step) < 0)) return;
    Vector3 place;
    const auto energy_after = [&](double length) {
      place = polycube_[vertex];
      for (int axis = 0; axis < 3; ++axis) {
        if (free[static_cast<std::size_t>(axis)]) place[axis] += length * step[axis];
      }
      return energy(place);
    };
    const base::Backtracking any_decrease{.max_trials = 12, .decrease = 0, .strict = true};
    if (base::backtrack(before, 0, any_decrease, energy_after, [&] { return positive(place); }))
      polycube_[vertex] = place;
  }

  void insert(const Collapse& c) {
    const std::array<bool, 3> free = free_axes(c.removed);
    polycube_[c.removed] = polycube_[c.kept];
    gather_star(c.removed);
    const auto count = std::count(free.begin(), free.end(), true);
    if (count == 2 && place_inside(c)) return;
    if (count == 1 && place_along(c, free)) return;
    throw base::Error("no-valid-result",
                      "rounding leaves vertex " + std::to_string(c.removed) + " no place in the map");
  }

  // Half-planes of the star clip its own box; the middle of the remaining polygon is the position.
  bool place_inside(const Collapse& c) {
    const StarTriangle& first = star_.front();
    Vector2 low = first.x, high = first.x;
    for (const StarTriangle& t : star_) {
      low = low.cwiseMin(t.x);
      high = high.cwiseMax(t.x);
    }
    polygon_.assign({low, Vector2(high.x(), low.y()), high, Vector2(low.x(), high.y())});
    for (const StarTriangle& t : star_) {
      const auto side = [&](const Vector2& p) {
        const Vector2 e = t.y - t.x, f = p - t.x;
        return e.x() * f.y() - e.y() * f.x();
      };
      clipped_.clear();
      for (std::size_t i = 0; i < polygon_.size(); ++i) {
        const Vector2& p = polygon_[i];
        const Vector2& q = polygon_[i + 1 < polygon_.size() ? i + 1 : 0];
        const double at_p = side(p), at_q = side(q);
        if (at_p >= 0) clipped_.push_back(p);
        if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) clipped_.push_back(p + at_p / (at_p - at_q) * (q - p));
      }
      std::swap(polygon_, clipped_);
      if (polygon_.empty()) return false;
    }
    Vector2 middle = Vector2::Zero();
    for (const Vector2& p : polygon_)
      middle += p / static_cast<double>(polygon_.size());
    Vector3 place = polycube_[c.kept];
    place[first.axes[0]] = middle.x();
    place[first.axes[1]] = middle.y();
    if (!positive(place)) return false;
    polycube_[c.removed] = place;
    return true;
  }

  // Half-planes of the star bound an interval along the free axis.
  bool place_along(const Collapse& c, const std::array<bool, 3>& free) {
    const int axis = free[0] ? 0 : (free[1] ? 1 : 2);
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    const Vector3 origin = polycube_[c.kept];
    for (const StarTriangle& t : star_) {
      const Vector2 e = t.y - t.x, f = t.in_plane(origin) - t.x;
      const double constant = e.x() * f.y() - e.y() * f.x();
      const double slope = t.axes[0] == axis ? -e.y() : e.x();
      if (slope == 0) continue;
      const double root = origin[axis] - constant / slope;
      if (slope > 0)
        low = std::max(low, root);
      else
        high = std::min(high, root);
    }
    if (!(low < high)) return false;
    Vector3 place = origin;
    if (std::isinf(low)) low = origin[axis];
    if (std::isinf(high)) high = origin[axis];
    place[axis] = 0.5 * (low + high);
    if (!positive(place)) return false;
    polycube_[c.removed] = place;
    return true;
  }

  const Surface& surface_;
  std::span<const AxisLabel> labels_;
  Decimation& decimation_;
  double lambda_;
  std::span<Vector3> polycube_;
  const base::Host& host_;
  Array<StarTriangle> star_;
  Array<Vector2> polygon_, clipped_;
};

}  // namespace

void refine_map(const Surface& surface, std::span<const AxisLabel> labels, Decimation& decimation, double area_weight,
                int sweeps, std::span<Vector3> polycube, const base::Host& host) {
  MapRefinement(surface, labels, decimation, area_weight, polycube, host).run(sweeps);
}

}  // namespace orbicube::polycube
