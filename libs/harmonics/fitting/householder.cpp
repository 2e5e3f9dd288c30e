#include "harmonics/fitting/householder.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace orbicube::harmonics {
namespace {

using base::Array;
using Vector = Eigen::Map<Eigen::VectorXd>;

// A factored matrix: R above and on the diagonal (the diagonal apart), the reflections' vectors below.
class Factor {
 public:
  Factor(std::span<double> a, std::size_t rows, std::size_t columns, std::pmr::memory_resource* memory)
      : a_(a), rows_(rows), columns_(columns), diagonal_(memory), scale_(memory), order_(columns, memory) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    diagonal_.reserve(std::min(rows, columns));
    scale_.reserve(std::min(rows, columns));
  }

  std::size_t rank() const { return diagonal_.size(); }
  std::size_t order(std::size_t k) const { return order_[k]; }
  double diagonal(std::size_t k) const { return diagonal_[k]; }
  double entry(std::size_t i, std::size_t j) const { return a_[j * rows_ + i]; }

  void factor(bool pivot, const base::Host& host) {
    Array<double> norm(columns_, host.memory), norm_at_start(columns_, host.memory);
    for (std::size_t j = 0; j < columns_; ++j)
      norm[j] = norm_at_start[j] = below(j, 0).norm();
    const double tolerance = static_cast<double>(std::max(rows_, columns_)) * std::numeric_limits<double>::epsilon();
    for (std::size_t k = 0; k < std::min(rows_, columns_); ++k) {
      host.report("solving", k, std::min(rows_, columns_));
      if (pivot) {
        const auto best =
            static_cast<std::size_t>(std::max_element(norm.begin() + offset(k), norm.end()) - norm.begin());
        if (best != k) {
          below(best, 0).swap(below(k, 0));
          std::swap(norm[best], norm[k]);
          std::swap(norm_at_start[best], norm_at_start[k]);
          std::swap(order_[best], order_[k]);
        }
      }
      Vector v = below(k, k);
      const double length = v.norm();
      if (pivot && (k == 0 ? length == 0 : length <= tolerance * std::abs(diagonal_[0]))) return;
      const double head = v[0] > 0 ? -length : length;
      v[0] -= head;
      diagonal_.push_back(head);
      scale_.push_back(2 / v.squaredNorm());
      for (std::size_t j = k + 1; j < columns_; ++j) {
        Vector w = below(j, k);
        w -= scale_[k] * v.dot(w) * v;
        if (!pivot || norm[j] == 0) continue;
        // What is left of the column below row k; computed again where the difference has lost its digits.
        const double share = w[0] / norm[j];
        const double rest = std::max(0.0, (1 - share) * (1 + share));
        const double ratio = norm[j] / norm_at_start[j];
        if (rest * ratio * ratio <= std::sqrt(std::numeric_limits<double>::epsilon())) {
          norm[j] = norm_at_start[j] = k + 1 < rows_ ? below(j, k + 1).norm() : 0;
        } else {
          norm[j] *= std::sqrt(rest);
        }
      }
    }
  }

  // b <- Q' b.
  void apply_transposed(double* b) {
    for (std::size_t k = 0; k < rank(); ++k)
      reflect(k, b);
  }
  // b <- Q b.
  void apply(double* b) {
    for (std::size_t k = rank(); k-- > 0;)
      reflect(k, b);
  }

 private:
  static std::ptrdiff_t offset(std::size_t k) { return static_cast<std::ptrdiff_t>(k); }
  Vector below(std::size_t column, std::size_t row) {
    return {a_.data() + column * rows_ + row, static_cast<Eigen::Index>(rows_ - row)};
  }
  void reflect(std::size_t k, double* b) {
    const Vector v = below(k, k);
    Vector w(b + k, static_cast<Eigen::Index>(rows_ - k));
    w -= scale_[k] * v.dot(w) * v;
  }

  std::span<double> a_;
  std::size_t rows_, columns_;
  Array<double> diagonal_, scale_;
  Array<std::size_t> order_;  // the column of A that column k was
};

}  // namespace

DenseSolution solve_dense(std::span<double> a, std::size_t rows, std::size_t columns, std::span<double> b,
                          std::size_t right_sides, std::span<double> x, const base::Host& host) {
  Factor qr(a, rows, columns, host.memory);
  qr.factor(true, host);
  const std::size_t rank = qr.rank();
  DenseSolution solution;
  solution.rank = rank;
  std::fill(x.begin(), x.end(), 0.0);
  if (rank == 0) return solution;
  solution.condition = std::abs(qr.diagonal(0) / qr.diagonal(rank - 1));

  // [R1 R2] P' x = Q' b. With [R1 R2]' = Q2 S, the shortest x is P Q2 S^-T Q' b; with full rank Q2 is not needed.
  Array<double> transposed(rank < columns ? columns * rank : 0, host.memory);
  for (std::size_t i = 0; i < rank && rank < columns; ++i) {
    transposed[i * columns + i] = qr.diagonal(i);
    for (std::size_t j = i + 1; j < columns; ++j)
      transposed[i * columns + j] = qr.entry(i, j);
  }
  Factor second(transposed, columns, rank, host.memory);
  if (rank < columns) second.factor(false, host);
  Array<double> y(columns, host.memory);
  for (std::size_t s = 0; s < right_sides; ++s) {
    double* right = b.data() + s * rows;
    qr.apply_transposed(right);
    std::fill(y.begin(), y.end(), 0.0);
    if (rank == columns) {
      for (std::size_t i = columns; i-- > 0;) {
        double sum = right[i];
        for (std::size_t j = i + 1; j < columns; ++j)
          sum -= qr.entry(i, j) * y[j];
        y[i] = sum / qr.diagonal(i);
      }
    } else {
      for (std::size_t i = 0; i < rank; ++i) {
        double sum = right[i];
        for (std::size_t j = 0; j < i; ++j)
          sum -= second.entry(j, i) * y[j];
        y[i] = sum / second.diagonal(i);
      }
      second.apply(y.data());
    }
    for (std::size_t k = 0; k < columns; ++k)
      x[s * columns + qr.order(k)] = y[k];
  }
  return solution;
}

}  // namespace orbicube::harmonics
