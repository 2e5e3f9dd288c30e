#include "peers.h"

#include <algorithm>

#ifdef ORBICUBE_BENCH_NLOPT
#include <nlopt.h>
#endif

namespace orbicube::bench {

#ifdef ORBICUBE_BENCH_NLOPT

bool has_nlopt() {
  return true;
}

void run_nlopt(bool newuoa, const std::vector<double>& start, const std::vector<double>& lower,
               const std::vector<double>& upper, double radius, std::size_t budget, const Objective& f) {
  const nlopt_opt solver =
      nlopt_create(newuoa ? NLOPT_LN_NEWUOA : NLOPT_LN_BOBYQA, static_cast<unsigned>(start.size()));
  nlopt_set_lower_bounds(solver, lower.data());
  nlopt_set_upper_bounds(solver, upper.data());
  // Its points must have room within the box.
  for (std::size_t i = 0; i < start.size(); ++i)
    radius = std::min(radius, 0.49 * (upper[i] - lower[i]));
  nlopt_set_initial_step1(solver, radius);
  nlopt_set_xtol_abs1(solver, 1e-8);
  nlopt_set_maxeval(solver, static_cast<int>(budget));
  nlopt_set_min_objective(
      solver, [](unsigned, const double* x, double*, void* user) { return (*static_cast<const Objective*>(user))(x); },
      const_cast<Objective*>(&f));
  std::vector<double> x = start;
  double value = 0;
  nlopt_optimize(solver, x.data(), &value);
  nlopt_destroy(solver);
}

#else

bool has_nlopt() {
  return false;
}

void run_nlopt(bool, const std::vector<double>&, const std::vector<double>&, const std::vector<double>&, double,
               std::size_t, const Objective&) {}

#endif

}  // namespace orbicube::bench
