// A second set of problems in the manner of CUTEst, which the solver was not developed on: More, Garbow and Hillstrom
// 1981 beyond the families of More and Wild; Hock and Schittkowski 1981; Toint 1983, Luksan and Vlcek 1999, and others
// from CUTEst. Those without bounds are seen through a random rotation and scaling of the variables, those with bounds
// through a random scaling.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "problems.h"

namespace orbicube::bench {

struct SuiteRow {
  const char* name;
  std::size_t n, m;                         // m = 0: a scalar f
  std::vector<double> start, lower, upper;  // repeated along the variables; no bounds where empty
  double slope;                             // start_i += i slope
  void (*evaluate)(std::size_t n, const double* x, double* outputs);  // m residuals, or f
};

// Sums of squares without bounds, scalar f without bounds, and those with bounds.
std::vector<SuiteRow> suite_squares();
std::vector<SuiteRow> suite_values();
std::vector<SuiteRow> suite_bounded();

// All of them, one after the other.
const std::vector<SuiteRow>& suite_rows();
Problem make_suite_case(std::size_t index);
// The residuals, or f as the only one, of a row.
void suite_residuals(std::size_t index, std::size_t n, const double* x, double* r);

}  // namespace orbicube::bench
