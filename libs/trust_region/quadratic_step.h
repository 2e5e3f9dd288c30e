// min g's + 0.5 s'Bs over |s| <= radius and lower <= s <= upper, B any symmetric matrix. Without bounds the exact
// solution: More and Sorensen 1983 on the tridiagonal form of B, as in UOBYQA (Powell 2002). With bounds an active-set
// method: unknowns that the solution on the free ones would take across a bound are fixed there, one at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory_resource>

#include "base/array.h"
#include "trust_region/tridiagonal.h"

namespace orbicube::trust_region {

class QuadraticStep {
 public:
  QuadraticStep(std::size_t n, std::pmr::memory_resource* memory);

  // lower <= 0 <= upper, n each, or both null. s (n) is within the bounds exactly and in the ball to rounding.
  void minimise(const double* gradient, const double* matrix, double radius, const double* lower, const double* upper,
                double* s);
  // The minimizer, and that of the quadratic with the opposite sign.
  void minimise_and_maximise(const double* gradient, const double* matrix, double radius, const double* lower,
                             const double* upper, double* lowest, double* highest);

 private:
  // Of the shift, and the magnitude of the eigenvalues.
  struct Bracket {
    double low, high, scale;

    double middle() const { return std::max(std::sqrt(low * high), low + 0.01 * (high - low)); }
  };

  void minimise_in_box(double sign, const double* gradient, const double* matrix, double radius, const double* lower,
                       const double* upper, double* s);
  void reduce(std::size_t size, const double* gradient);
  void minimise_in_ball(double sign, std::size_t size, double radius, double* s);
  void take_sign(double sign, std::size_t size);
  void find_shift(std::size_t size, double radius, double* s);
  Bracket bracket_of_shift(std::size_t size, double radius) const;
  static double raise_shift(Bracket& bracket, double shift, int iteration);
  bool add_lowest_direction(const Bracket& bracket, double shift, std::size_t size, double radius, double length,
                            double* s);
  bool factorise(std::size_t size, double shift);
  void solve(std::size_t size, const double* right, double* x) const;
  double lowest_direction(std::size_t size, double* z);

  std::size_t n_;
  bool tractable_ = false;                            // B and g are finite, and not both zero
  double slope_ = 0;                                  // |g|
  Tridiagonal tridiagonal_;                           // of the free part of B
  base::Array<double> gradient_;                      // g in its coordinates
  base::Array<double> diagonal_, below_;              // of it, with the sign requested
  base::Array<double> inverse_pivot_, lower_;         // its factors LDL'
  base::Array<double> rotated_, trial_, derivative_;  // n each
  base::Array<double> free_gradient_, free_step_;
  base::Array<std::uint32_t> free_;
  base::Array<std::uint8_t> fixed_;
};

}  // namespace orbicube::trust_region
