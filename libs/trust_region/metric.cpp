// Coordinates in which the objective bends about equally much in all directions. Radii, distances and Frobenius norms
// then count what matters to f: as variable-metric methods are less hurt by bad scaling than steepest descent is, least
// changes of Hessians in the right norm and round trust regions are less hurt too. Without bounds only, since boxes
// must stay boxes.
#include <algorithm>
#include <cmath>

#include "trust_region/dense.h"
#include "trust_region/solver.h"

namespace orbicube::trust_region {
namespace {

// Lengths along eigenvectors of the Hessian are multiplied by |eigenvalue|^(1/4), half of what would make the Hessian's
// eigenvalues equal, so that a model that is wrong does no harm that the next change cannot undo.
constexpr double power = 0.25;
// Eigenvalues of less than this part of the largest count as this part: noise of the interpolation.
constexpr double floor_of_eigenvalues = 1e-6;
// Not worth a rebuild where lengths would differ by less.
constexpr double min_change = 2;
// Poor steps after which coordinates may change, and evaluations since the last change, in units of n + 1.
constexpr std::uint64_t poor_steps = 3, wait = 3;

}  // namespace

bool Solver::wants_metric() const {
  const std::size_t n = variables_.free_size();
  return !variables_.bounded() && !models_.has_corners() && state_.next == Next::step &&
         options_.method == Method::two_radii && state_.poor_steps >= poor_steps &&
         interpolation_.size() >= 2 * n + 1 && n >= 2 && n <= Variables::max_turned &&
         state_.evaluations - state_.metric_at >= wait * (n + 1);
}

bool Solver::adapt_metric() {
  const std::size_t n = variables_.free_size(), best = interpolation_.best();
  state_.metric_at = state_.evaluations;
  state_.poor_steps = 0;
  std::fill(move_.begin(), move_.end(), 0.0);
  models_.expand(move_.data(), best, gradient_.data(), eigen_.matrix());
  double* values = move_.data();
  double* vectors = basis_.data();
  if (!eigen_.eigen(n, values, vectors)) return false;
  double most = 0, least = 0;
  for (std::size_t i = 0; i < n; ++i)
    most = std::max(most, std::abs(values[i]));
  if (!(most > 0) || !std::isfinite(most)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    values[i] = std::pow(std::max(std::abs(values[i]) / most, floor_of_eigenvalues), power);
    least = i == 0 ? values[i] : std::min(least, values[i]);
  }
  if (!(1 / least >= min_change)) return false;
  // The longest and the shortest axis change by the same factor. Then T is divided by its largest stretch, so that a
  // length of u is one of x / scale along that axis.
  const double middle = std::sqrt(least);
  double* matrix = hessian_.data();
  const auto fill = [&](double factor, bool inverse) {
    std::fill_n(matrix, n * n, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
      const double length = values[k] / middle;
      add_square_lower(matrix, n, n, factor * (inverse ? 1 / length : length), vectors + k * n);
    }
    mirror_lower(matrix, n);
  };
  fill(1, true);
  variables_.transform(matrix);
  const double stretch = variables_.normalize(eigen_, candidate_.data());
  fill(1 / stretch, true);
  models_.transform(matrix);
  fill(stretch, false);
  multiply(matrix, n, n, n, interpolation_.point(best), candidate_.data());
  edges_.transform(matrix, interpolation_.point(best), candidate_.data());
  interpolation_.transform(matrix, candidate_.data());
  state_.radius *= stretch;
  state_.resolution = std::max(state_.resolution * stretch, options_.radius_end);
  state_.radius = std::max(state_.radius, state_.resolution);
  return true;
}

}  // namespace orbicube::trust_region
