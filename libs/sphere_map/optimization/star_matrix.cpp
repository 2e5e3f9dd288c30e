#include "sphere_map/optimization/star_matrix.h"

#include <Eigen/LU>
#include <cmath>

#include "linear/iterative/conjugate_gradients.h"
#include "sphere_map/optimization/coarse_space.h"

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
  CoarseSpace& space;
  double radius;
  std::span<const Vector2d> right_side;
  std::span<Vector2d> x;
  int step, max_steps;
  // Of the residual r, the direction d and the preconditioner M^-1: r . M^-1 r, x . M x, x . M d, d . M d.
  double square = 0, x_square = 0, x_along = 0, along_square = 0;
  double curvature = 0, gain = 0;
  bool limited = false;

  double residual_square(const base::Array<Vector2d>& preconditioned) {
    return own.sum([&](std::size_t i) { return own.residual_[i].dot(preconditioned[i]); });
  }

  double start() {
    own.pool_.run_pieces(x.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        start(i);
    });
    space.correct(own.residual_, own.along_);
    along_square = square = residual_square(own.along_);
    if (radius < 0) radius *= -std::sqrt(square);
    return square;
  }
  void start(std::size_t i) {
    const Eigen::Matrix2d& d = matrix.diagonal[i];
    // Made positive, as the step of a single vertex is.
    const double mean = 0.5 * d.trace();
    const double spread = std::hypot(0.5 * (d(0, 0) - d(1, 1)), d(0, 1));
    const double least = std::max(1e-3 * (std::abs(mean) + spread), std::numeric_limits<double>::min());
    const double shift = std::max(0.0, least - (mean - spread));
    own.inverse_[i] = (d + shift * Eigen::Matrix2d::Identity()).inverse();
    x[i].setZero();
    own.residual_[i] = right_side[i];
    own.along_[i] = own.inverse_[i] * own.residual_[i];
  }
  double multiply() {
    curvature = own.sum([&](std::size_t i) {
      own.product_[i] = matrix.row_times(i, own.along_);
      return own.along_[i].dot(own.product_[i]);
    });
    limited = !(curvature > 0) || square_after(square / curvature) > radius * radius;
    return limited ? 0 : curvature;
  }
  double square_after(double alpha) const { return x_square + alpha * (2 * x_along + alpha * along_square); }
  double advance(double alpha) {
    x_square = square_after(alpha);
    x_along += alpha * along_square;
    gain += 0.5 * alpha * square;
    own.pool_.run_pieces(x.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        x[i] += alpha * own.along_[i];
        own.residual_[i] -= alpha * own.product_[i];
        own.preconditioned_[i] = own.inverse_[i] * own.residual_[i];
      }
    });
    space.correct(own.residual_, own.preconditioned_);
    return square = residual_square(own.preconditioned_);
  }
  // Goes on along the direction to the radius.
  void go_to_radius() {
    const double left = std::max(0.0, radius * radius - x_square);
    const double alpha = left / (x_along + std::sqrt(x_along * x_along + along_square * left));
    if (!(alpha > 0)) return;
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += alpha * own.along_[i];
    gain += alpha * (square - 0.5 * alpha * curvature);
    x_square = radius * radius;
  }
  void turn(double beta) {
    x_along *= beta;
    along_square = square + beta * beta * along_square;
    own.pool_.run_pieces(x.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        own.along_[i] = own.preconditioned_[i] + beta * own.along_[i];
    });
    own.host_.report("final optimization", static_cast<std::uint64_t>(step++), static_cast<std::uint64_t>(max_steps));
  }
};

RegionStep ConjugateGradients::solve(const StarMatrix& matrix, CoarseSpace& space, double radius,
                                     std::span<const Vector2d> right_side, double tolerance, int max_steps,
                                     std::span<Vector2d> x) {
  System system{*this, matrix, space, radius, right_side, x, 0, max_steps};
  linear::conjugate_gradients(system, max_steps, tolerance);
  if (system.limited) system.go_to_radius();
  return {std::sqrt(system.x_square), system.gain, system.limited};
}

}  // namespace orbicube::sphere_map
