#include "linear/iterative/multigrid.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "linear/iterative/aggregation.h"
#include "linear/iterative/coarse_matrix.h"
#include "linear/iterative/conjugate_gradients.h"

namespace orbicube::linear {
namespace {

constexpr std::size_t coarsest_rows = 100;
constexpr std::size_t max_dense = 800;  // unknowns of a matrix that is factored as a whole

}  // namespace

template <int block>
void Multigrid<block>::factor(Matrix& matrix) {
  for (depth_ = 1;; ++depth_) {
    if (levels_.size() < depth_) levels_.push_back(std::make_unique<Level>(host_));
    Level& level = *levels_[depth_ - 1];
    level.matrix = depth_ == 1 ? &matrix : &level.coarse;
    const Matrix& m = *level.matrix;
    level.smoother.factor(*level.matrix);
    for (Array<double>* x : {&level.right, &level.solution, &level.residual, &level.first, &level.second,
                             &level.first_image, &level.second_image})
      x->assign(m.size(), 0.0);
    if (m.rows() <= coarsest_rows) break;
    const std::size_t count = make_aggregates(m, level.aggregate, host_);
    if (count == 0 || 2 * count > m.rows()) break;
    if (levels_.size() == depth_) levels_.push_back(std::make_unique<Level>(host_));
    make_coarse(m, level.aggregate, count, levels_[depth_]->coarse, host_);
  }
  factor_last();
}

template <int block>
void Multigrid<block>::factor_last() {
  Level& level = *levels_[depth_ - 1];
  const Matrix& m = *level.matrix;
  const std::size_t size = m.size();
  last_.clear();
  if (size > max_dense) return;
  last_.resize(size * size);
  for (std::size_t i = 0; i < size; ++i) {
    level.first[i] = 1;
    m.multiply(level.first, std::span(last_).subspan(i * size, size), host_);
    level.first[i] = 0;
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (i % 64 == 0) host_.report("solve", 0, 0);
    double* const row = &last_[i * size];
    for (std::size_t j = 0; j <= i; ++j) {
      const double* const other = &last_[j * size];
      double sum = row[j];
      for (std::size_t k = 0; k < j; ++k)
        sum -= row[k] * other[k];
      row[j] = j < i ? sum / other[j] : std::sqrt(sum);
    }
    if (row[i] > 0 && std::isfinite(row[i])) continue;
    last_.clear();
    return;
  }
}

template <int block>
void Multigrid<block>::cycle(std::size_t number, std::span<const double> right, std::span<double> x) {
  Level& level = *levels_[number];
  if (number + 1 == depth_) {
    if (last_.empty()) {
      level.smoother.solve(right, 100, 1e-3, x);
      return;
    }
    const std::size_t size = x.size();
    for (std::size_t i = 0; i < size; ++i) {
      double sum = right[i];
      for (std::size_t k = 0; k < i; ++k)
        sum -= last_[i * size + k] * x[k];
      x[i] = sum / last_[i * size + i];
    }
    for (std::size_t i = size; i-- > 0;) {
      x[i] /= last_[i * size + i];
      for (std::size_t k = 0; k < i; ++k)
        x[k] -= last_[i * size + k] * x[i];
    }
    return;
  }
  level.smoother.sweep_from_zero(right, x, level.residual);
  Level& next = *levels_[number + 1];
  const std::size_t rows = level.matrix->rows(), coarse_rows = next.matrix->rows();
  std::fill(next.right.begin(), next.right.end(), 0.0);
  for (std::size_t v = 0; v < rows; ++v) {
    const Index a = level.aggregate[v];
    if (a == no_index) continue;
    for (std::size_t k = 0; k < Matrix::unknowns; ++k) {
      if (level.matrix->is_own(v, k))
        next.right[Matrix::unknowns * static_cast<std::size_t>(a) + k] += level.residual[Matrix::unknowns * v + k];
    }
  }
  for (std::size_t s = 0; s < level.matrix->shared(); ++s)
    next.right[Matrix::unknowns * coarse_rows + s] = level.residual[Matrix::unknowns * rows + s];
  solve_level(number + 1);
  for (std::size_t v = 0; v < rows; ++v) {
    const Index a = level.aggregate[v];
    if (a == no_index) continue;
    for (std::size_t k = 0; k < Matrix::unknowns; ++k) {
      if (level.matrix->is_own(v, k))
        x[Matrix::unknowns * v + k] += next.solution[Matrix::unknowns * static_cast<std::size_t>(a) + k];
    }
  }
  for (std::size_t s = 0; s < level.matrix->shared(); ++s)
    x[Matrix::unknowns * rows + s] += next.solution[Matrix::unknowns * coarse_rows + s];
  level.smoother.sweep_back(right, x, level.residual);
}

template <int block>
void Multigrid<block>::solve_level(std::size_t number) {
  constexpr double little = 0.25;
  Level& level = *levels_[number];
  if (number + 1 == depth_) {
    cycle(number, level.right, level.solution);
    return;
  }
  cycle(number, level.right, level.first);
  level.matrix->multiply(level.first, level.first_image, host_);
  const double curvature = dot(level.first, level.first_image);
  const double slope = dot(level.first, level.right);
  if (!(curvature > 0) || !std::isfinite(slope / curvature)) {
    level.solution = level.first;
    return;
  }
  const double length = slope / curvature;
  const double before = dot(level.right, level.right);
  for (std::size_t i = 0; i < level.right.size(); ++i)
    level.right[i] -= length * level.first_image[i];
  if (dot(level.right, level.right) <= little * little * before) {
    for (std::size_t i = 0; i < level.solution.size(); ++i)
      level.solution[i] = length * level.first[i];
    return;
  }
  cycle(number, level.right, level.second);
  level.matrix->multiply(level.second, level.second_image, host_);
  const double mixed = dot(level.second, level.first_image);
  const double second_slope = dot(level.second, level.right);
  const double second_curvature = dot(level.second, level.second_image) - mixed * mixed / curvature;
  double second_length = second_slope / second_curvature;
  if (!(second_curvature > 0) || !std::isfinite(second_length)) second_length = 0;
  const double first_length = length - mixed * second_length / curvature;
  for (std::size_t i = 0; i < level.solution.size(); ++i)
    level.solution[i] = first_length * level.first[i] + second_length * level.second[i];
}

template <int block>
int Multigrid<block>::solve(std::span<const double> right, int max_steps, double tolerance,
                            std::span<double> solution) {
  // The preconditioner changes from step to step.
  struct System {
    Multigrid& own;
    std::span<const double> right;
    std::span<double> solution;
    Array<double>&residual, &search, &preconditioned, &image;

    double start() {
      std::fill(solution.begin(), solution.end(), 0.0);
      residual.assign(right.begin(), right.end());
      own.cycle(0, residual, preconditioned);
      search = preconditioned;
      return dot(residual, preconditioned);
    }
    double multiply() {
      own.levels_[0]->matrix->multiply(search, image, own.host_);
      return dot(search, image);
    }
    double along() const { return dot(search, residual); }
    double advance(double length) {
      for (std::size_t i = 0; i < solution.size(); ++i) {
        solution[i] += length * search[i];
        residual[i] -= length * image[i];
      }
      own.cycle(0, residual, preconditioned);
      return dot(residual, preconditioned);
    }
    double overlap() const { return dot(preconditioned, image); }
    void turn(double share) {
      for (std::size_t i = 0; i < solution.size(); ++i)
        search[i] = preconditioned[i] + share * search[i];
    }
  };
  Level& fine = *levels_[0];
  System system{*this, right, solution, fine.right, fine.first, fine.second, fine.first_image};
  return conjugate_gradients(system, max_steps, tolerance).steps;
}

template class Multigrid<1>;
template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace orbicube::linear
