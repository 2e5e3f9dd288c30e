// The interpolation points and what every least-Frobenius-norm interpolant on them shares: the inverse of the KKT
// matrix of Powell 2004, "Least Frobenius norm updating of quadratic models that satisfy interpolation conditions". A
// quadratic q(x) = c + g'x + 0.5 sum_j lambda_j (s_j'x)^2 with q(s_j) = b_j and sum_j lambda_j = 0, sum_j lambda_j s_j
// = 0 has the Hessian of minimum Frobenius norm. The inverse, without the row of c, holds the coefficients (g, lambda)
// of all Lagrange functions. It is updated in O(size^2) when a point comes or goes, and made afresh when rounding
// shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"

namespace orbicube::trust_region {

class Interpolation {
 public:
  Interpolation(std::size_t n, std::pmr::memory_resource* memory);
  // Makes room for `capacity` points, and with `inverse` for what rebuild() and all after it need; points stay.
  void allocate(std::size_t capacity, bool inverse);

  std::size_t dimension() const { return n_; }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  std::size_t best() const { return best_; }
  std::uint64_t rebuilds() const { return rebuilds_; }
  const double* point(std::size_t j) const { return points_.data() + j * n_; }
  // s_j = point(j) - base.
  const double* offset(std::size_t j) const { return offsets_.data() + j * n_; }
  double distance_to_best(std::size_t j) const;
  // |point(j) - x|^2 of all points, size() entries.
  void squared_distances(const double* x, double* squares) const;

  // Sets of points without their inverse, for starts: rebuild() must follow.
  void clear() { size_ = 0; }
  void place(std::size_t j, const double* x);
  void resize(std::size_t size) { size_ = size; }
  void set_best(std::size_t j) { best_ = j; }
  // Makes base the best point and the inverse afresh; false when the points are not poised.
  bool rebuild();
  // Whether so much has changed since the last rebuild() that rounding may matter.
  bool wants_rebuild() const { return updates_ > 12 * (n_ + size_); }
  // x - best becomes C (x - best) for all points, C n x n by rows; the best point becomes `best`. rebuild() must
  // follow.
  void transform(const double* c, const double* best);
  // Makes base the best point when it is many steps away: quadratics around a far base lose digits.
  void move_base(double step);

  // The new point best + d: its Lagrange values (see lagrange()) and beta of Powell's formula. False when rounding has
  // spoiled the inverse.
  bool prepare(const double* d);
  double lagrange(std::size_t j) const { return product_[n_ + j]; }
  double beta() const { return beta_; }
  // Diagonal of the inverse that belongs to point j.
  double alpha(std::size_t j) const { return inverse_[(n_ + j) * stride_ + n_ + j]; }
  // No update since the last rebuild().
  bool fresh() const { return updates_ == 0; }
  // Whether the Lagrange function of j still is one at its point.
  bool sound(std::size_t j);
  // alpha beta + tau^2: by what the determinant changes when the prepared point replaces j.
  double denominator(std::size_t j) const { return alpha(j) * beta_ + lagrange(j) * lagrange(j); }

  // Without rounding the denominator is at least tau^2 (Powell 2009, section 5, on RESCUE).
  bool trustworthy(std::size_t j) const { return denominator(j) > 0.5 * lagrange(j) * lagrange(j); }

  // The prepared point takes the place of point j, or is added; false when the denominator says that it cannot be.
  bool replace(std::size_t j);
  bool append();
  // Point j goes; the last one takes its place.
  bool remove(std::size_t j);

  // Gradient at the best point (n) and Hessian (n x n, symmetric) of Lagrange function j. `coefficients` (n + size()
  // entries) gets its gradient at the base, then what multiplies each (s_j'x)^2 / 2.
  void lagrange_function(std::size_t j, double* gradient, double* hessian, double* coefficients) const;
  // The same of sum_j b_j l_j, the interpolant of `values` (size() entries) without memory. b of the best point counts
  // as the constant. work: 2 (n + capacity) entries.
  void interpolant(const double* values, double* gradient, double* hessian, double* work) const;

  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    visit(std::span(&self.size_, 1));
    visit(std::span(&self.best_, 1));
    visit(std::span(&self.updates_, 1));
    visit(std::span(&self.rebuilds_, 1));
    for (auto* array : {&self.points_, &self.offsets_, &self.across_, &self.base_, &self.inverse_})
      visit(std::span(*array));
  }

 private:
  double* inverse_row(std::size_t i) { return inverse_.data() + i * stride_; }
  const double* inverse_row(std::size_t i) const { return inverse_.data() + i * stride_; }
  void put_offset(std::size_t j, const double* s);
  void put_base();
  void copy_inverse_row(std::size_t row, double* to) const;
  void quadratic(const double* coefficients, double* gradient, double* hessian) const;
  void move_gradient(const double* coefficients, double* gradient) const;

  // interpolation_rebuild.cpp
  std::size_t other(std::size_t j) const { return j < best_ ? j : j - 1; }  // number of j without the best point
  bool measure_offsets(double* lengths, double& mean) const;
  void assemble_system(const double* lengths, double mean);
  bool invert_system(std::size_t count);
  double residual(std::size_t count);
  bool refine(std::size_t count);
  void restore_units(const double* inverse, const double* lengths, double mean);
  void complete_best_row();

  std::size_t n_, capacity_ = 0, stride_ = 0;
  std::size_t size_ = 0, best_ = 0;
  std::uint64_t updates_ = 0, rebuilds_ = 0;
  double beta_ = 0;
  base::Array<double> points_, offsets_;  // capacity x n
  base::Array<double> across_;            // n x capacity: the offsets by coordinates
  base::Array<double> base_;              // n
  // stride x stride, rows: gradient (n), then points. Symmetric: updates leave what is above the diagonal behind.
  base::Array<double> inverse_;
  base::Array<double> product_;                      // inverse times w of the prepared point
  base::Array<double> new_point_, new_offset_;       // n
  base::Array<double> work_, matrix_, work_square_;  // for rebuild()
  base::Array<std::uint32_t> order_;
};

}  // namespace orbicube::trust_region
