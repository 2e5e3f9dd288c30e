// One linear equation along a line of clipped points: find t with sum_j a_j clip(y_j + t a_j, lower_j, upper_j) = rhs.
// The left side never decreases with t and is piecewise linear, so a safeguarded Newton iteration ends at an exact
// piece after a few passes. This is the projection onto a box and one row (Dai and Fletcher 2006, "New algorithms for
// singly linearly constrained quadratic programs"), and the exact line search of the projection onto many rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace orbicube::projected_gradient {

struct RowEquation {
  std::span<const double> a, y, lower, upper;  // n each; a_j = 0 contributes nothing
  double rhs = 0;
};

struct RowRoot {
  double t = 0;
  double residual = 0;       // left side minus rhs at t
  bool feasible = true;      // false: no t can reach rhs; sign(residual) is the side on which it stays
  std::uint32_t passes = 0;  // over the n unknowns
};

// Starts at `start`; ends once |left side - rhs| <= max(accuracy, what rounding leaves).
RowRoot solve_row_equation(const RowEquation& equation, double start, double accuracy);

}  // namespace orbicube::projected_gradient
