// The quadratic models of the outputs (f itself, or each residual) around the best point, and of the objective that
// they make. Two families are kept: one that changes by the least Frobenius norm at each evaluation (Powell 2004) and,
// for residuals, one of least Frobenius norm made afresh; the family that has predicted better is used.
#pragma once

#include <cstddef>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "trust_region/interpolation.h"

namespace orbicube::trust_region {

class Models {
 public:
  // sign: one entry a residual, empty for a scalar f. `two_families` keeps both.
  Models(std::size_t n, std::size_t outputs, bool least_squares, std::span<const double> sign, bool two_families,
         std::size_t capacity, std::pmr::memory_resource* memory);

  std::size_t outputs() const { return outputs_; }
  bool least_squares() const { return least_squares_; }
  // f of one row of outputs; NaN when one of them is not finite.
  double objective(const double* outputs) const;

  const double* row(std::size_t point) const { return outputs_at_.data() + point * outputs_; }
  void store(std::size_t point, const double* outputs);
  void move(std::size_t from, std::size_t to);

  // No Hessian, no memory of predictions.
  void forget();
  // After a rebuild of the interpolation: the remembering family gets the least change that meets all points.
  void meet(const Interpolation& interpolation);
  // After a prepared point was included as point j with outputs `row(j)`: what was predicted is given.
  void learn(const Interpolation& interpolation, std::size_t j, const double* error);
  // Makes the family without memory, where there are two.
  void refresh(const Interpolation& interpolation);
  // The best point moves by d to point `best`.
  void shift(const double* d);
  // Compares the predictions of both families at best + d with what was told there.
  void judge(const double* d, const double* outputs, std::size_t best);

  // Change of the outputs from the best point to best + d.
  void predict(const double* d, double* change) const { predict(family(), d, change); }
  void predict_remembering(const double* d, double* change) const { predict(remembering_, d, change); }
  // Change of the objective.
  double change(const double* d, std::size_t best);
  // Gradient (n) and Hessian (n x n) of the objective's model at best + d; for residuals those of the quartic
  // sum sign (r + change)^2.
  void expand(const double* d, std::size_t best, double* gradient, double* hessian);
  // The step within the ball and the box by the Gauss-Newton-like start and further steps on the quartic belongs to the
  // solver; this says whether that is worth while.
  bool quartic() const { return least_squares_; }

  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    for (auto* array : {&self.outputs_at_, &self.remembering_.gradient, &self.remembering_.hessian,
                        &self.afresh_.gradient, &self.afresh_.hessian, &self.errors_})
      visit(std::span(*array));
  }

 private:
  struct Family {
    base::Array<double> gradient, hessian;  // outputs x n, outputs x n x n
  };
  void predict(const Family& family, const double* d, double* change) const;
  const Family& family() const { return two_families_ && errors_[1] < errors_[0] ? afresh_ : remembering_; }

  std::size_t n_, outputs_;
  bool least_squares_, two_families_;
  base::Array<double> sign_;        // outputs
  base::Array<double> outputs_at_;  // capacity x outputs
  Family remembering_, afresh_;
  base::Array<double> errors_;  // of the predictions of both families, decaying
  base::Array<double> lagrange_gradient_, lagrange_hessian_, work_, values_, change_, slopes_;
};

}  // namespace orbicube::trust_region
