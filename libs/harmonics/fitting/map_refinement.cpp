#include "harmonics/fitting/map_refinement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "base/grouping.h"

namespace orbicube::harmonics {
namespace {

// Of the mean squared gradient. Larger: small steps where the fitted surface is stretched little; smaller: wild steps
// where its derivatives vanish.
constexpr double damping = 1e-3;
constexpr double longest_step = 0.3;  // radians
constexpr int halvings = 4;           // of a step that flips a triangle; then the vertex stays for the round
constexpr double least_gain = 1e-3;   // of the residual, or the work ends

using Stars = base::Groups<std::uint32_t, std::uint32_t>;

Stars stars_of(std::size_t vertices, std::span<const Triangle> triangles, const base::Host& host) {
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) {
      if (v >= vertices)
        throw base::Error("index-range", "triangle index " + std::to_string(v) + " of " +
                                             base::counted(vertices, "vertex", "vertices"));
    }
  }
  return base::cells_around(triangles, vertices, host.memory);
}

// 1 or -1 where the triangle keeps its orientation when each coordinate is changed in its last bits, otherwise 0.
int safe_orientation(const Triangle& t, std::span<const Vector3> directions) {
  const Vector3& p = directions[t[0]];
  const Vector3 e = directions[t[1]] - p;
  const Vector3 f = directions[t[2]] - p;
  const double determinant = p.dot(e.cross(f));
  if (!(std::abs(determinant) > 4e-15 * (e.norm() + f.norm()))) return 0;
  return determinant > 0 ? 1 : -1;
}

class Refinement {
 public:
  Refinement(std::span<const Vector3> positions, std::span<const Triangle> triangles, std::span<Vector3> directions,
             const base::Host& host)
      : positions_(positions),
        triangles_(triangles),
        directions_(directions),
        host_(host),
        stars_(stars_of(positions.size(), triangles, host)),
        orientations_(triangles.size(), host.memory),
        fitted_(3 * positions.size(), host.memory),
        gradients_(3 * positions.size(), host.memory) {
    for (std::size_t i = 0; i < triangles.size(); ++i)
      orientations_[i] = static_cast<std::int8_t>(safe_orientation(triangles[i], directions));
  }

  // One step of each vertex.
  void step(const Coefficients& coefficients) {
    synthesise_with_gradients(coefficients, directions_, fitted_, gradients_, host_);
    double sum = 0;
    for (const Vector3& g : gradients_)
      sum += g.squaredNorm();
    damping_ = damping * sum / static_cast<double>(positions_.size());
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      if (v % 4096 == 0) host_.report("map refinement", v, positions_.size());
      if (stars_.size(v) > 0) move(v, wanted(v));
    }
  }

 private:
  // The Gauss-Newton step, tangent at the direction.
  Vector3 wanted(std::size_t v) const {
    const Vector3 rest = positions_[v] - Vector3(fitted_[3 * v], fitted_[3 * v + 1], fitted_[3 * v + 2]);
    Eigen::Matrix3d jacobian;
    for (int c = 0; c < 3; ++c)
      jacobian.row(c) = gradients_[3 * v + static_cast<std::size_t>(c)];
    Eigen::Matrix3d normal = jacobian.transpose() * jacobian;
    normal.diagonal().array() += damping_;
    // Gradients are tangent, so the solution is: along the direction the matrix is damping alone, the right side zero.
    Vector3 step = normal.ldlt().solve(jacobian.transpose() * rest);
    step -= step.dot(directions_[v]) * directions_[v];
    const double length = step.norm();
    return length > longest_step ? Vector3(longest_step / length * step) : step;
  }

  void move(std::size_t v, Vector3 step) {
    const Vector3 from = directions_[v];
    if (!step.allFinite()) return;
    for (int trial = 0; trial <= halvings; ++trial, step *= 0.5) {
      directions_[v] = (from + step).normalized();
      const auto star = stars_[v];
      const bool kept = std::all_of(star.begin(), star.end(), [&](std::uint32_t i) {
        return orientations_[i] != 0 && safe_orientation(triangles_[i], directions_) == orientations_[i];
      });
      if (kept) return;
    }
    directions_[v] = from;
  }

  std::span<const Vector3> positions_;
  std::span<const Triangle> triangles_;
  std::span<Vector3> directions_;
  const base::Host& host_;
  Stars stars_;
  Array<std::int8_t> orientations_;
  Array<double> fitted_;
  Array<Vector3> gradients_;
  double damping_ = 0;
};

}  // namespace

RefinementReport refine_map(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                            std::span<const double> weights, const RefinementOptions& options,
                            std::span<Vector3> directions, const base::Host& host) {
  if (positions.size() != directions.size() || positions.empty())
    throw base::Error("invalid-argument", base::counted(positions.size(), "position") + " but " +
                                              base::counted(directions.size(), "direction"));
  const std::span<const double> values(positions.front().data(), 3 * positions.size());
  const Array<Vector3> unit = unit_directions(directions, host);
  std::copy(unit.begin(), unit.end(), directions.begin());
  Refinement refinement(positions, triangles, directions, host);
  Array<Vector3> best(directions.begin(), directions.end(), host.memory);
  RefinementReport report;
  for (std::uint32_t round = 0;; ++round) {
    const base::Stage stage(host, 1.0 / (options.rounds + 1.0 - round));
    FitReport fitted;
    const Coefficients coefficients = fit(directions, weights, values, 3, options.fit, host, fitted);
    if (round == 0) report.residual_before = report.residual = fitted.residual;
    const bool better = round > 0 && fitted.residual < report.residual;
    const bool enough = round > 0 && !(fitted.residual < (1 - least_gain) * report.residual);
    if (better) {
      report.residual = fitted.residual;
      report.rounds = round;
      std::copy(directions.begin(), directions.end(), best.begin());
    }
    if (enough || round == options.rounds) break;
    refinement.step(coefficients);
  }
  std::copy(best.begin(), best.end(), directions.begin());
  return report;
}

}  // namespace orbicube::harmonics
