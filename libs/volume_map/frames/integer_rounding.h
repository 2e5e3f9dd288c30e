// Integers that minimize a quadratic, subject to lower bounds of sums: those most certain are rounded first and the
// rest adapts, then single steps improve, then a search by branches with a bound (Schnorr and Euchner 1994) does.
#pragma once

#include <Eigen/Core>

#include "volume_map/frames/integer_forms.h"

namespace orbicube::volume_map {

// The minimum value that a sum of integers may have.
struct LowerBound {
  Index form;
  int least;
};

struct RoundingOptions {
  std::uint64_t max_nodes = 200'000;  // of the search
};

struct Rounding {
  Eigen::VectorXd integers;
  double cost = 0;           // (c - best)' curvature (c - best)
  bool optimal = false;      // the search came to its end
  std::size_t violated = 0;  // bounds that are not met, and the first of them
  std::size_t first_violated = 0;
};

// `curvature` is positive definite. Throws Error "cancelled". The same in every run.
Rounding round_integers(const Eigen::MatrixXd& curvature, const Eigen::VectorXd& best, const IntegerForms& forms,
                        std::span<const LowerBound> bounds, const RoundingOptions& options, const base::Host& host);

}  // namespace orbicube::volume_map
