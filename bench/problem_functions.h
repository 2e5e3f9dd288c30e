// The C functions that every module of problems has for compare.py: make, free, name and evaluate, with a prefix. A
// handle is made once a problem and freed by the caller.
#pragma once

#include <algorithm>
#include <cstddef>

#define ORBICUBE_PROBLEM_FUNCTIONS(Problem, prefix, make_problem)                                  \
  extern "C" Problem* prefix##_make(std::size_t index) {                                           \
    return new Problem(make_problem(index));                                                       \
  }                                                                                                \
  extern "C" void prefix##_free(Problem* problem) {                                                \
    delete problem;                                                                                \
  }                                                                                                \
  extern "C" const char* prefix##_name(const Problem* problem) {                                   \
    return problem->name.c_str();                                                                  \
  }                                                                                                \
  extern "C" double prefix##_evaluate(const Problem* problem, const double* x, double* gradient) { \
    return problem->evaluate(x, gradient);                                                         \
  }

namespace orbicube::bench {

// Start and bounds of a problem that has them, size() numbers each.
template <class Problem>
void copy_box(const Problem& problem, double* start, double* lower, double* upper) {
  std::copy(problem.start.begin(), problem.start.end(), start);
  std::copy(problem.lower.begin(), problem.lower.end(), lower);
  std::copy(problem.upper.begin(), problem.upper.end(), upper);
}

}  // namespace orbicube::bench
