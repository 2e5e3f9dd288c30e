// The problems behind plain C functions, for compare.py.
#include <algorithm>

#include "../problem_functions.h"
#include "problems.h"

using orbicube::bench::Problem;

ORBICUBE_PROBLEM_FUNCTIONS(Problem, bench, orbicube::bench::make_problem)

extern "C" {
std::size_t bench_count() {
  return orbicube::bench::problem_count();
}
std::size_t bench_size(const Problem* problem) {
  return problem->size();
}
std::size_t bench_rows(const Problem* problem) {
  return problem->rows();
}
void bench_data(const Problem* problem, double* start, double* lower, double* upper) {
  orbicube::bench::copy_box(*problem, start, lower, upper);
}
// A as a dense matrix, row by row, with its right-hand side.
void bench_linear(const Problem* problem, double* matrix, double* rhs) {
  std::fill(matrix, matrix + problem->rows() * problem->size(), 0.0);
  for (std::size_t i = 0; i < problem->rows(); ++i) {
    rhs[i] = problem->rhs[i];
    for (std::size_t k = problem->row_start[i]; k < problem->row_start[i + 1]; ++k) {
      matrix[i * problem->size() + problem->column[k]] += problem->value[k];
    }
  }
}
}
