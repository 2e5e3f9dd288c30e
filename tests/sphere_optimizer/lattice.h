// An energy as a library writes it for the optimizer: a lattice of quaternions (d = 4). Also for the benchmark.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "base/sums.h"
#include "sphere_optimizer/spheres.h"

namespace orbicube::test {

// Sum of 1 - (x_i . x_j)^2 over neighbors in a cube of side^3 quaternions: rotations that want to agree, x or -x.
class LatticeEnergy {
 public:
  LatticeEnergy(std::size_t side, std::span<const double> points) : side_(side), points_(points) {}

  sphere_optimizer::FixedDimension<4> dimension() const { return {}; }
  std::size_t count() const { return side_ * side_ * side_; }
  double value(std::size_t block, const double* x) const {
    double sum = 0;
    for_each_neighbor(block, [&](std::size_t other) {
      const double along = sphere_optimizer::block_dot(dimension(), x, &points_[4 * other]);
      sum += 1 - along * along;
    });
    return sum;
  }
  double value_and_gradient(std::size_t block, double* gradient) const {
    std::fill_n(gradient, 4, 0.0);
    double sum = 0;
    for_each_neighbor(block, [&](std::size_t other) {
      const double* y = &points_[4 * other];
      const double along = sphere_optimizer::block_dot(dimension(), &points_[4 * block], y);
      sum += 1 - along * along;
      for (std::size_t k = 0; k < 4; ++k)
        gradient[k] -= 2 * along * y[k];
    });
    return sum;
  }
  template <class Visit>
  void for_each_neighbor(std::size_t block, const Visit& visit) const {
    const std::size_t x = block % side_, y = block / side_ % side_, z = block / side_ / side_;
    if (x > 0) visit(block - 1);
    if (x + 1 < side_) visit(block + 1);
    if (y > 0) visit(block - side_);
    if (y + 1 < side_) visit(block + side_);
    if (z > 0) visit(block - side_ * side_);
    if (z + 1 < side_) visit(block + side_ * side_);
  }

  // All parts together, each pair once, with the gradients of all blocks.
  double all(std::span<double> gradient) const {
    return 0.5 * base::blocked_sum(count(), [&](std::size_t i) { return value_and_gradient(i, &gradient[4 * i]); });
  }

 private:
  std::size_t side_;
  std::span<const double> points_;
};

}  // namespace orbicube::test
