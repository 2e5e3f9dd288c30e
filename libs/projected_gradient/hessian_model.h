// What the solver and its steps need of a matrix B that stands for the Hessian of f, built from steps and the changes
// of the gradient along them.
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "projected_gradient/feasible_set.h"

namespace orbicube::projected_gradient {

class HessianModel {
 public:
  virtual ~HessianModel() = default;

  // Whether there are no pairs: then B = sigma I.
  bool empty() const { return count_ == 0; }
  virtual void clear() = 0;
  // A curvature that is typical of f in the current face.
  double sigma() const { return sigma_; }
  void set_sigma(double sigma) { sigma_ = sigma; }

  // Adds step s and change of gradient y with the new sigma (y'y / s'y if it is not positive). False, and the pair not
  // kept, when the curvature s'y is not safely positive.
  virtual bool push(std::span<const double> s, std::span<const double> y, double sigma) = 0;

  // d = -B^-1 gradient, without prepare(); false when there are no pairs, or rounding spoils it.
  virtual bool minimise(std::span<const double> gradient, std::span<double> d, const base::Host& host) = 0;
  // Readies what follows after pairs were added; the model is empty when B can not be computed with them.
  virtual void prepare() = 0;

  // out = B v.
  virtual void multiply(std::span<const double> v, std::span<double> out, const base::Host& host) const = 0;

  // Readies minimise_in_face for the face that `set` has chosen; false when the model there is not resolvable.
  virtual bool enter_face(const FeasibleSet& set, const base::Host& host) = 0;
  // d = -(P B P)^+ P gradient, with P the projection to the face: the step to the model's minimizer there.
  virtual void minimise_in_face(const FeasibleSet& set, std::span<const double> gradient, std::span<double> d,
                                const base::Host& host) const = 0;

 protected:
  std::uint64_t count_ = 0;  // of the pairs
  bool prepared_ = false;    // since the last of them
  double sigma_ = 1;
};

}  // namespace orbicube::projected_gradient
