// Charges of different sizes on the sphere, for the tests of sphere_optimizer: as a whole and block by block.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "orbicube/sphere_optimizer.h"

namespace orbicube::test {

inline constexpr std::size_t charges = 9, unknowns = 3 * charges;
using Points = std::array<double, unknowns>;

// Charges of different sizes on the sphere.
inline double size_of(std::size_t i) {
  return 1 + 0.1 * static_cast<double>(i);
}

inline double evaluate(const double* x, double* gradient) {
  double f = 0;
  std::fill(gradient, gradient + unknowns, 0.0);
  for (std::size_t i = 0; i < charges; ++i) {
    for (std::size_t j = i + 1; j < charges; ++j) {
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k)
        square += (x[3 * i + k] - x[3 * j + k]) * (x[3 * i + k] - x[3 * j + k]);
      const double term = size_of(i) * size_of(j) / std::sqrt(square);
      f += term;
      for (std::size_t k = 0; k < 3; ++k) {
        const double push = term / square * (x[3 * i + k] - x[3 * j + k]);
        gradient[3 * i + k] -= push;
        gradient[3 * j + k] += push;
      }
    }
  }
  return f;
}

inline Points start() {
  Points x;
  for (std::size_t k = 0; k < unknowns; ++k)
    x[k] = std::sin(1.0 + 2.5 * static_cast<double>(k * k));
  return x;
}

inline std::int32_t callback(const double* x, std::size_t count, std::size_t dimension, double* value, double* gradient,
                             void* user) {
  if (count != charges || dimension != 3) return OBC_SPHERE_OPTIMIZER_STOP;
  if (user != nullptr) ++*static_cast<int*>(user);
  *value = evaluate(x, gradient);
  return OBC_SPHERE_OPTIMIZER_CONTINUE;
}

// The product of the Hessian and a direction v: of a pair with difference u and term t / |u| it is
// t (3 u (u.v) / |u|^5 - v / |u|^3), v the difference of the directions.
inline std::int32_t product_callback(const double* x, const double* direction, std::size_t count, std::size_t dimension,
                                     double* product, void* user) {
  if (count != charges || dimension != 3) return OBC_SPHERE_OPTIMIZER_STOP;
  if (user != nullptr) ++*static_cast<int*>(user);
  std::fill(product, product + unknowns, 0.0);
  for (std::size_t i = 0; i < charges; ++i) {
    for (std::size_t j = i + 1; j < charges; ++j) {
      double square = 0, along = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double u = x[3 * i + k] - x[3 * j + k];
        square += u * u;
        along += u * (direction[3 * i + k] - direction[3 * j + k]);
      }
      const double factor = size_of(i) * size_of(j) / (square * std::sqrt(square));
      for (std::size_t k = 0; k < 3; ++k) {
        const double u = x[3 * i + k] - x[3 * j + k], v = direction[3 * i + k] - direction[3 * j + k];
        const double part = factor * (3 * u * along / square - v);
        product[3 * i + k] += part;
        product[3 * j + k] -= part;
      }
    }
  }
  return OBC_SPHERE_OPTIMIZER_CONTINUE;
}

// Everybody is everybody's neighbor.
struct Blocks {
  std::array<std::size_t, charges + 1> start{};
  std::array<std::uint32_t, charges*(charges - 1)> neighbor{};
  obc_sphere_optimizer_blocks blocks{};

  Blocks() {
    std::size_t to = 0;
    for (std::uint32_t i = 0; i < charges; ++i) {
      for (std::uint32_t j = 0; j < charges; ++j) {
        if (i != j) neighbor[to++] = j;
      }
      start[i + 1] = to;
    }
    obc_sphere_optimizer_blocks_init(&blocks, sizeof blocks);
    blocks.dimension = 3;
    blocks.count = charges;
    blocks.neighbor_start = start.data();
    blocks.neighbor = neighbor.data();
  }
  Blocks(const Blocks&) = delete;
};

inline std::int32_t block_callback(std::size_t block, const double* place, const double* points, double* value,
                                   double* gradient, double* hessian, void* user) {
  if (user != nullptr) ++*static_cast<int*>(user);
  double f = 0;
  if (gradient != nullptr) std::fill(gradient, gradient + 3, 0.0);
  if (hessian != nullptr) std::fill(hessian, hessian + 9, 0.0);
  for (std::size_t j = 0; j < charges; ++j) {
    if (j == block) continue;
    double away[3], square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      away[k] = place[k] - points[3 * j + k];
      square += away[k] * away[k];
    }
    const double term = size_of(block) * size_of(j) / std::sqrt(square);
    f += term;
    for (std::size_t k = 0; k < 3; ++k) {
      if (gradient != nullptr) gradient[k] -= term / square * away[k];
      for (std::size_t l = 0; hessian != nullptr && l < 3; ++l)
        hessian[3 * k + l] += term / square * (3 * away[k] * away[l] / square - (k == l ? 1.0 : 0.0));
    }
  }
  *value = f;
  return OBC_SPHERE_OPTIMIZER_CONTINUE;
}

template <class Result>
Result empty() {
  Result result{};
  result.struct_size = sizeof result;
  return result;
}

}  // namespace orbicube::test
