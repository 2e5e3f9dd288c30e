// Problems with known properties on products of spheres, and runs of the solver on them.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <random>
#include <span>
#include <vector>

#include "sphere_optimizer/solver.h"
#include "tests/solver_runs.h"

namespace orbicube::test {

using sphere_optimizer::Method;
using sphere_optimizer::Options;
using sphere_optimizer::Request;
using sphere_optimizer::Result;
using sphere_optimizer::Shape;
using sphere_optimizer::Solver;
using sphere_optimizer::Stop;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Method every_method[] = {Method::limited_memory, Method::barzilai_borwein, Method::great_circle,
                                          Method::dissertation, Method::truncated_newton};
inline constexpr double ulp = 2.220446049250313e-16;

using Function = std::function<double(std::span<const double> x, std::span<double> gradient)>;

struct Problem {
  Shape shape;
  std::vector<double> start;
  Function function;
};

inline std::vector<double> normal_numbers(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> numbers(count);
  for (double& number : numbers)
    number = normal(random);
  return numbers;
}

// N equal charges on the sphere.
inline Problem thomson(std::size_t count, std::uint64_t seed) {
  const auto energy = [count](std::span<const double> x, std::span<double> g) {
    double sum = 0;
    std::fill(g.begin(), g.end(), 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k)
          square += (x[3 * i + k] - x[3 * j + k]) * (x[3 * i + k] - x[3 * j + k]);
        const double inverse = 1 / std::sqrt(square);
        sum += inverse;
        for (std::size_t k = 0; k < 3; ++k) {
          const double pull = (x[3 * i + k] - x[3 * j + k]) * inverse * inverse * inverse;
          g[3 * i + k] -= pull;
          g[3 * j + k] += pull;
        }
      }
    }
    return sum;
  };
  return {{count, 3}, normal_numbers(3 * count, seed), energy};
}

// x'Ax on one sphere, A the second difference of n points.
inline Problem laplacian(std::size_t n, std::uint64_t seed) {
  const auto energy = [n](std::span<const double> x, std::span<double> g) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double row = 2 * x[i] - (i > 0 ? x[i - 1] : 0.0) - (i + 1 < n ? x[i + 1] : 0.0);
      g[i] = 2 * row;
      sum += x[i] * row;
    }
    return sum;
  };
  return {{1, n}, normal_numbers(n, seed), energy};
}

// The weights, +-1, of a torus of side^2 nodes: of node i to the next in its row and in its column.
inline std::vector<double> torus_weights(std::size_t side, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<double> weights(2 * side * side);
  for (double& weight : weights)
    weight = random() % 2 ? 1 : -1;
  return weights;
}
inline std::size_t torus_neighbor(std::size_t side, std::size_t node, std::size_t along) {
  const std::size_t row = node / side, column = node % side;
  return along == 0 ? row * side + (column + 1) % side : (row + 1) % side * side + column;
}

// The relaxation of max-cut with weights of both signs: sum over both orders of w_ij x_i.x_j.
inline Problem maximum_cut(std::size_t side, std::size_t dimension, std::uint64_t seed) {
  const std::size_t count = side * side;
  const auto energy = [=, weights = torus_weights(side, seed)](std::span<const double> x, std::span<double> g) {
    double sum = 0;
    std::fill(g.begin(), g.end(), 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t along = 0; along < 2; ++along) {
        const std::size_t j = torus_neighbor(side, i, along);
        const double weight = 2 * weights[2 * i + along];
        for (std::size_t k = 0; k < dimension; ++k) {
          sum += weight * x[i * dimension + k] * x[j * dimension + k];
          g[i * dimension + k] += weight * x[j * dimension + k];
          g[j * dimension + k] += weight * x[i * dimension + k];
        }
      }
    }
    return sum;
  };
  return {{count, dimension}, normal_numbers(count * dimension, seed + 1), energy};
}

struct Run {
  Result result;
  std::vector<double> x;
  std::vector<std::vector<double>> asked;  // every point at which f was requested
};

inline Run drive(Solver& solver, const Function& function) {
  return drive_with_gradient<Run>(solver, solver.shape().size(), function);
}

inline Run run(const Problem& problem, const Options& options = {}) {
  const base::Host host;
  Solver solver(problem.shape, options, problem.start, host);
  return drive(solver, problem.function);
}

// Checks that a run that is saved at any evaluation, and loaded into a new solver, goes on with the same bits.
inline void check_resuming_of(const Problem& problem, const Options& options) {
  const base::Host host;
  Solver solver(problem.shape, options, problem.start, host);
  std::vector<double> gradient(problem.shape.size());
  check_resuming(
      solver, run(problem, options),
      [&](Solver& asking) { asking.tell(problem.function(asking.point(), gradient), gradient); },
      [&](std::span<const std::byte> blob) {
        Solver loaded(Solver::shape_of(blob), Solver::options_of(blob), {}, host);
        loaded.load(blob);
        return drive(loaded, problem.function);
      });
}

inline Options with(Method method, double gradient_tolerance = 1e-8) {
  Options options;
  options.method = method;
  options.gradient_tolerance = gradient_tolerance;
  return options;
}

// Largest distance of a block's length from 1, in units of the last place of 1, in extended precision.
inline double length_error(const Shape& shape, std::span<const double> x) {
  long double worst = 0;
  for (std::size_t i = 0; i < shape.count; ++i) {
    long double square = 0;
    for (std::size_t k = i * shape.dimension; k < (i + 1) * shape.dimension; ++k)
      square += static_cast<long double>(x[k]) * x[k];
    worst = std::max(worst, std::abs(std::sqrt(square) - 1));
  }
  return static_cast<double>(worst) / ulp;
}

// Longest tangent gradient of a block, computed afresh.
inline double stationarity(const Problem& problem, std::span<const double> x) {
  std::vector<double> gradient(x.size());
  problem.function(x, gradient);
  const std::size_t d = problem.shape.dimension;
  double worst = 0;
  for (std::size_t i = 0; i < problem.shape.count; ++i) {
    double along = 0, square = 0;
    for (std::size_t k = i * d; k < (i + 1) * d; ++k)
      along += x[k] * gradient[k];
    for (std::size_t k = i * d; k < (i + 1) * d; ++k)
      square += (gradient[k] - along * x[k]) * (gradient[k] - along * x[k]);
    worst = std::max(worst, std::sqrt(square));
  }
  return worst;
}

// Whether the symmetric matrix (by rows, lower triangle) has no eigenvalue below -shift, by a Cholesky factor of it
// plus the shift.
inline bool no_eigenvalue_below(std::vector<double> matrix, std::size_t n, double shift) {
  for (std::size_t j = 0; j < n; ++j) {
    matrix[j * n + j] += shift;
    for (std::size_t i = j; i < n; ++i) {
      double sum = matrix[i * n + j];
      for (std::size_t k = 0; k < j; ++k)
        sum -= matrix[i * n + k] * matrix[j * n + k];
      if (i == j) {
        if (!(sum > 0)) return false;
        matrix[j * n + j] = std::sqrt(sum);
      } else {
        matrix[i * n + j] = sum / matrix[j * n + j];
      }
    }
  }
  return true;
}

}  // namespace orbicube::test
