// One step of a trust region on a product of spheres: the model g.s + s.H s / 2 on the tangent space, minimized within
// a radius by conjugate gradients that end early (Steihaug 1983; Absil, Baker, Gallivan 2007, "Trust-region methods on
// Riemannian manifolds"). The products of H are requested one at a time.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "sphere_optimizer/problem.h"

namespace orbicube::sphere_optimizer {

class NewtonStep {
 public:
  // Allocates nothing unless `used`.
  NewtonStep(const Shape& shape, bool used, std::pmr::memory_resource* memory);

  // Begins a step from a tangent gradient. Lengths are measured with `scale`, positive numbers, one a block, as weights
  // of squares, which also precondition; the step is at most `radius` long. It is accurate enough when the model's
  // gradient is at most `accuracy` times the given one.
  void begin(std::span<const double> gradient, std::span<const double> scale, double radius, double accuracy);

  // The tangent vector whose product with H is needed next.
  std::span<const double> direction() const { return direction_; }

  // The product, tangent to the spheres. Returns whether the step is complete.
  bool advance(std::span<const double> product, std::span<const double> scale);
  // Instead of advance() where there is no product: the step is what it is, or, if that is nothing, as long as it may
  // be along direction(). Returns true: it is complete.
  bool end_without_product();

  std::span<const double> step() const { return step_; }
  // Of the model, at the step: not positive.
  double change(std::span<const double> gradient) const;
  // In the lengths of `scale`.
  double length() const;
  bool at_boundary() const { return state_.at_boundary != 0; }

  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    visit(std::span(&self.state_, 1));
    for (auto* array : {&self.step_, &self.product_, &self.residual_, &self.direction_})
      visit(std::span(*array));
  }

 private:
  // Plain data without padding, saved as bytes.
  struct State {
    double radius = 0, sufficient_square = 0;                          // of the residual
    double residual_product = 0;                                       // residual . residual / scale
    double step_square = 0, step_direction = 0, direction_square = 0;  // in the lengths of `scale`
    std::uint64_t products = 0, at_boundary = 0;
  };

  double weighted_square(std::span<const double> v, std::span<const double> scale) const;
  void move(double length, std::span<const double> product);
  void begin_direction(double factor, std::span<const double> scale);

  Shape shape_;
  State state_;
  base::Array<double> step_, product_, residual_, direction_;  // product_: of H and the step
};

}  // namespace orbicube::sphere_optimizer
