// The peers of the table, each as a function that runs it on a problem and returns its cost: nothing where the peer
// was not there when this was built, or is not made for the problem.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems.h"

namespace orbicube::bench {

struct Outcome {
  std::size_t evaluations = 0;  // of value and gradient
  std::vector<double> x;
  double seconds = 0;
};

// Whether the peer was there.
bool has_nlopt();
bool has_ipopt();

// NLopt's L-BFGS where there are only bounds, else its SLSQP (up to 200 unknowns).
std::optional<Outcome> run_nlopt(const Problem& problem, std::size_t evaluation_limit, double seconds_limit);

// IPOPT with its limited-memory Hessian, tolerance 1e-8.
std::optional<Outcome> run_ipopt(const Problem& problem, std::size_t evaluation_limit, double seconds_limit);

}  // namespace orbicube::bench
