// Where to go next: the limited-memory model of f at x, minimized over the feasible set. Projected Barzilai-Borwein
// steps on the model find the face, the model's minimizer in that face is exact; a few rounds of both settle the face
// without evaluating f (the two phases of Hager and Zhang 2006, "A new active set algorithm for box constrained
// optimization", taken on the model; with rows, the exact subproblem of Schmidt et al. 2009).
#pragma once

#include <memory_resource>
#include <span>

#include "base/array.h"
#include "base/host.h"
#include "projected_gradient/feasible_set.h"
#include "projected_gradient/hessian_model.h"

namespace orbicube::projected_gradient {

class FaceStep {
 public:
  FaceStep(std::size_t n, std::pmr::memory_resource* memory);

  // target = a feasible point where the model g'(z - x) + (z - x)'B(z - x) / 2 is (nearly) least. The arrays have n
  // entries. `projected_gradient` is |P(x - g) - x|inf.
  Projected find(FeasibleSet& set, HessianModel& model, std::span<const double> x, std::span<const double> gradient,
                 double projected_gradient, std::span<double> target, const base::Host& host);

 private:
  bool step_freely(const FeasibleSet& set, HessianModel& model, std::span<const double> x,
                   std::span<const double> gradient, std::span<double> target, const base::Host& host);
  bool move(const FeasibleSet& set, std::span<double> target);

  base::Array<double> moved_, projected_, direction_, curved_, model_gradient_;  // n each
};

}  // namespace orbicube::projected_gradient
