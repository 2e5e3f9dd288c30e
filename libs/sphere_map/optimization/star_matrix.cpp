#include "sphere_map/optimization/star_matrix.h"

#include <Eigen/LU>
#include <cmath>

#include "linear/iterative/conjugate_gradients.h"

namespace orbicube::sphere_map {

StarMatrix::StarMatrix(const Level& level, std::span<const Index> place, const base::Host& host)
    : diagonal(level.vertices.size(), host.memory),
      off_diagonal(level.stars.size(), host.memory),
      begin_(level.star_begin),
      column_(level.stars.size(), host.memory) {
  for (std::size_t k = 0; k < column_.size(); ++k)
    column_[k] = place[level.stars[k].q];
}

void StarMatrix::set_zero(const base::ThreadPool& pool) {
  pool.run_pieces(size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      diagonal[i].setZero();
      for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
        off_diagonal[k].setZero();
    }
  });
}

ConjugateGradients::ConjugateGradients(std::size_t size, const base::Host& host, const base::ThreadPool& pool)
    : host_(host),
      pool_(pool),
      positive_(size, host.memory),
      inverse_(size, host.memory),
      residual_(size, host.memory),
      preconditioned_(size, host.memory),
      along_(size, host.memory),
      product_(size, host.memory),
      partial_((size + vertices_a_piece - 1) / vertices_a_piece, host.memory) {}

template <class Term>
double ConjugateGradients::sum(const Term& term) {
  pool_.run_pieces(inverse_.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
    double piece = 0;
    for (std::size_t i = begin; i < end; ++i)
      piece += term(i);
    partial_[begin / vertices_a_piece] = piece;
  });
  double total = 0;
  for (const double p : partial_)
    total += p;
  return total;
}

struct ConjugateGradients::System {
  ConjugateGradients& own;
  const StarMatrix& matrix;
  double damping;
  std::span<const Vector2d> right_side;
  std::span<Vector2d> x;
  int step, max_steps;

  double start() {
    return own.sum([&](std::size_t i) {
      const Eigen::Matrix2d& d = matrix.diagonal[i];
      // The eigenvalues are made positive, as the step of a single vertex is.
      const double mean = 0.5 * d.trace();
      const double spread = std::hypot(0.5 * (d(0, 0) - d(1, 1)), d(0, 1));
      const double least = std::max(1e-3 * (std::abs(mean) + spread), std::numeric_limits<double>::min());
      const double shift = std::max(0.0, least - (mean - spread));
      own.positive_[i] = d + shift * Eigen::Matrix2d::Identity();
      own.inverse_[i] = own.positive_[i].inverse();
      x[i].setZero();
      own.residual_[i] = right_side[i];
      own.along_[i] = own.inverse_[i] * own.residual_[i];
      return own.residual_[i].dot(own.along_[i]);
    });
  }
  double multiply() {
    return own.sum([&](std::size_t i) {
      own.product_[i] = matrix.row_times(i, own.along_);
      if (damping > 0) own.product_[i] += damping * (own.positive_[i] * own.along_[i]);
      return own.along_[i].dot(own.product_[i]);
    });
  }
  double advance(double alpha) {
    return own.sum([&](std::size_t i) {
      x[i] += alpha * own.along_[i];
      own.residual_[i] -= alpha * own.product_[i];
      own.preconditioned_[i] = own.inverse_[i] * own.residual_[i];
      return own.residual_[i].dot(own.preconditioned_[i]);
    });
  }
  void turn(double beta) {
    own.pool_.run_pieces(x.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        own.along_[i] = own.preconditioned_[i] + beta * own.along_[i];
    });
    own.host_.report("final optimization", static_cast<std::uint64_t>(step++), static_cast<std::uint64_t>(max_steps));
  }
};

void ConjugateGradients::solve(const StarMatrix& matrix, double damping, std::span<const Vector2d> right_side,
                               double tolerance, int max_steps, std::span<Vector2d> x) {
  System system{*this, matrix, damping, right_side, x, 0, max_steps};
  const auto outcome = linear::conjugate_gradients(system, max_steps, tolerance);
  if (outcome.not_positive && outcome.steps == 0) std::copy(along_.begin(), along_.end(), x.begin());
}

}  // namespace orbicube::sphere_map
