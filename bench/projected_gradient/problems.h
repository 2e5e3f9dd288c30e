// The benchmark's problems: value and gradient, bounds, linear rows and start of each row of the table. The same
// functions are called by the program (our library, NLopt, IPOPT) and, through a shared object, by compare.py (SciPy).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace orbicube::bench {

struct Problem {
  std::string name;
  std::vector<double> start, lower, upper;
  std::vector<std::size_t> row_start{0};  // the rows of A, CSR
  std::vector<std::uint32_t> column;
  std::vector<double> value, rhs;
  std::function<double(const double* x, double* gradient)> evaluate;

  std::size_t size() const { return start.size(); }
  std::size_t rows() const { return rhs.size(); }
};

std::size_t problem_count();

// The problem of one row of the table; the random ones are made from fixed seeds, so every solver sees the same data.
Problem make_problem(std::size_t index);

}  // namespace orbicube::bench
