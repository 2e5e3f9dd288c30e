// The quadratic models of the outputs (f itself, or each residual) around the best point, and of the objective that
// they make. One family changes by the minimum Frobenius norm at each evaluation (Powell 2004). A second, where it is
// kept, has the minimum Frobenius norm itself, without memory; the family that has predicted better is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "trust_region/corners.h"
#include "trust_region/interpolation.h"

namespace orbicube::trust_region {

class Models {
 public:
  // sign: one entry a residual, empty for a scalar f. `two_families` keeps both.
  Models(std::size_t n, std::size_t outputs, bool of_residuals, std::span<const double> sign, bool two_families,
         std::pmr::memory_resource* memory, Objective objective = Objective::sum_of_squares);
  // Makes room for the outputs at `capacity` points, and with `quadratics` for the models themselves; outputs stay.
  void allocate(std::size_t capacity, bool quadratics);

  std::size_t outputs() const { return outputs_; }
  bool of_residuals() const { return of_residuals_; }
  // f of one row of outputs; NaN when one of them is not finite.
  double objective(const double* outputs) const;

  const double* row(std::size_t point) const { return outputs_at_.data() + point * outputs_; }
  void store(std::size_t point, const double* outputs);
  void move(std::size_t from, std::size_t to);

  // No Hessian, no memory of predictions.
  void forget();
  // After a rebuild of the interpolation: the remembering family gets the minimum change that meets all points, the
  // other is made afresh.
  void meet(const Interpolation& interpolation);
  // Before point j goes, whether or not another takes its place: the family without memory gives up its part in it.
  void leave(const Interpolation& interpolation, std::size_t j);
  // Before a prepared point best + d with these outputs is included: what the families do not predict.
  void expect(const double* d, const double* outputs, std::size_t best);
  // After it was included as point j.
  void learn(const Interpolation& interpolation, std::size_t j);
  // After a step of a scalar f: where poor ones say so several times in a row, the remembering family becomes the
  // interpolant without memory.
  void doubt_memory(const Interpolation& interpolation, bool poor);
  // Whether the family without memory must be made afresh, because rounding would have spoiled it.
  bool stale() const { return stale_ != 0; }
  // The best point moves by d, that of the last expect().
  void shift(const double* d);
  // The unknowns u become C u, `inverse` is C^-1 (n x n by rows).
  void transform(const double* inverse);
  // Compares the predictions of both families at best + d with the values there.
  void judge(const double* d, const double* outputs, std::size_t best);

  // Whether f is not the sum of squares of its residuals: steps are then those of a smooth function near it.
  bool has_corners() const { return corners_.any(); }
  Corners& corners() { return corners_; }
  // Maximum change of a residual within a radius, by its model.
  double reach(double radius) const;

  // Change of the objective, with corners as smooth as their width says.
  double change(const double* d, std::size_t best);
  // Gradient (n) and Hessian (n x n) of the objective's model at best + d; for residuals those of the quartic
  // sum sign (r + change)^2, or of h_w(r + change). Cheaper where d is that of the last change().
  void expand(const double* d, std::size_t best, double* gradient, double* hessian);
  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    for (auto* array : {&self.outputs_at_, &self.remembering_.gradient, &self.remembering_.hessian,
                        &self.afresh_.gradient, &self.afresh_.hessian, &self.errors_})
      visit(std::span(*array));
    visit(std::span(&self.stale_, 1));
    visit(std::span(&self.doubts_, 1));
  }

 private:
  struct Family {
    base::Array<double> gradient, hessian;  // outputs x n, outputs x n x n
  };
  void predict(const Family& family, const double* d, double* change) const;
  void predict_with_slopes(const Family& family, const double* d, double* change, double* slopes) const;
  void measure(const double* d);
  void make_afresh(const Interpolation& interpolation);
  const Family& family() const { return two_families_ && errors_[1] < errors_[0] ? afresh_ : remembering_; }

  std::size_t n_, outputs_;
  bool of_residuals_, two_families_;
  Corners corners_;
  base::Array<double> sign_;        // outputs
  base::Array<double> outputs_at_;  // capacity x outputs
  Family remembering_, afresh_;
  base::Array<double> errors_;  // of the predictions of both families, decaying
  std::uint64_t stale_ = 0;
  std::uint64_t doubts_ = 0;  // poor steps in a row that speak against the memory
  base::Array<double> lagrange_gradient_, lagrange_hessian_, work_, values_, change_;
  base::Array<double> surprise_, surprise_afresh_;  // outputs each, from expect() to learn()
  // Of residuals. What change_ and slopes_ (outputs x n, H_i d) are of, while measured_ says so; weights of the
  // residuals' Hessians and squares; slopes of both families from expect() to shift().
  base::Array<double> at_, slopes_, weights_, moved_, moved_afresh_;
  bool measured_ = false;
  bool learned_ = false, remade_ = false;  // since expect(): by learn(), and that the other family was made afresh
};

}  // namespace orbicube::trust_region
