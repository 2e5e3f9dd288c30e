// The problems behind plain C functions, for compare.py. A handle is made once a problem and freed by the caller.
#include <algorithm>

#include "problems.h"

using orbicube::bench::Problem;

extern "C" {
std::size_t bench_count() {
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
std::size_t bench_size(const Problem* problem) {
  return problem->size();
}
std::size_t bench_rows(const Problem* problem) {
  return problem->rows();
}
void bench_data(const Problem* problem, double* start, double* lower, double* upper) {
  std::copy(problem->start.begin(), problem->start.end(), start);
  std::copy(problem->lower.begin(), problem->lower.end(), lower);
  std::copy(problem->upper.begin(), problem->upper.end(), upper);
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
double bench_evaluate(const Problem* problem, const double* x, double* gradient) {
  return problem->evaluate(x, gradient);
}
}
