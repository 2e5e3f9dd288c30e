// The problems with bounds only behind plain C functions, for bound_problems.py.
#include <algorithm>

#include "bound_problems.h"

using orbicube::bench::BoundProblem;

extern "C" {
std::size_t bound_count() {
  return orbicube::bench::bound_problem_count();
}
BoundProblem* bound_make(std::size_t index) {
  return new BoundProblem(orbicube::bench::make_bound_problem(index));
}
void bound_free(BoundProblem* problem) {
  delete problem;
}
const char* bound_name(const BoundProblem* problem) {
  return problem->name.c_str();
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
  std::copy(problem->start.begin(), problem->start.end(), start);
  std::copy(problem->lower.begin(), problem->lower.end(), lower);
  std::copy(problem->upper.begin(), problem->upper.end(), upper);
}
double bound_evaluate(const BoundProblem* problem, const double* x, double* gradient) {
  return problem->evaluate(x, gradient);
}
}
