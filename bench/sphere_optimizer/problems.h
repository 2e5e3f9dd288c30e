// The benchmark's problems: f with its gradient over N spheres in R^d, and the start. The same functions are called by
// the program and, through a shared object, by compare.py.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace orbicube::bench {

// A sum over pairs of blocks: term(pair, x, y, gradient) is the part of one pair with its first block at x and its
// second at y, or the other way round for pair + pairs.size(), with the gradient by x added where it is not null.
struct PairSum {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::function<double(std::size_t pair, const double* x, const double* y, double* gradient)> term;
};

struct Problem {
  std::string name;
  std::size_t count = 0, dimension = 0;
  std::vector<double> start;
  std::function<double(const double* x, double* gradient)> evaluate;
  PairSum pair_sum;  // f again, block by block; no pairs where it is no such sum
  // Evaluations that Riemannian conjugate gradients, Riemannian Barzilai-Borwein steps and halving of great circles
  // took on a problem of this kind (other random data), when the table was planned; 20000 is where they were stopped.
  struct Reference {
    int conjugate = 0, barzilai_borwein = 0, halving = 0;
  } reference;
  // For the relaxation of max-cut: its matrix, count x count, by rows; else empty.
  std::vector<double> weights = {};
};

std::size_t problem_count();

// The problem of one row of the table; the random ones are made from fixed seeds.
Problem make_problem(std::size_t index);

}  // namespace orbicube::bench
