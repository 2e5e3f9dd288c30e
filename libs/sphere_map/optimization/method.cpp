#include "sphere_map/optimization/method.h"

#include <cmath>
#include <numbers>

#include "base/error.h"

namespace orbicube::sphere_map {
namespace {

// The weighted sum of both energies with its barrier, for weights (0.1, 1): others scale the barrier with the minimum
// energy.
Weights angle_and_area(const Options& options, Weights barrier) {
  const double pi = std::numbers::pi;
  const double scale = (16 * pi * options.angle_weight + 4 * pi * options.area_weight) / (16 * pi * 0.1 + 4 * pi * 1.0);
  barrier.angle = options.angle_weight;
  barrier.area = options.area_weight;
  barrier.isometric *= scale;
  barrier.quasi_conformal_1 *= scale;
  barrier.quasi_conformal_2 *= scale;
  barrier.quasi_conformal_4 *= scale;
  return barrier;
}

}  // namespace

Schedule Schedule::with_stronger_barrier(std::size_t attempt) const {
  Schedule stronger = *this;
  if (attempt == 0) return stronger;
  const double factor = std::pow(4.0, static_cast<double>(attempt));
  for (std::size_t i = 0; i < count_; ++i) {
    Weights& w = stronger.stages_[i].weights;
    w.isometric *= factor;
    w.quasi_conformal_1 *= factor;
    w.quasi_conformal_2 *= factor;
    w.quasi_conformal_4 *= factor;
  }
  return stronger;
}

Schedule schedule_of(const Options& options) {
  require_weights(options.angle_weight, options.area_weight);
  Schedule schedule;
  switch (options.method) {
    case Method::balanced:
      schedule.add({angle_and_area(options, {.isometric = 0.02, .quasi_conformal_1 = 0.3, .quasi_conformal_4 = 2e-3}),
                    {.steps = 30, .solver_steps = 400, .relative_gain = 1e-5}});
      return schedule;
    case Method::angle_area:
      // Without a barrier the hierarchy would let protrusions collapse, and what has collapsed does not come back. On
      // the whole mesh it can go: Newton's method takes no step through zero.
      schedule.add({angle_and_area(options, {.isometric = 0.02, .quasi_conformal_1 = 0.05, .quasi_conformal_2 = 1e-3}),
                    {.steps = 2, .solver_steps = 200, .relative_gain = 1e-3}});
      schedule.add({angle_and_area(options, {.isometric = 1e-3, .quasi_conformal_1 = 0.02, .quasi_conformal_2 = 1e-5}),
                    {.steps = 2, .solver_steps = 200, .relative_gain = 1e-3}});
      schedule.add({angle_and_area(options, {.isometric = 1e-5, .quasi_conformal_1 = 0.01, .quasi_conformal_2 = 1e-7}),
                    {.steps = 6, .solver_steps = 200, .relative_gain = 1e-4}});
      return schedule;
    case Method::isometric:
      // D is 2 AT (s1^2 + s2^2) and D AT^2 / M is AT (s1^-2 + s2^-2) / 2 for singular values s1, s2.
      schedule.add({{.angle = 1, .isometric = 4, .quasi_conformal_2 = 1e-3},
                    {.steps = 4, .solver_steps = 200, .relative_gain = 1e-3}});
      return schedule;
    case Method::stretch:
      // The isometric term is the L2 stretch. The others, far below it, choose among maps of nearly the same stretch
      // those without needles, which are also better to reconstruct from spherical harmonics.
      schedule.add({{.angle = 0.01, .area = 0.05, .isometric = 1, .quasi_conformal_4 = 4e-6},
                    {.steps = 6, .solver_steps = 200, .relative_gain = 1e-4}});
      return schedule;
    case Method::conformal:
      // E_D counts a triangle by its area on the sphere, quasi_conformal_1 by its area on the surface: without the
      // second, what is small on the sphere would be lost.
      schedule.add({{.angle = 1, .isometric = 1e-8, .quasi_conformal_1 = 0.1},
                    {.steps = 8, .solver_steps = 200, .relative_gain = 1e-5}});
      return schedule;
    case Method::dissertation:
      return schedule;  // it has a way of its own (dissertation/method.h)
  }
  throw base::Error("invalid-argument", "unknown method");
}

}  // namespace orbicube::sphere_map
