// The recurrence of conjugate gradients (Hestenes and Stiefel 1952), preconditioned or not. A system holds the vectors
// and makes its passes over them; lengths, directions and the end of a run are decided here.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

namespace orbicube::linear {

// Sum of products, added in the order of the entries.
inline double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

// The scalars for one right side: r is the residual, z the preconditioned residual.
class ConjugateScalars {
 public:
  // `square` is r . z at the start. The run ends where it is `tolerance` squared of that.
  ConjugateScalars(double square, double tolerance)
      : square_(square), start_(square), enough_(tolerance * tolerance * square) {}

  bool converged() const { return !(square_ > enough_ && square_ > 0); }
  double square() const { return square_; }
  double start() const { return start_; }

  // Whether the matrix is positive along a direction whose product with its image is `curvature`, and no overflow.
  static bool positive(double curvature) { return curvature > 0 && std::isfinite(curvature); }
  // Length of the step along the direction.
  double length(double curvature) const { return square_ / curvature; }
  // Takes r . z after the step; returns the share of the direction in the next one.
  double advance(double next) {
    const double share = next / square_;
    square_ = next;
    return share;
  }

 private:
  double square_, start_, enough_;
};

struct ConjugateGradientsOutcome {
  int steps = 0;
  bool not_positive = false;  // the matrix was not positive along the last direction, which no step was made along
  double start = 0, end = 0;  // r . z
};

// Solves a system, from where it stands, until r . z is tolerance^2 of what it was or after max_steps. A system has
//   double start():               sets r, z and the direction d = z; returns r . z
//   double multiply():            sets the image A d; returns d . A d
//   double advance(double a):     x += a d; r -= a A d; sets z; returns r . z
//   void turn(double share):      d = z + share d
// and, where its preconditioner changes from step to step (Notay 2000, "Flexible conjugate gradients"),
//   double along():               returns d . r, which replaces r . z in the length of a step
//   double overlap():             returns z . A d, of which the next direction gets rid
template <class System>
ConjugateGradientsOutcome conjugate_gradients(System& system, int max_steps, double tolerance) {
  ConjugateGradientsOutcome outcome;
  ConjugateScalars scalars(system.start(), tolerance);
  for (; outcome.steps < max_steps && !scalars.converged(); ++outcome.steps) {
    const double curvature = system.multiply();
    outcome.not_positive = !ConjugateScalars::positive(curvature);
    if (outcome.not_positive) break;
    if constexpr (requires { system.overlap(); }) {
      scalars.advance(system.advance(system.along() / curvature));
      system.turn(-system.overlap() / curvature);
    } else {
      system.turn(scalars.advance(system.advance(scalars.length(curvature))));
    }
  }
  outcome.start = scalars.start();
  outcome.end = scalars.square();
  return outcome;
}

}  // namespace orbicube::linear
