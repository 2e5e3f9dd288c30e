// Problems with bounds only, from published collections (Hock and Schittkowski 1981; More, Garbow and Hillstrom 1981;
// CUTEst; MINPACK-2), written from their definitions; and problems on generated data, as their names or files say.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "problems.h"

namespace orbicube::bench {

struct BoundProblem : Problem {
  // The minimum of f as published, where the problem has one; NaN: not known.
  double optimum = std::numeric_limits<double>::quiet_NaN();
  // The projected gradient that counts as solved. Not reached by rounding: then f near the optimum counts.
  double tolerance = 1e-6;
};

std::size_t bound_problem_count();
BoundProblem make_bound_problem(std::size_t index);

using BoundProblemMaker = std::function<BoundProblem()>;
// The parts of the list: few unknowns, fits of models to data, discretized obstacles, many unknowns.
void add_small_problems(std::vector<BoundProblemMaker>& list);
void add_fits(std::vector<BoundProblemMaker>& list);
void add_obstacles(std::vector<BoundProblemMaker>& list);
void add_large_problems(std::vector<BoundProblemMaker>& list);

}  // namespace orbicube::bench
