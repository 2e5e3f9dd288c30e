// The problems behind plain C functions, for compare.py.
#include <algorithm>

#include "../problem_functions.h"
#include "problems.h"

using orbicube::bench::Problem;

ORBICUBE_PROBLEM_FUNCTIONS(Problem, bench, orbicube::bench::make_problem)

extern "C" {
std::size_t bench_problems() {
  return orbicube::bench::problem_count();
}
std::size_t bench_count(const Problem* problem) {
  return problem->count;
}
std::size_t bench_dimension(const Problem* problem) {
  return problem->dimension;
}
void bench_start(const Problem* problem, double* start) {
  std::copy(problem->start.begin(), problem->start.end(), start);
}
}
