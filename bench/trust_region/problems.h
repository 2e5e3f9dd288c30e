// The benchmark of More and Wild 2009, "Benchmarking derivative-free optimization algorithms": 22 families of
// residuals, 53 cases, each also under a rotation or permutation of its variables and with a box that is active at the
// solution.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace orbicube::bench {

enum class Norm { squares, magnitudes, largest };  // f of the residuals: sum r^2, sum |r| or max |r|

struct Problem {
  std::string name;
  int family = 0;
  std::size_t n = 0, m = 0;
  std::vector<double> start;
  std::vector<double> lower, upper;  // infinite where there are none
  std::vector<double> rotation;      // n x n, orthogonal, or empty: the variables are rotation times the family's
  double noise_relative = 0, noise_absolute = 0;
  std::vector<double> sign;  // m, or empty: all +1
  double radius_part = 0.1;
  bool squares = true;                // false: f is the one residual itself
  Norm norm = Norm::squares;          // of the residuals
  static constexpr int suite = 1000;  // family of the first row of suite.h

  bool bounded() const;
  // The residuals at x (m entries); noise is a fixed function of x.
  void residuals(const double* x, double* r) const;
  double objective(const std::vector<double>& r) const;
  double start_radius() const;  // radius_part max(1, |x0|inf)
};

inline constexpr std::size_t case_count = 53;

// Number 0 leaves the variables as they are; 1 to 6 rotate them, 7 to 10 permute them.
Problem make_case(std::size_t index, int transform = 0);
// The same with a box around the start that cuts off most solutions.
Problem make_bounded_case(std::size_t index);
// Families of any size: chained Rosenbrock, Broyden's tridiagonal function, a discrete boundary value problem, the
// variably dimensioned function.
inline constexpr int large_count = 4;
Problem make_large(int kind, std::size_t n);
// min sum (x_i - c_i)^2 (weights) - sum of small squares, within a box: a signed sum.
Problem make_signed(std::size_t index);
inline constexpr std::size_t signed_count = 12;

}  // namespace orbicube::bench
