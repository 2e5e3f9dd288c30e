#include "harmonics/fitting/block_conjugate_gradients.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace orbicube::harmonics {
namespace {

using base::Array;

using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, max_block, max_block>;

// a' b of interleaved columns, in blocks of rows whose sums are added in their order.
Small products(std::span<const double> a, std::span<const double> b, std::size_t channels) {
  const auto n = static_cast<Eigen::Index>(channels);
  Small sum = Small::Zero(n, n);
  constexpr std::size_t rows = 256;
  for (std::size_t first = 0; first < a.size(); first += rows * channels) {
    Small part = Small::Zero(n, n);
    for (std::size_t i = first; i < std::min(a.size(), first + rows * channels); i += channels) {
      for (Eigen::Index r = 0; r < n; ++r) {
        for (Eigen::Index c = 0; c < n; ++c)
          part(r, c) += a[i + static_cast<std::size_t>(r)] * b[i + static_cast<std::size_t>(c)];
      }
    }
    sum += part;
  }
  return sum;
}

// to += sign from m, row by row.
void add_combination(std::span<const double> from, const Small& m, double sign, std::size_t channels,
                     std::span<double> to) {
  const auto n = static_cast<Eigen::Index>(channels);
  for (std::size_t i = 0; i < to.size(); i += channels) {
    for (Eigen::Index r = 0; r < n; ++r) {
      const double factor = sign * from[i + static_cast<std::size_t>(r)];
      for (Eigen::Index c = 0; c < n; ++c)
        to[i + static_cast<std::size_t>(c)] += factor * m(r, c);
    }
  }
}

// Returns T with T' K T the identity, but for zero columns where K has no positive pivot beyond rounding.
Small orthonormalizing(Small k) {
  const Eigen::Index n = k.rows();
  Small t = Small::Identity(n, n);
  const Eigen::VectorXd diagonal = k.diagonal();
  constexpr double rounding = 1e-13;
  for (Eigen::Index j = 0; j < n; ++j) {
    const double pivot = k(j, j);
    if (!(pivot > rounding * diagonal[j]) || !std::isfinite(pivot)) {
      t.col(j).setZero();
      k.row(j).setZero();
      k.col(j).setZero();
      continue;
    }
    const double scale = 1 / std::sqrt(pivot);
    t.col(j) *= scale;
    k.col(j) *= scale;
    k.row(j) *= scale;
    for (Eigen::Index i = j + 1; i < n; ++i) {
      const double share = k(j, i);
      t.col(i) -= share * t.col(j);
      k.col(i) -= share * k.col(j);
      k.row(i) -= share * k.row(j);
    }
  }
  return t;
}

}  // namespace

BlockReport block_conjugate_gradients(const Multiply& multiply, const Multiply& precondition, std::span<const double> b,
                                      std::size_t channels, std::span<const double> tolerance,
                                      std::uint64_t max_iterations, std::span<double> x, const base::Host& host) {
  std::pmr::memory_resource* memory = host.memory;
  Array<double> residual(b.begin(), b.end(), memory), next(b.size(), memory), image(b.size(), memory);
  Array<double> direction(b.size(), memory), direction_image(b.size(), memory);  // P with P' G P = 1, and G P
  std::fill(x.begin(), x.end(), 0.0);
  const Eigen::VectorXd start = products(b, b, channels).diagonal();
  BlockReport report;
  for (;; ++report.iterations) {
    const auto pause = [&] { host.report("solving", report.iterations, 0); };
    pause();
    const Eigen::VectorXd square = products(residual, residual, channels).diagonal();
    report.converged = true;
    for (std::size_t c = 0; c < channels; ++c) {
      const auto i = static_cast<Eigen::Index>(c);
      report.converged = report.converged && square[i] <= tolerance[c] * tolerance[c] * start[i];
    }
    if (report.converged || report.iterations == max_iterations || !square.allFinite()) return report;
    precondition(residual, channels, next);
    pause();
    // Columns of very different length would look dependent.
    Small scale = products(next, residual, channels).diagonal().asDiagonal();
    for (Eigen::Index c = 0; c < scale.rows(); ++c)
      scale(c, c) = scale(c, c) > 0 ? 1 / std::sqrt(scale(c, c)) : 0;
    for (std::size_t i = 0; i < next.size(); ++i) {
      const auto c = static_cast<Eigen::Index>(i % channels);
      next[i] *= scale(c, c);
    }
    if (report.iterations > 0)
      add_combination(direction, products(direction_image, next, channels), -1, channels, next);
    pause();
    multiply(next, channels, image);
    pause();
    const Small turn = orthonormalizing(products(next, image, channels));
    if (turn.isZero(0)) return report;
    std::fill(direction.begin(), direction.end(), 0.0);
    std::fill(direction_image.begin(), direction_image.end(), 0.0);
    add_combination(next, turn, 1, channels, direction);
    add_combination(image, turn, 1, channels, direction_image);
    pause();
    const Small step = products(direction, residual, channels);
    add_combination(direction, step, 1, channels, x);
    add_combination(direction_image, step, -1, channels, residual);
  }
}

}  // namespace orbicube::harmonics
