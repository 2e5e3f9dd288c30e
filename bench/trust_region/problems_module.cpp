// The cases behind plain C functions, for compare.py. A handle is made once a case and freed by the caller.
#include <utility>

#include "../problem_functions.h"
#include "problems.h"

using orbicube::bench::Problem;

extern "C" {
std::size_t bench_count() {
  return orbicube::bench::case_count;
}
// transform: as in make_case; -1: with bounds; -2: with start radius 1; others, of which the caller makes other sums of
// the residuals: as they are.
Problem* bench_make(std::size_t index, int transform) {
  Problem problem = transform == -1 ? orbicube::bench::make_bounded_case(index)
                                    : orbicube::bench::make_case(index, transform < 0 ? 0 : transform);
  if (transform == -2) problem.radius_part = 1;
  return new Problem(std::move(problem));
}
void bench_free(Problem* problem) {
  delete problem;
}
std::size_t bench_size(const Problem* problem) {
  return problem->n;
}
std::size_t bench_residuals(const Problem* problem) {
  return problem->m;
}
double bench_radius(const Problem* problem) {
  return problem->start_radius();
}
void bench_data(const Problem* problem, double* start, double* lower, double* upper) {
  orbicube::bench::copy_box(*problem, start, lower, upper);
}
void bench_evaluate(const Problem* problem, const double* x, double* residuals) {
  problem->residuals(x, residuals);
}
}
