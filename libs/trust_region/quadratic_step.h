// min g's + 0.5 s'Bs over |s| <= radius and lower <= s <= upper, B any symmetric matrix. Without bounds the exact
// solution: More and Sorensen 1983 on the tridiagonal form of B, as in UOBYQA (Powell 2002). With bounds an active-set
// method: unknowns that the solution on the free ones would take across a bound are fixed there, one at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>

#include "base/array.h"

namespace orbicube::trust_region {

class QuadraticStep {
 public:
  QuadraticStep(std::size_t n, std::pmr::memory_resource* memory);

  // lower <= 0 <= upper, n each, or both null. s (n) is within the bounds exactly and in the ball to rounding.
  void minimise(const double* gradient, const double* matrix, double radius, const double* lower, const double* upper,
                double* s);

 private:
  void minimise_in_ball(std::size_t size, const double* gradient, double radius, double* s);
  void to_tridiagonal(std::size_t size);
  bool solve(std::size_t size, double shift, const double* right, double* x);
  double lowest_eigenvalue(std::size_t size) const;
  void add_lowest_direction(std::size_t size, double shift, double radius, double* s);

  std::size_t n_;
  base::Array<double> reduced_;  // n x n: the free part of B, then the reflectors of its tridiagonal form
  base::Array<double> diagonal_, below_, factor_;     // of the tridiagonal matrix; beta of the reflectors
  base::Array<double> pivots_;                        // of its LDL'
  base::Array<double> rotated_, trial_, derivative_;  // n each
  base::Array<double> free_gradient_, free_step_;
  base::Array<std::uint32_t> free_;
  base::Array<std::uint8_t> fixed_;
};

}  // namespace orbicube::trust_region
