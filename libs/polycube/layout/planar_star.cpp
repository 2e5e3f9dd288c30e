#include "polycube/layout/planar_star.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/backtracking.h"
#include "base/infinity.h"
#include "mesh/search/planar.h"
#include "mesh/search/predicates.h"

namespace orbicube::polycube {
namespace {

using mesh::cross;

double& coordinate(Vector3& p, std::size_t axis) {
  return p[static_cast<Eigen::Index>(axis)];
}

}  // namespace

void PlanarStar::gather(const MapView& map, Index vertex) {
  // Triangles of the input may be needles; as flatter than that they do not count.
  constexpr double min_height = 0.01;
  vertex_ = vertex;
  here_ = map.image[vertex];
  triangles_.clear();
  std::array<Index, 2> facets{no_index, no_index};
  std::array<std::size_t, 2> normals{};
  std::size_t facet_count = 0;
  map.surface.for_each_outgoing(vertex, [&](Index h) {
    const Index f = h / 3, p = map.surface.end(h), q = map.surface.end(EditableSurface::next(h));
    StarTriangle t;
    const auto axis = static_cast<std::size_t>(axis_of(map.label[f]));
    t.first = (axis + 1) % 3;
    t.second = (axis + 2) % 3;
    t.sign = sign_of(map.label[f]);
    t.a = flat(t, map.image[p]);
    t.b = flat(t, map.image[q]);
    const auto& positions = map.surface.position;
    const Vector3 first = map.scale * (positions[p] - positions[vertex]);
    const Vector3 second = map.scale * (positions[q] - positions[vertex]);
    const double longest =
        std::sqrt(std::max({first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm()}));
    const double least = map.scale * map.min_length;
    const double base = std::max({first.norm(), min_height * longest, least});
    const double along = first.norm() > 0 ? second.dot(first) / first.norm() : 0;
    const double height = std::max({first.cross(second).norm() / base, min_height * longest, min_height * least});
    t.weight = 0.5 * base * height;
    t.inverse << 1 / base, -along / (base * height), 0, 1 / height;
    triangles_.push_back(t);
    if (facet_count <= 2 && (facet_count == 0 || facets[0] != map.facet[f]) &&
        (facet_count < 2 || facets[1] != map.facet[f])) {
      if (facet_count < 2) {
        facets[facet_count] = map.facet[f];
        normals[facet_count] = axis;
      }
      ++facet_count;
    }
  });
  if (facet_count == 1) {
    freedoms_ = 2;
    axes_ = {(normals[0] + 1) % 3, (normals[0] + 2) % 3};
  } else if (facet_count == 2 && normals[0] != normals[1]) {
    freedoms_ = 1;
    axes_ = {3 - normals[0] - normals[1], 0};
  } else {
    freedoms_ = 0;
  }
}

bool PlanarStar::positive_at(const Vector3& p) const {
  for (const StarTriangle& t : triangles_)
    if (mesh::orientation_2d(flat(t, p), t.a, t.b) <= 0) return false;
  return true;
}

bool PlanarStar::positive() const {
  return positive_at(here_);
}

double PlanarStar::energy_at(const Vector3& p) const {
  double sum = 0;
  for (const StarTriangle& t : triangles_) {
    const Vector2d q = flat(t, p);
    Eigen::Matrix2d edges;
    edges << t.a - q, t.b - q;
    const Eigen::Matrix2d jacobian = edges * t.inverse;
    const double determinant = jacobian.determinant();
    if (!(determinant > 0)) return base::infinity;
    sum += t.weight * jacobian.squaredNorm() * (1 + 1 / (determinant * determinant));
  }
  return sum;
}

// The polygon of points that see the whole ring, by clipping its bounding box (Sutherland and Hodgman 1974).
bool PlanarStar::place_in_face() {
  const StarTriangle& frame = triangles_[0];
  Vector2d low = frame.a, high = frame.a;
  for (const StarTriangle& t : triangles_) {
    low = low.cwiseMin(t.a);
    high = high.cwiseMax(t.a);
  }
  kernel_.assign({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
  for (const StarTriangle& t : triangles_) {
    const Vector2d along = t.b - t.a;
    const auto side = [&](const Vector2d& p) { return cross(along, p - t.a); };
    clipped_.clear();
    for (std::size_t i = 0; i < kernel_.size(); ++i) {
      const Vector2d &p = kernel_[i], &q = kernel_[(i + 1) % kernel_.size()];
      const double at_p = side(p), at_q = side(q);
      if (at_p >= 0) clipped_.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) clipped_.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    std::swap(kernel_, clipped_);
    if (kernel_.empty()) return false;
  }
  double area = 0;
  Vector2d mean = Vector2d::Zero(), centre = Vector2d::Zero();
  for (const Vector2d& p : kernel_)
    mean += p / static_cast<double>(kernel_.size());
  for (std::size_t i = 0; i < kernel_.size(); ++i) {
    const Vector2d p = kernel_[i] - mean, q = kernel_[(i + 1) % kernel_.size()] - mean;
    area += cross(p, q);
    centre += cross(p, q) * (p + q) / 3;
  }
  const auto attempt = [&](const Vector2d& p) {
    Vector3 there = here_;
    coordinate(there, frame.first) = p.x();
    coordinate(there, frame.second) = frame.sign * p.y();
    if (!positive_at(there)) return false;
    here_ = there;
    return true;
  };
  return (area > 0 && attempt(mean + centre / area)) || attempt(mean);
}

bool PlanarStar::place_on_edge() {
  double low = -base::infinity, high = base::infinity;
  for (const StarTriangle& t : triangles_) {
    // Twice the area is constant + slope * s.
    Vector3 p = here_;
    coordinate(p, axes_[0]) = 0;
    const Vector2d q = flat(t, p);
    Vector2d direction = Vector2d::Zero();
    if (t.first == axes_[0])
      direction.x() = 1;
    else
      direction.y() = t.sign;
    const double constant = cross(t.a - q, t.b - q), slope = cross(t.b - t.a, direction);
    if (slope > 0) low = std::max(low, -constant / slope);
    if (slope < 0) high = std::min(high, -constant / slope);
  }
  if (!(low < high) || !std::isfinite(low) || !std::isfinite(high)) return false;
  Vector3 there = here_;
  coordinate(there, axes_[0]) = 0.5 * (low + high);
  if (!positive_at(there)) return false;
  here_ = there;
  return true;
}

bool PlanarStar::place(const MapView& map) {
  const bool placed = freedoms_ == 2 ? place_in_face() : freedoms_ == 1 ? place_on_edge() : positive();
  if (placed) write(map);
  return placed;
}

// Returns nothing where the star is not positive.
std::optional<PlanarStar::Derivatives> PlanarStar::differentiate() const {
  Derivatives now;
  for (const StarTriangle& t : triangles_) {
    const Vector2d q = flat(t, here_);
    Eigen::Matrix2d edges;
    edges << t.a - q, t.b - q;
    const Eigen::Matrix2d j = edges * t.inverse;
    const double d = j.determinant();
    if (!(d > 0)) return std::nullopt;
    // A step s of the vertex changes J by -s r'.
    const Vector2d r = t.inverse.colwise().sum().transpose();
    Eigen::Matrix2d cofactors;
    cofactors << j(1, 1), -j(1, 0), -j(0, 1), j(0, 0);
    const Vector2d of_norm = -2 * (j * r), of_determinant = -(cofactors * r);
    const double norm = j.squaredNorm(), inverse = 1 / (d * d);
    now.value += t.weight * norm * (1 + inverse);
    Vector2d g = t.weight * ((1 + inverse) * of_norm - 2 * norm * inverse / d * of_determinant);
    Eigen::Matrix2d h =
        t.weight * ((1 + inverse) * 2 * r.squaredNorm() * Eigen::Matrix2d::Identity() -
                    2 * inverse / d * (of_norm * of_determinant.transpose() + of_determinant * of_norm.transpose()) +
                    6 * norm * inverse * inverse * of_determinant * of_determinant.transpose());
    g.y() *= t.sign;
    h(0, 1) *= t.sign;
    h(1, 0) *= t.sign;
    if (freedoms_ == 2) {
      now.gradient += g;
      now.hessian += h;
    } else {
      const Eigen::Index k = t.first == axes_[0] ? 0 : 1;
      now.gradient.x() += g[k];
      now.hessian(0, 0) += h(k, k);
    }
  }
  return now;
}

// Returns nothing where there is no direction to go.
std::optional<Vector2d> PlanarStar::newton_step(const Vector2d& gradient, Eigen::Matrix2d hessian) const {
  Vector2d step = Vector2d::Zero();
  if (freedoms_ == 1) {
    if (hessian(0, 0) == 0) return std::nullopt;
    step.x() = -gradient.x() / std::abs(hessian(0, 0));
  } else {
    // Eigenvalues made positive.
    const double mean = 0.5 * (hessian(0, 0) + hessian(1, 1)), half = 0.5 * (hessian(0, 0) - hessian(1, 1));
    const double radius = std::hypot(half, hessian(0, 1));
    if (!(mean + radius > 0)) return std::nullopt;
    if (mean - radius < 1e-3 * (mean + radius)) {
      const double shift = std::abs(mean - radius) + 1e-3 * (mean + radius) - (mean - radius);
      hessian += shift * Eigen::Matrix2d::Identity();
    }
    const double determinant = hessian(0, 0) * hessian(1, 1) - hessian(0, 1) * hessian(1, 0);
    step = -Vector2d(hessian(1, 1) * gradient.x() - hessian(0, 1) * gradient.y(),
                     hessian(0, 0) * gradient.y() - hessian(1, 0) * gradient.x()) /
           determinant;
  }
  return step;
}

double PlanarStar::improve(const MapView& map) {
  if (freedoms_ == 0) return 0;
  const std::optional<Derivatives> now = differentiate();
  if (!now) return 0;
  const std::optional<Vector2d> step = newton_step(now->gradient, now->hessian);
  if (!step) return 0;
  const double slope = now->gradient.dot(*step);
  if (!(slope < 0)) return 0;
  Vector3 there;
  const auto energy_after = [&](double length) {
    there = here_;
    coordinate(there, axes_[0]) += length * step->x();
    if (freedoms_ == 2) coordinate(there, axes_[1]) += length * step->y();
    return energy_at(there);
  };
  const auto taken =
      base::backtrack(now->value, slope, {.max_trials = 12}, energy_after, [&] { return positive_at(there); });
  if (!taken) return 0;
  here_ = there;
  write(map);
  return now->value - taken->value;
}

}  // namespace orbicube::polycube
