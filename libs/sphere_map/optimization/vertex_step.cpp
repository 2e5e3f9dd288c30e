#include "sphere_map/optimization/vertex_step.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/backtracking.h"

namespace orbicube::sphere_map {
namespace {

using Eigen::Vector2d;

// Energy, gradient and Hessian of a star in the tangent plane of its vertex.
struct StarModel {
  double value = 0;
  Vector2d gradient = Vector2d::Zero();
  double h00 = 0, h01 = 0, h11 = 0;
  double radial = 0;  // gradient . p: the curvature of the sphere takes it off the Hessian
  double nearest_square = std::numeric_limits<double>::infinity();
};

// Gradient of the squared radius R^2 of the triangle's smallest enclosing circle, in tangent coordinates. The distance
// to the origin is d^2 = 1 - R^2.
Vector2d circumradius_gradient(const SphericalTriangle& t, const Vector2d& edge_q, const Vector2d& edge_r,
                               const Vector2d& gradient_N) {
  if (t.acute) {
    return t.circumradius_square * (-2 / t.square_r * edge_r - 2 / t.square_q * edge_q - gradient_N / t.N);
  }
  if (t.square_q >= t.square_p && t.square_q >= t.square_r) return -0.5 * edge_q;
  if (t.square_r >= t.square_p && t.square_r >= t.square_q) return -0.5 * edge_r;
  return Vector2d::Zero();
}

StarModel model_of(const Energy& energy, std::span<const StarTriangle> star, const Vector3& p,
                   std::span<const Vector3> directions, const TangentBasis& basis, StepScratch& scratch) {
  StarModel m;
  scratch.heights.resize(star.size());
  const auto tangent = [&](const Vector3& x) { return Vector2d(x.dot(basis.first), x.dot(basis.second)); };
  for (std::size_t i = 0; i < star.size(); ++i) {
    const TriangleShape& s = star[i].shape;
    const SphericalTriangle t(p, directions[star[i].q], directions[star[i].r]);
    const EnergyPartials e = energy_partials(energy, s, t);
    m.nearest_square = std::min({m.nearest_square, t.square_q, t.square_r});

    const Vector3 gradient_D = -2 * s.cot_q * t.edge_q - 2 * s.cot_r * t.edge_r;
    const Vector3 gradient_N = 2 * t.edge_p.cross(t.normal);
    const Vector3 gradient_det = t.normal - p.cross(t.edge_p);  // q x r, by differences
    const Vector2d D = tangent(gradient_D);
    const Vector2d N = tangent(gradient_N);
    const Vector2d det = tangent(gradient_det);
    const Vector2d M = 2 * t.determinant * det;
    const Vector2d across = tangent(t.edge_p);
    scratch.heights[i] = {t.determinant, det.x(), det.y()};

    m.value += e.value;
    m.gradient += e.by_D * D + e.by_N * N + e.by_M * M;
    m.radial += e.by_D * (s.cot_q * t.square_q + s.cot_r * t.square_r) + e.by_N * gradient_N.dot(p) +
                e.by_M * 2 * t.determinant * t.determinant;
    // Second derivatives: of D 2 (cot_q + cot_r) I, of N 2 (|e|^2 I - e e'), of M 2 det det'.
    const double diagonal = 2 * e.by_D * (s.cot_q + s.cot_r) + 2 * e.by_N * t.square_p;
    const auto second = [&](double x_D, double y_D, double x_M, double y_M, double x_det, double y_det, double x_e,
                            double y_e) {
      return 2 * e.by_M * x_det * y_det - 2 * e.by_N * x_e * y_e + e.by_DD * x_D * y_D +
             e.by_DM * (x_D * y_M + x_M * y_D) + e.by_MM * x_M * y_M;
    };
    m.h00 += diagonal + second(D.x(), D.x(), M.x(), M.x(), det.x(), det.x(), across.x(), across.x());
    m.h01 += second(D.x(), D.y(), M.x(), M.y(), det.x(), det.y(), across.x(), across.y());
    m.h11 += diagonal + second(D.y(), D.y(), M.y(), M.y(), det.y(), det.y(), across.y(), across.y());
    if (t.circumradius_square > 1e-6) {
      const double d2 = t.inverse_d_square();
      m.gradient += d2 * d2 * e.inside_d * circumradius_gradient(t, tangent(t.edge_q), tangent(t.edge_r), N);
    }
  }
  m.h00 -= m.radial;
  m.h11 -= m.radial;
  return m;
}

// Newton's direction with the Hessian's eigenvalues replaced by their absolute values, at least a thousandth of the
// largest.
Vector2d newton_direction(const StarModel& m) {
  const double mean = 0.5 * (m.h00 + m.h11);
  const double difference = 0.5 * (m.h00 - m.h11);
  const double spread = std::hypot(difference, m.h01);
  const double floor =
      std::max(1e-8 * std::max(std::abs(mean + spread), std::abs(mean - spread)), std::numeric_limits<double>::min());
  const double large = std::max(std::abs(mean + spread), floor);
  const double small = std::max(std::abs(mean - spread), floor);
  Vector2d axis(1, 0);  // of the eigenvalue mean + spread
  if (spread > 0) {
    axis = difference >= 0 ? Vector2d(difference + spread, m.h01) : Vector2d(m.h01, spread - difference);
    axis.normalize();
  }
  const Vector2d other(-axis.y(), axis.x());
  return -axis.dot(m.gradient) / large * axis - other.dot(m.gradient) / small * other;
}

}  // namespace

double star_energy(const Energy& energy, std::span<const StarTriangle> star, const Vector3& position,
                   std::span<const Vector3> directions) {
  double sum = 0;
  for (const StarTriangle& s : star) {
    sum += triangle_energy(energy, s.shape, SphericalTriangle(position, directions[s.q], directions[s.r]));
  }
  return sum;
}

StepResult improve_vertex(const Energy& energy, Index vertex, std::span<const StarTriangle> star,
                          std::span<Vector3> directions, StepScratch& scratch) {
  constexpr double part_of_kernel = 0.7;
  constexpr double longest_step = 0.5;
  constexpr double negligible_gain = 1e-10;

  const Vector3 p = directions[vertex];
  const TangentBasis basis(p);
  const StarModel model = model_of(energy, star, p, directions, basis, scratch);
  const Vector2d direction = newton_direction(model);
  const double slope = model.gradient.dot(direction);
  if (!(-slope > negligible_gain * model.value)) return {model.value};

  double length = 1;
  for (const auto& h : scratch.heights) {
    const double change = h.by_first * direction.x() + h.by_second * direction.y();
    if (change < 0) length = std::min(length, part_of_kernel * h.now / -change);
  }
  length = std::min(length, longest_step / direction.norm());
  Vector3 candidate;
  const auto value_after = [&](double by) {
    candidate = (p + by * (direction.x() * basis.first + direction.y() * basis.second)).normalized();
    return star_energy(energy, star, candidate, directions);
  };
  const auto inside = [&] {
    return std::all_of(star.begin(), star.end(), [&](const StarTriangle& s) {
      return safely_positive(candidate, directions[s.q], directions[s.r]);
    });
  };
  const base::Backtracking rule{.first_length = length, .factor = 0.4, .max_trials = 6, .strict = true};
  const auto taken = base::backtrack(model.value, slope, rule, value_after, inside);
  if (!taken) return {model.value};
  directions[vertex] = candidate;
  return {model.value, model.value - taken->value, taken->length * direction.norm() / std::sqrt(model.nearest_square)};
}

}  // namespace orbicube::sphere_map
