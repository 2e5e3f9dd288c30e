#include "correspondence/statistics/principal_modes.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "base/error.h"

namespace orbicube::correspondence {

namespace {

// Variances below this fraction of the largest are rounding of the Gram matrix.
constexpr double smallest_variance = 1e-12;

// Returns the products of all pairs of rows. Each is one sum in a fixed order.
Eigen::MatrixXd gram_matrix(const Population& centered, const base::Host& host) {
  const Eigen::Index n = centered.rows();
  Eigen::MatrixXd gram(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    host.report("modes", static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(n));
    for (Eigen::Index j = 0; j <= i; ++j)
      gram(i, j) = gram(j, i) = centered.row(i).dot(centered.row(j));
  }
  return gram;
}

}  // namespace

PrincipalModes principal_modes(const Population& subjects, const base::Host& host) {
  const Eigen::Index n = subjects.rows();
  if (n < 2) throw base::Error("invalid-argument", "principal modes need two subjects or more");
  if (!subjects.allFinite()) throw base::Error("invalid-argument", "a coordinate of a subject is not finite");
  PrincipalModes result;
  result.mean = subjects.colwise().mean().transpose();
  const Population centered = subjects.rowwise() - result.mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram_matrix(centered, host));
  const double largest = solver.eigenvalues()(n - 1);
  Eigen::Index count = 0;
  while (count < n - 1 && solver.eigenvalues()(n - 1 - count) > smallest_variance * largest)
    ++count;
  result.variances.resize(count);
  result.modes.resize(subjects.cols(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    host.report("modes", static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(count));
    result.variances(k) = solver.eigenvalues()(n - 1 - k) / static_cast<double>(n - 1);
    Eigen::VectorXd mode = (centered.transpose() * solver.eigenvectors().col(n - 1 - k)).normalized();
    Eigen::Index largest_entry = 0;
    mode.cwiseAbs().maxCoeff(&largest_entry);
    result.modes.col(k) = mode(largest_entry) < 0 ? Eigen::VectorXd(-mode) : mode;
  }
  result.scores = centered * result.modes;
  return result;
}

}  // namespace orbicube::correspondence
