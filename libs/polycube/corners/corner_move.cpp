#include "polycube/corners/corner_move.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/infinity.h"
#include "mesh/search/planar.h"
#include "polycube/corners/corner_newton.h"

namespace orbicube::polycube {
namespace {

using mesh::cross;

// A point with less of a corner's weight lies on the edge opposite to it.
constexpr double min_weight = 0.1;

// The disk is taken to itself, r to the origin: along each segment from r to the circle in proportion.
Vector2d recentred(const Vector2d& p, const Vector2d& r) {
  if (!(p.squaredNorm() < 1)) return p;
  const Vector2d d = p - r;
  const double square = d.squaredNorm();
  if (!(square > 0)) return Vector2d::Zero();
  const double along = r.dot(d);
  const double reach = (-along + std::sqrt(along * along + square * (1 - r.squaredNorm()))) / square;
  return r / reach + d;
}

}  // namespace

CornerMove::CornerMove(const CornerRegion& region, double whole_area, const CornerMoveOptions& options,
                       const base::Host& host)
    : region_(region),
      whole_area_(whole_area),
      options_(options),
      host_(host),
      triangles_(host.memory),
      turns_(host.memory),
      space_(host.memory),
      angle_(host.memory),
      slot_(host.memory),
      value_(host.memory),
      relaxed_(host.memory),
      planar_(host.memory) {
  place_.face = 0;
  place_.weights = {0, 0, 0};
  place_.weights[static_cast<std::size_t>(std::find(region.triangles[0].begin(), region.triangles[0].end(), 0U) -
                                          region.triangles[0].begin())] = 1;
  split();
  number(0);
  for (Index v = 0; v < region.vertices.size(); ++v) {
    value_[2 * slot_[v]] = region.cone[v].x();
    value_[2 * slot_[v] + 1] = region.cone[v].y();
    angle_[v] = region.angle[v] * 4 / region.quarters;
  }
  if (!wind()) return;
  fill();
  energy_now_ = planar_.energy(value_, options.area_weight);
}

double CornerMove::evaluate(const Vector2d& at, Vector2d* gradient) {
  if (!(at.norm() < 1) || !locate(region_.flat, at, min_weight)) return base::infinity;
  if (!split()) return base::infinity;
  number(apex_);
  start(apex_flat_);
  if (!wind()) return base::infinity;
  fill();
  const std::size_t free = 2 * (region_.inside - (added() ? 0 : 1));
  if (free == 0) return planar_.energy(value_, options_.area_weight);
  untangle::PlanarNewton newton(planar_, free, corner_newton, host_);
  if (!newton.untangle(value_, corner_schedule(options_.untangling_steps, options_.area_weight))) return base::infinity;
  newton.polish(value_, options_.steps, options_.min_gain, options_.area_weight);
  const double energy = planar_.energy(value_, options_.area_weight);
  if (gradient != nullptr) *gradient = slope();
  return energy;
}

double CornerMove::relax() {
  base::require(region_.quarters == 4, "a corner does not move like other points");
  triangles_ = region_.triangles;
  space_ = region_.space;
  turns_.assign(triangles_.size(), {0, 0, 0});
  number(no_index);
  for (Index v = 0; v < space_.size(); ++v) {
    value_[2 * slot_[v]] = region_.cone[v].x();
    value_[2 * slot_[v] + 1] = region_.cone[v].y();
  }
  fill();
  if (!std::isfinite(planar_.energy(value_, options_.area_weight))) return base::infinity;
  untangle::PlanarNewton(planar_, 2 * region_.inside, corner_newton, host_)
      .polish(value_, options_.steps, options_.min_gain, options_.area_weight);
  const double energy = planar_.energy(value_, options_.area_weight);
  relaxed_.clear();
  for (Index v = 0; v < space_.size(); ++v)
    relaxed_.push_back(position(v));
  // A vertex at the origin, where the map does not change by it, or one that is there but for rounding.
  constexpr double rounding = 1e-9;
  if (!locate(relaxed_, Vector2d::Zero(), rounding) || !split()) return base::infinity;
  number(apex_);
  for (Index v = 0; v < relaxed_.size(); ++v) {
    if (v == apex_) continue;
    const double angle = std::atan2(relaxed_[v].y(), relaxed_[v].x());
    angle_[v] = angle < 0 ? angle + 2 * std::numbers::pi : angle;
    value_[2 * slot_[v]] = relaxed_[v].x();
    value_[2 * slot_[v] + 1] = relaxed_[v].y();
  }
  return wind() ? energy : base::infinity;
}

bool CornerMove::locate(std::span<const Vector2d> points, const Vector2d& at, double least) {
  for (Index f = 0; f < region_.triangles.size(); ++f) {
    const auto& [a, b, c] = region_.triangles[f];
    const Vector2d p = points[a] - at, q = points[b] - at, r = points[c] - at;
    std::array<double, 3> weights = {cross(q, r), cross(r, p), cross(p, q)};
    const double sum = weights[0] + weights[1] + weights[2];
    if (!(sum > 0) || weights[0] < 0 || weights[1] < 0 || weights[2] < 0) continue;
    double left = 0;
    for (double& w : weights) {
      w /= sum;
      if (w < least) w = 0;
      left += w;
    }
    for (double& w : weights)
      w /= left;
    place_ = {f, weights};
    return true;
  }
  return false;
}

// The triangles of the region, those at the corner's place split; false when that is on the region's boundary.
bool CornerMove::split() {
  triangles_ = region_.triangles;
  space_ = region_.space;
  const Triangle t = triangles_[place_.face];
  const auto& w = place_.weights;
  const auto zeros = std::count(w.begin(), w.end(), 0.0);
  apex_flat_ = w[0] * region_.flat[t[0]] + w[1] * region_.flat[t[1]] + w[2] * region_.flat[t[2]];
  if (zeros == 2) {
    apex_ = t[static_cast<std::size_t>(std::find_if(w.begin(), w.end(), [](double x) { return x > 0; }) - w.begin())];
    return apex_ < region_.inside;
  }
  apex_ = static_cast<Index>(region_.vertices.size());
  space_.push_back(w[0] * space_[t[0]] + w[1] * space_[t[1]] + w[2] * space_[t[2]]);
  if (zeros == 0) {
    triangles_[place_.face] = {t[0], t[1], apex_};
    triangles_.push_back({t[1], t[2], apex_});
    triangles_.push_back({t[2], t[0], apex_});
    return true;
  }
  const auto split_edge = [&](std::size_t f, std::size_t k) {
    const Triangle old = triangles_[f];
    triangles_[f] = {old[k], apex_, old[(k + 2) % 3]};
    triangles_.push_back({apex_, old[(k + 1) % 3], old[(k + 2) % 3]});
  };
  const auto k = static_cast<std::size_t>(std::find(w.begin(), w.end(), 0.0) - w.begin());
  const Index a = t[(k + 1) % 3], b = t[(k + 2) % 3];
  split_edge(place_.face, (k + 1) % 3);
  for (std::size_t f = 0; f < region_.triangles.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (triangles_[f][i] != b || triangles_[f][(i + 1) % 3] != a) continue;
      split_edge(f, i);
      return true;
    }
  }
  return false;
}

// Free vertices first: all that may move but the apex.
void CornerMove::number(Index apex) {
  const std::size_t count = space_.size();
  slot_.resize(count);
  value_.assign(2 * count, 0.0);
  angle_.assign(count, 0.0);
  Index next = 0;
  for (Index v = 0; v < region_.inside; ++v)
    if (v != apex) slot_[v] = next++;
  for (Index v = 0; v < count; ++v)
    if (v == apex || v >= region_.inside) slot_[v] = next++;
}

void CornerMove::start(const Vector2d& from) {
  const double turns = 4.0 / region_.quarters;
  for (Index v = 0; v < space_.size(); ++v) {
    if (v == apex_) continue;
    Vector2d p = region_.cone[v];
    angle_[v] = turns * region_.angle[v];
    if (v < region_.inside && from != Vector2d::Zero()) {
      const Vector2d flat = recentred(region_.flat[v], from);
      const double angle = std::atan2(flat.y(), flat.x());
      angle_[v] = angle < 0 ? angle + 2 * std::numbers::pi : angle;
      const double radius = region_.radius * std::pow(flat.norm(), 1 / turns);
      p = {radius * std::cos(angle_[v] / turns), radius * std::sin(angle_[v] / turns)};
    }
    value_[2 * slot_[v]] = p.x();
    value_[2 * slot_[v] + 1] = p.y();
  }
}

// By how many quarters corners are turned to lie beside the first of their triangle; whether the apex and no other
// point is gone around.
bool CornerMove::wind() {
  turns_.resize(triangles_.size());
  int around = 0;
  for (std::size_t f = 0; f < triangles_.size(); ++f) {
    const Triangle& t = triangles_[f];
    const auto apex = static_cast<std::size_t>(std::find(t.begin(), t.end(), apex_) - t.begin());
    // Whole turns to go from one corner to the next, the short way.
    const auto whole = [&](Index a, Index b) {
      const double step = angle_[b] - angle_[a];
      return step > std::numbers::pi ? -1 : step < -std::numbers::pi ? 1 : 0;
    };
    turns_[f] = {0, 0, 0};
    if (apex < 3) {
      const std::size_t k = (apex + 1) % 3, next = (apex + 2) % 3;
      const int turn = whole(t[k], t[next]);
      turns_[f][next] = turn * region_.quarters;
      around += turn;
    } else {
      const int first = whole(t[0], t[1]), second = whole(t[1], t[2]), third = whole(t[2], t[0]);
      if (first + second + third != 0) return false;
      turns_[f][1] = first * region_.quarters;
      turns_[f][2] = -third * region_.quarters;
    }
  }
  return around == 1;
}

void CornerMove::fill() {
  planar_.clear();
  for (std::size_t f = 0; f < triangles_.size(); ++f) {
    const Triangle& t = triangles_[f];
    std::array<Index, 6> coordinates{};
    std::array<double, 6> signs{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Index x = 2 * slot_[t[k]], y = x + 1;
      const int turn = turns_[f][k] & 3;
      coordinates[2 * k] = turn % 2 == 0 ? x : y;
      coordinates[2 * k + 1] = turn % 2 == 0 ? y : x;
      signs[2 * k] = turn == 0 || turn == 3 ? 1 : -1;
      signs[2 * k + 1] = turn == 0 || turn == 1 ? 1 : -1;
    }
    planar_.add({space_[t[0]], space_[t[1]], space_[t[2]]}, coordinates, signs, whole_area_, options_.min_area);
  }
}

// With images where they are, a triangle's energy is (sum over corners of dot |opposite side|^2 / (4 B) + lambda (B +
// A^2 / B)) / 2 over the whole area, for areas A in space and B on the polycube and the scalar products `dot` of the
// edges at each corner: a polynomial in the place of the apex in space.
Vector2d CornerMove::slope() const {
  Vector3 by_place = Vector3::Zero();
  Eigen::Matrix<double, 3, 2> moves = Eigen::Matrix<double, 3, 2>::Zero();  // of the place with the point of `flat`
  double weight = 0;
  const auto tangent = [&](const Triangle& t) {
    Eigen::Matrix2d flat;
    flat << region_.flat[t[1]] - region_.flat[t[0]], region_.flat[t[2]] - region_.flat[t[0]];
    Eigen::Matrix<double, 3, 2> space;
    space << region_.space[t[1]] - region_.space[t[0]], region_.space[t[2]] - region_.space[t[0]];
    return Eigen::Matrix<double, 3, 2>(space * flat.inverse());
  };
  for (std::size_t f = 0; f < triangles_.size(); ++f) {
    const Triangle& t = triangles_[f];
    const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), apex_) - t.begin());
    if (k == 3) continue;
    const Index b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    const Vector3 &x = space_[apex_], &y = space_[b], &z = space_[c];
    const Vector2d u = turned_by(position(b), turns_[f][(k + 1) % 3]);
    const Vector2d v = turned_by(position(c), turns_[f][(k + 2) % 3]);
    const double image = 0.5 * cross(u, v);
    const Vector3 normal = (y - x).cross(z - x);
    const Vector3 dots =
        (2 * x - y - z) * (u - v).squaredNorm() + (z - y) * v.squaredNorm() + (y - z) * u.squaredNorm();
    // A^2 = |normal|^2 / 4, and the normal changes by dx x (y - z).
    const Vector3 square = 0.5 * (y - z).cross(normal);
    Vector3 change = 0.5 * (dots / (4 * image) + options_.area_weight * square / image);
    const double area = 0.5 * normal.norm();
    if (area < options_.min_area) {
      const double sum = (y - x).dot(z - x) * (u - v).squaredNorm() + (z - y).dot(x - y) * v.squaredNorm() +
                         (x - z).dot(y - z) * u.squaredNorm();
      const double whole = 0.5 * (sum / (4 * image) + options_.area_weight * (image + area * area / image));
      change = options_.min_area * (change / area - whole / (2 * area * area * area) * square);
    }
    by_place += change / whole_area_;
    if (!added()) {
      const double own = normal.norm();
      moves += own * tangent(t);
      weight += own;
    }
  }
  if (added()) {
    moves = tangent(region_.triangles[place_.face]);
    weight = 1;
  }
  return moves.transpose() * by_place / weight;
}

}  // namespace orbicube::polycube
