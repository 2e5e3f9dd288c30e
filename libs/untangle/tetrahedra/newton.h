// Steps of Newton's method on the foldover energy: directions by conjugate gradients, lengths by halving.
#pragma once

#include "untangle/tetrahedra/foldover_energy.h"

namespace orbicube::untangle {

struct NewtonLimits {
  int products = 150;       // with the Hessian, a step: of conjugate gradients
  double tolerance = 1e-2;  // of the preconditioned residual, relative
};

class Newton {
 public:
  Newton(FoldoverEnergy& energy, std::span<const double> start, const base::Host& host);

  // Moves to a point of less energy at this eps. `now` is the value here, and becomes that there. Returns the length
  // of the step, 0 when no step lowers the energy. With eps 0 no element becomes inverted.
  double step(double eps, const NewtonLimits& limits, EnergyValue& now);

  // Begins again elsewhere.
  void restart(std::span<const double> values);

  // Lets the energy fall until no element is inverted, in at most the given number of steps; eps goes from what the
  // worst determinant requires, but at most `max_eps`, towards 0. Returns whether it got there, in floating point.
  // Gives up where eps is next to nothing, and where everything has collapsed: above 0.4 that may be the minimum energy
  // unless the boundary is fixed. At each eps at most `patience` steps are made, until one gains little.
  bool untangle(int max_steps, double max_eps, int patience, const NewtonLimits& limits);
  // Lowers the energy of a map without inverted elements, and keeps it so, in at most the given number of steps, or
  // until a step gains less than `min_gain` of the energy. Where elements are nearly flat, which would stop a
  // barrier, the eps with which untangle() ended goes on falling first, and the best positive map on that way is kept.
  void polish(int max_steps, double min_gain, const NewtonLimits& limits);

  std::span<const double> values() const { return values_; }  // of all variables
  const EnergyValue& now() const { return now_; }
  std::size_t steps() const { return steps_; }

 private:
  FoldoverEnergy& energy_;
  const base::Host& host_;
  EnergyValue now_{};
  std::size_t steps_ = 0;
  double eps_ = 0;
  Array<double> values_, trial_;
  Array<double> gradient_, direction_;  // of free variables
};

}  // namespace orbicube::untangle
