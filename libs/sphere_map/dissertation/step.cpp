#include "sphere_map/dissertation/step.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sphere_optimizer/great_circle.h"
#include "sphere_optimizer/spheres.h"

namespace orbicube::sphere_map::dissertation {
namespace {

using Dimension = sphere_optimizer::FixedDimension<3>;

constexpr double min_violation = 1e-9;        // epsilon: of rho
constexpr double sufficient_decrease = 1e-4;  // delta
constexpr int max_halvings = 60;

struct Gradient {
  double value = 0;
  Vector3 whole = Vector3::Zero();  // in space, the radial part included
};

// Gradient of d^2 at p, where d is the distance from the origin to the triangle. The nearest point is the center of the
// triangle's smallest enclosing circle; it moves with p by its barycentric coordinate.
Vector3 distance_square_gradient(const SphericalTriangle& t, const Vector3& p, const Vector3& q, const Vector3& r) {
  if (t.acute) {
    const double barycentric = t.square_p * (t.square_q + t.square_r - t.square_p) / (4 * t.N);
    return 2 * barycentric * t.determinant / t.N * t.normal;
  }
  if (t.square_q >= t.square_p && t.square_q >= t.square_r) return 0.5 * (p + r);
  if (t.square_r >= t.square_p && t.square_r >= t.square_q) return 0.5 * (p + q);
  return Vector3::Zero();
}

// The largest (K + 1/K) / 2 of the star's triangles, where K is the quasi-conformal distortion.
double worst_quasi_conformal(std::span<const StarTriangle> star, const Vector3& position,
                             std::span<const Vector3> directions) {
  double worst = 0;
  for (const StarTriangle& s : star) {
    const SphericalTriangle t(position, directions[s.q], directions[s.r]);
    worst = std::max(worst, 0.5 * t.D(s.shape) / t.determinant);
  }
  return worst;
}

// What d^-2 multiplies.
double inner_energy(const PrintedEnergy& energy, const TriangleShape& shape, const SphericalTriangle& t) {
  return energy.angle_weight * t.D(shape) + energy.area_weight * t.N / (4 * shape.area * energy.area_scale);
}

Gradient gradient_of(const PrintedEnergy& energy, std::span<const StarTriangle> star, const Vector3& p,
                     std::span<const Vector3> directions) {
  Gradient sum;
  for (const StarTriangle& s : star) {
    const Vector3& q = directions[s.q];
    const Vector3& r = directions[s.r];
    const SphericalTriangle t(p, q, r);
    const double d2 = t.inverse_d_square();
    const double inner = inner_energy(energy, s.shape, t);
    const Vector3 gradient_D = -2 * (s.shape.cot_q * t.edge_q + s.shape.cot_r * t.edge_r);
    const Vector3 gradient_N = 2 * t.edge_p.cross(t.normal);
    sum.value += d2 * inner;
    sum.whole += d2 * (energy.angle_weight * gradient_D +
                       energy.area_weight / (4 * s.shape.area * energy.area_scale) * gradient_N) -
                 d2 * d2 * inner * distance_square_gradient(t, p, q, r);
  }
  return sum;
}

Vector3 tangent_part(const Vector3& whole, const Vector3& p) {
  Vector3 tangent = whole;
  sphere_optimizer::make_tangent(Dimension{}, p.data(), tangent.data());
  return tangent;
}

// How far the great circle from p along `direction` goes until it meets the ring (`link`), and until it leaves the
// kernel, which is no later.
struct Reach {
  double link = std::numbers::pi;
  double kernel = std::numbers::pi;
};

Reach reach_of(const Vector3& p, const Vector3& direction, std::span<const StarTriangle> star,
               std::span<const Vector3> directions) {
  Reach reach;
  const Vector3 side = p.cross(direction);
  for (const StarTriangle& s : star) {
    const SphericalTriangle t(p, directions[s.q], directions[s.r]);
    const Vector3 circle = t.normal - p.cross(t.edge_p);  // q x r, by differences
    reach.kernel = std::min(reach.kernel, std::atan2(t.determinant, -circle.dot(direction)));
    const double left_q = t.edge_r.dot(side);
    const double left_r = t.edge_q.dot(side);
    if (left_q <= 0 && left_r > 0) {
      const Vector3 from_p = left_r * t.edge_r - left_q * t.edge_q;  // to the crossing, times left_r - left_q
      reach.link = std::atan2(from_p.dot(direction), left_r - left_q + from_p.dot(p));
    }
  }
  return reach;
}

}  // namespace

double triangle_energy(const PrintedEnergy& energy, const TriangleShape& shape, const Vector3& p, const Vector3& q,
                       const Vector3& r) {
  const SphericalTriangle t(p, q, r);
  return t.inverse_d_square() * inner_energy(energy, shape, t);
}

double star_energy(const PrintedEnergy& energy, std::span<const StarTriangle> star, const Vector3& position,
                   std::span<const Vector3> directions) {
  double sum = 0;
  for (const StarTriangle& s : star)
    sum += triangle_energy(energy, s.shape, position, directions[s.q], directions[s.r]);
  return sum;
}

double priority(const PrintedEnergy& energy, Index vertex, std::span<const StarTriangle> star,
                std::span<const Vector3> directions) {
  const Vector3& p = directions[vertex];
  double distance = 0;
  for (const StarTriangle& s : star)
    distance += (directions[s.q] - p).norm();
  const Gradient gradient = gradient_of(energy, star, p, directions);
  return tangent_part(gradient.whole, p).norm() * distance / static_cast<double>(star.size());
}

double great_circle_search(const PrintedEnergy& energy, Index vertex, std::span<const StarTriangle> star,
                           std::span<Vector3> directions) {
  const Vector3 p = directions[vertex];
  const Gradient gradient = gradient_of(energy, star, p, directions);
  const Vector3 tangent = tangent_part(gradient.whole, p);
  const double violation = tangent.norm();
  if (!(violation > min_violation)) return 0;

  const Vector3 direction = -tangent / violation;
  const double allowed = std::max(energy.max_quasi_conformal, worst_quasi_conformal(star, p, directions));
  const Reach reach = reach_of(p, direction, star, directions);
  const bool first_case = gradient.whole.dot(p) <= 0;
  double angle =
      first_case ? reach.link : sphere_optimizer::printed_angle(Dimension{}, p.data(), gradient.whole.data());
  // (p + u) / |p + u| halves the arc. Points beyond the kernel would be refused, so none is tried.
  while (angle >= reach.kernel)
    angle *= 0.5;
  for (int trial = 0; trial < max_halvings; ++trial, angle *= 0.5) {
    Vector3 candidate, velocity;
    sphere_optimizer::move(Dimension{}, p.data(), direction.data(), angle, candidate.data(), velocity.data());
    const double value = star_energy(energy, star, candidate, directions);
    const double bound = gradient.value + sufficient_decrease * (candidate - p).dot(gradient.whole);
    if (!(value <= bound && value < gradient.value)) continue;
    const bool inside = std::all_of(star.begin(), star.end(), [&](const StarTriangle& s) {
      return safely_positive(candidate, directions[s.q], directions[s.r]);
    });
    if (!inside || worst_quasi_conformal(star, candidate, directions) > allowed) continue;
    directions[vertex] = candidate;
    return gradient.value - value;
  }
  return 0;
}

}  // namespace orbicube::sphere_map::dissertation
