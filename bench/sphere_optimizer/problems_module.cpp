// The problems behind plain C functions, for compare.py. A handle is made once a problem and freed by the caller.
#include <algorithm>

#include "problems.h"

using orbicube::bench::Problem;

extern "C" {
std::size_t bench_problems() {
  return orbicube::bench::problem_count();
}
Problem* bench_make(std::size_t index) {
  return new Problem(orbicube::bench::make_problem(index));
}
void bench_free(Problem* problem) {
  delete problem;
}
const char* bench_name(const Problem* problem) {
  return problem->name.c_str();
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
double bench_evaluate(const Problem* problem, const double* x, double* gradient) {
  return problem->evaluate(x, gradient);
}
}
