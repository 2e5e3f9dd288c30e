// A problem of the benchmarks as the C interface takes it.
#pragma once

#include <orbicube/projected_gradient.h>

#include "problems.h"

namespace orbicube::bench {

// A view of `p`.
inline obc_projected_gradient_problem to_c(const Problem& p) {
  obc_projected_gradient_problem c;
  obc_projected_gradient_problem_init(&c, sizeof c);
  c.n = p.size();
  c.m = p.rows();
  c.lower = p.lower.data();
  c.upper = p.upper.data();
  c.row_start = p.row_start.data();
  c.column = p.column.data();
  c.value = p.value.data();
  c.b = p.rhs.data();
  return c;
}

}  // namespace orbicube::bench
