// The dual of a support vector machine, of two sets of problems.
#pragma once

#include <cstddef>
#include <vector>

namespace orbicube::bench {

// Returns 0.5 x'Q x - sum of x, for Q row by row, and sets its gradient.
inline double machine_dual(const std::vector<double>& q, std::size_t n, const double* x, double* gradient) {
  double f = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j)
      sum += q[i * n + j] * x[j];
    gradient[i] = sum - 1;
    f += x[i] * (0.5 * sum - 1);
  }
  return f;
}

}  // namespace orbicube::bench
