#include "harmonics/fitting/conjugate_gradients.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "linear/iterative/conjugate_gradients.h"

namespace orbicube::harmonics {
namespace {

using base::Array;

// Sum of a_i b_i of each column.
void dots(const Array<double>& a, const Array<double>& b, std::size_t channels, Array<double>& out) {
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t i = 0; i < a.size(); i += channels) {
    for (std::size_t c = 0; c < channels; ++c)
      out[c] += a[i + c] * b[i + c];
  }
}

double largest_residual(const Array<linear::ConjugateScalars>& scalars) {
  double largest = 0;
  for (const linear::ConjugateScalars& of_column : scalars) {
    if (of_column.start() > 0) largest = std::max(largest, std::sqrt(of_column.square() / of_column.start()));
  }
  return largest;
}

// From Lanczos's matrix, if it has a row.
void estimate_spectrum(const Array<double>& diagonal, const Array<double>& beside, ConjugateGradientsReport& report) {
  if (diagonal.empty()) return;
  const auto n = static_cast<Eigen::Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), n),
                                Eigen::Map<const Eigen::VectorXd>(beside.data(), n - 1), Eigen::EigenvaluesOnly);
  report.smallest = solver.eigenvalues()[0];
  report.largest = solver.eigenvalues()[n - 1];
}

}  // namespace

ConjugateGradientsReport conjugate_gradients(const Multiply& multiply, std::span<const double> b, std::size_t channels,
                                             std::span<double> x, const ConjugateGradientsOptions& options,
                                             const base::Host& host) {
  std::pmr::memory_resource* memory = host.memory;
  Array<double> residual(b.begin(), b.end(), memory), direction(residual, memory), product(b.size(), memory);
  Array<double> square(channels, memory), curvature(channels, memory);
  Array<linear::ConjugateScalars> scalars(memory);
  Array<char> active(channels, 1, memory);
  Array<double> diagonal(memory), beside(memory);  // Lanczos's matrix, of the first column
  std::fill(x.begin(), x.end(), 0.0);
  dots(residual, residual, channels, square);
  for (const double of_column : square)
    scalars.push_back({of_column, options.tolerance});

  ConjugateGradientsReport report;
  double last_alpha = 0, last_beta = 0;
  for (; report.iterations < options.max_iterations; ++report.iterations) {
    host.report(options.phase, report.iterations, 0);
    bool any = false;
    for (std::size_t c = 0; c < channels; ++c) {
      active[c] = active[c] && !scalars[c].converged();
      any = any || active[c];
    }
    if (!any) break;
    multiply(direction, channels, product);
    dots(direction, product, channels, curvature);
    for (std::size_t c = 0; c < channels; ++c) {
      if (!active[c]) continue;
      if (!linear::ConjugateScalars::positive(curvature[c])) {
        active[c] = 0;
        report.singular = true;
        continue;
      }
      const double alpha = scalars[c].length(curvature[c]);
      for (std::size_t i = c; i < x.size(); i += channels) {
        x[i] += alpha * direction[i];
        residual[i] -= alpha * product[i];
      }
      if (c == 0) {
        diagonal.push_back(1 / alpha + (diagonal.empty() ? 0 : last_beta / last_alpha));
        last_alpha = alpha;
      }
    }
    dots(residual, residual, channels, square);
    for (std::size_t c = 0; c < channels; ++c) {
      if (!active[c]) continue;
      const double beta = scalars[c].advance(square[c]);
      for (std::size_t i = c; i < x.size(); i += channels)
        direction[i] = residual[i] + beta * direction[i];
      if (c == 0) {
        beside.push_back(std::sqrt(beta) / last_alpha);
        last_beta = beta;
      }
    }
  }
  report.residual = largest_residual(scalars);
  estimate_spectrum(diagonal, beside, report);
  return report;
}

}  // namespace orbicube::harmonics
