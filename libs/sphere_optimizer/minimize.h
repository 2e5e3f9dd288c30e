// All at once with the function compiled into the loop, for libraries that use the solver from C++.
#pragma once

#include "base/error.h"
#include "sphere_optimizer/solver.h"

namespace orbicube::sphere_optimizer {

// Returns the solver's requests with f(x, gradient), which fills the gradient (N d numbers, in the solver's own memory)
// and returns the value, until the run ends. Nothing is allocated. Throws cancelled when the host cancelled the run,
// and what f throws (minimize() again then requires the same point); best_point() is known in any case.
template <class Function>
Result minimize(Solver& solver, const Function& f) {
  for (Request request; (request = solver.step()) != Request::done;) {
    base::require(request != Request::need_product, "minimize() has no products of the Hessian");
    if (request != Request::need_value_and_gradient) continue;
    const std::span<double> gradient = solver.gradient_room();
    const double value = f(solver.point(), gradient);
    solver.tell(value, gradient);
  }
  if (solver.cancelled_by_host()) throw base::Error("cancelled", "stopped during sphere optimizer");
  return solver.result();
}

}  // namespace orbicube::sphere_optimizer
