// The benchmark's problems: f with its gradient over N spheres in R^d, and the start. The same functions are called by
// the program and, through a shared object, by compare.py.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace orbicube::bench {

struct Problem {
  std::string name;
  std::size_t count, dimension;
  std::vector<double> start;
  std::function<double(const double* x, double* gradient)> evaluate;
  // Evaluations that Riemannian conjugate gradients, Riemannian Barzilai-Borwein steps and halving of great circles
  // took on a problem of this kind (other random data), when the table was planned; 20000 is where they were stopped.
  int reference_conjugate, reference_barzilai_borwein, reference_halving;
  // For the relaxation of max-cut: its matrix, count x count, by rows; else empty.
  std::vector<double> weights;
};

std::size_t problem_count();

// The problem of one row of the table; the random ones are made from fixed seeds.
Problem make_problem(std::size_t index);

}  // namespace orbicube::bench
