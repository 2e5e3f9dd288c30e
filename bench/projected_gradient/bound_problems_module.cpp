// The problems with bounds only behind plain C functions, for bound_problems.py.
#include "../problem_functions.h"
#include "bound_problems.h"

using orbicube::bench::BoundProblem;

ORBICUBE_PROBLEM_FUNCTIONS(BoundProblem, bound, orbicube::bench::make_bound_problem)

extern "C" {
std::size_t bound_count() {
  return orbicube::bench::bound_problem_count();
}
std::size_t bound_size(const BoundProblem* problem) {
  return problem->size();
}
double bound_optimum(const BoundProblem* problem) {
  return problem->optimum;
}
double bound_tolerance(const BoundProblem* problem) {
  return problem->tolerance;
}
void bound_data(const BoundProblem* problem, double* start, double* lower, double* upper) {
  orbicube::bench::copy_box(*problem, start, lower, upper);
}
}
