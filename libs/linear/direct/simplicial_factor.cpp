#include "linear/direct/simplicial_factor.h"

#include <algorithm>

namespace orbicube::linear {

void SimplicialFactor::analyze(const SparseMatrix& matrix) {
  factors_.analyzePattern(matrix);
}

bool SimplicialFactor::factorize(const SparseMatrix& matrix) {
  factors_.factorize(matrix);
  return factors_.info() == Eigen::Success;
}

void SimplicialFactor::solve(std::span<const double> right, std::size_t columns, std::span<double> solution) const {
  const auto size = static_cast<Eigen::Index>(columns == 0 ? 0 : right.size() / columns);
  for (std::size_t c = 0; c < columns; ++c) {
    const std::size_t begin = c * static_cast<std::size_t>(size);
    const Eigen::VectorXd column = factors_.solve(Eigen::Map<const Eigen::VectorXd>(&right[begin], size));
    Eigen::Map<Eigen::VectorXd>(&solution[begin], size) = column;
  }
}

// With L in blocks before, at and behind the row, only its own entries go and the block behind changes, by the matrix
// of rank one that the row had taken off it.
void SimplicialFactor::remove_row(Index row) {
  auto& lower = factors_.m_matrix;
  const int at = factors_.m_P.indices()[static_cast<Eigen::Index>(row)];
  // Row `at` of L has its entries in columns that lie below `at` in the elimination tree.
  for (int column = 0; column < at; ++column) {
    const int* const begin = lower.innerIndexPtr() + lower.outerIndexPtr()[column];
    const int* const end = lower.innerIndexPtr() + lower.outerIndexPtr()[column + 1];
    const int* const place = std::lower_bound(begin, end, at);
    if (place != end && *place == at) lower.valuePtr()[place - lower.innerIndexPtr()] = 0;
  }
  const double root = std::sqrt(factors_.m_diag[at]);
  work_.setZero(lower.rows());
  int first = -1;
  for (int k = lower.outerIndexPtr()[at]; k < lower.outerIndexPtr()[at + 1]; ++k) {
    work_[lower.innerIndexPtr()[k]] = lower.valuePtr()[k] * root;
    lower.valuePtr()[k] = 0;
    if (first < 0) first = lower.innerIndexPtr()[k];
  }
  factors_.m_diag[at] = 1;
  update_along_path(first, 1);
}

bool SimplicialFactor::update(std::span<const Index> rows, std::span<const double> values, int sign) {
  work_.setZero(factors_.m_matrix.rows());
  int first = -1;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int at = factors_.m_P.indices()[static_cast<Eigen::Index>(rows[i])];
    work_[at] += values[i];
    if (first < 0 || at < first) first = at;
  }
  const bool positive = update_along_path(first, sign);
  if (!positive) factors_.m_info = Eigen::NumericalIssue;
  return positive;
}

// L D L' + sign w w', for w in work_, whose first entry is `first`: its fill lies along the path to the root of the
// elimination tree (method C1 of Gill, Golub, Murray and Saunders 1974).
bool SimplicialFactor::update_along_path(int first, int sign) {
  auto& lower = factors_.m_matrix;
  double alpha = 1;
  for (int j = first; j >= 0; j = factors_.m_parent[j]) {
    const double w = work_[j], d = factors_.m_diag[j];
    if (w == 0) continue;
    const double next = alpha + sign * w * w / d;
    const double changed = d * next / alpha;
    if (!(next > 0) || !(changed > 0)) return false;
    const double gamma = sign * w / (d * next);
    alpha = next;
    factors_.m_diag[j] = changed;
    for (int k = lower.outerIndexPtr()[j]; k < lower.outerIndexPtr()[j + 1]; ++k) {
      double& below = work_[lower.innerIndexPtr()[k]];
      double& entry = lower.valuePtr()[k];
      below -= w * entry;
      entry += gamma * below;
    }
  }
  return true;
}

bool SimplicialFactor::is_positive() const {
  return (factors_.m_diag.array() > 0).all();
}

std::size_t SimplicialFactor::entries() const {
  return static_cast<std::size_t>(factors_.m_matrix.nonZeros());
}

}  // namespace orbicube::linear
