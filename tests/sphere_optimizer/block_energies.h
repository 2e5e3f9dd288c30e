// Energies for the block-wise tests, with and without the functions that an energy may have.
#pragma once

#include <cmath>
#include <vector>

#include "problems.h"
#include "sphere_optimizer/spheres.h"

namespace orbicube::test {

// Charges on the sphere; the part of a block is its energy with all others.
class ChargeEnergy {
 public:
  explicit ChargeEnergy(const std::vector<double>& points) : points_(points) {}

  sphere_optimizer::FixedDimension<3> dimension() const { return {}; }
  std::size_t count() const { return points_.size() / 3; }
  double value(std::size_t block, const double* x) const {
    double sum = 0;
    for_each_neighbor(block, [&](std::size_t other) {
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k)
        square += (x[k] - points_[3 * other + k]) * (x[k] - points_[3 * other + k]);
      sum += 1 / std::sqrt(square);
    });
    return sum;
  }
  double value_and_gradient(std::size_t block, double* gradient) const {
    double hessian[9];
    return derivatives(block, gradient, hessian);
  }
  template <class Visit>
  void for_each_neighbor(std::size_t block, const Visit& visit) const {
    for (std::size_t other = 0; other < count(); ++other) {
      if (other != block) visit(other);
    }
  }

 protected:
  double derivatives(std::size_t block, double* gradient, double* hessian) const {
    const double* x = &points_[3 * block];
    double sum = 0;
    std::fill(gradient, gradient + 3, 0.0);
    std::fill(hessian, hessian + 9, 0.0);
    for_each_neighbor(block, [&](std::size_t other) {
      double away[3], square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        away[k] = x[k] - points_[3 * other + k];
        square += away[k] * away[k];
      }
      const double inverse = 1 / std::sqrt(square), cube = inverse * inverse * inverse;
      sum += inverse;
      for (std::size_t k = 0; k < 3; ++k) {
        gradient[k] -= cube * away[k];
        for (std::size_t l = 0; l < 3; ++l)
          hessian[3 * k + l] += 3 * cube * inverse * inverse * away[k] * away[l] - (k == l ? cube : 0.0);
      }
    });
    return sum;
  }

  const std::vector<double>& points_;
};

class ChargeEnergyWithHessian : public ChargeEnergy {
 public:
  using ChargeEnergy::ChargeEnergy;
  double value_gradient_and_hessian(std::size_t block, double* gradient, double* hessian) const {
    return derivatives(block, gradient, hessian);
  }
};

// Vectors in R^d on a ring: sum of 1 - (x_i . x_j)^2 over neighbors, with the two ends of one place held by what pins
// them. Least with all blocks equal up to sign.
template <class Dimension>
class RingEnergy {
 public:
  RingEnergy(Dimension d, const std::vector<double>& points) : d_(d), points_(points), count_(points.size() / d) {}

  Dimension dimension() const { return d_; }
  double value(std::size_t block, const double* x) const {
    double sum = 0;
    for_each_neighbor(block, [&](std::size_t other) {
      const double along = sphere_optimizer::block_dot(d_, x, &points_[other * d_]);
      sum += 1 - along * along;
    });
    return sum;
  }
  double value_and_gradient(std::size_t block, double* gradient) const {
    const double* x = &points_[block * d_];
    double sum = 0;
    for (std::size_t k = 0; k < d_; ++k)
      gradient[k] = 0;
    for_each_neighbor(block, [&](std::size_t other) {
      const double* y = &points_[other * d_];
      const double along = sphere_optimizer::block_dot(d_, x, y);
      sum += 1 - along * along;
      for (std::size_t k = 0; k < d_; ++k)
        gradient[k] -= 2 * along * y[k];
    });
    return sum;
  }
  template <class Visit>
  void for_each_neighbor(std::size_t block, const Visit& visit) const {
    visit((block + 1) % count_);
    visit((block + count_ - 1) % count_);
  }
  double total() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i)
      sum += 0.5 * value(i, &points_[i * d_]);
    return sum;
  }

 protected:
  Dimension d_;
  const std::vector<double>& points_;
  std::size_t count_;
};

// The same for quaternions, each step to the best place: with two neighbors their sum or difference.
class ClosedRingEnergy : public RingEnergy<sphere_optimizer::FixedDimension<4>> {
 public:
  explicit ClosedRingEnergy(const std::vector<double>& points) : RingEnergy({}, points) {}
  bool minimizer(std::size_t block, double* x) const {
    const double* a = &points_[(block + 1) % count_ * 4];
    const double* b = &points_[(block + count_ - 1) % count_ * 4];
    const double sign = sphere_optimizer::block_dot(d_, a, b) < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 4; ++k)
      x[k] = a[k] + sign * b[k];
    return true;
  }
};

inline std::vector<double> unit_blocks(std::size_t count, std::size_t d, std::uint64_t seed) {
  std::vector<double> points = normal_numbers(count * d, seed);
  for (std::size_t i = 0; i < count; ++i)
    REQUIRE(sphere_optimizer::normalize(d, &points[i * d]));
  return points;
}

// The same near one place: on a ring, blocks that start anywhere may also end wound up.
inline std::vector<double> blocks_near_one(std::size_t count, std::size_t d, std::uint64_t seed) {
  std::vector<double> points = normal_numbers(count * d, seed);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < d; ++k)
      points[i * d + k] = 0.6 / std::sqrt(static_cast<double>(d)) * points[i * d + k] + (k == 1 ? 1 : 0);
    REQUIRE(sphere_optimizer::normalize(d, &points[i * d]));
  }
  return points;
}

}  // namespace orbicube::test
