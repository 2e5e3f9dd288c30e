#include "problems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <utility>

namespace orbicube::bench {
namespace {

std::vector<double> normal_numbers(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> numbers(count);
  for (double& number : numbers)
    number = normal(random);
  return numbers;
}

// N equal charges on the sphere.
Problem thomson(std::size_t count, int conjugate, int barzilai_borwein, int halving) {
  const auto evaluate = [count](const double* x, double* g) {
    double sum = 0;
    std::fill(g, g + 3 * count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        const double dx = x[3 * i] - x[3 * j], dy = x[3 * i + 1] - x[3 * j + 1], dz = x[3 * i + 2] - x[3 * j + 2];
        const double inverse = 1 / std::sqrt(dx * dx + dy * dy + dz * dz), cube = inverse * inverse * inverse;
        sum += inverse;
        const std::array push{cube * dx, cube * dy, cube * dz};
        for (std::size_t k = 0; k < 3; ++k) {
          g[3 * i + k] -= push[k];
          g[3 * j + k] += push[k];
        }
      }
    }
    return sum;
  };
  return {"Thomson " + std::to_string(count),
          count,
          3,
          normal_numbers(3 * count, 1),
          evaluate,
          conjugate,
          barzilai_borwein,
          halving,
          {}};
}

// x'Ax, A symmetric with normal entries.
Problem random_rayleigh(std::size_t n) {
  const std::vector<double> numbers = normal_numbers(n * n, 2);
  std::vector<double> matrix(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      matrix[i * n + j] = 0.5 * (numbers[i * n + j] + numbers[j * n + i]);
  }
  const auto evaluate = [n, matrix](const double* x, double* g) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double row = 0;
      for (std::size_t j = 0; j < n; ++j)
        row += matrix[i * n + j] * x[j];
      g[i] = 2 * row;
      sum += x[i] * row;
    }
    return sum;
  };
  return {"Rayleigh quotient, GOE-" + std::to_string(n), 1, n, normal_numbers(n, 3), evaluate, 353, 161, 20000, {}};
}

// x'Ax, A the second difference of n points.
Problem laplacian(std::size_t n) {
  const auto evaluate = [n](const double* x, double* g) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double row = 2 * x[i] - (i > 0 ? x[i - 1] : 0.0) - (i + 1 < n ? x[i + 1] : 0.0);
      g[i] = 2 * row;
      sum += x[i] * row;
    }
    return sum;
  };
  return {"Rayleigh quotient, 1D Laplacian " + std::to_string(n),
          1,
          n,
          normal_numbers(n, 4),
          evaluate,
          2176,
          2775,
          20000,
          {}};
}

// The relaxation of max-cut with weights of both signs on a torus: sum over i, j of w_ij x_i.x_j.
Problem maximum_cut(std::size_t side, std::size_t dimension) {
  const std::size_t count = side * side;
  struct Edge {
    std::size_t a, b;
    double weight;
  };
  std::vector<Edge> edges;
  std::vector<double> weights(count * count);
  std::mt19937_64 random(5);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t j : {i / side * side + (i + 1) % side, (i + side) % count}) {
      edges.push_back({i, j, random() % 2 ? 1.0 : -1.0});
      weights[i * count + j] = weights[j * count + i] = edges.back().weight;
    }
  }
  const auto evaluate = [=](const double* x, double* g) {
    double sum = 0;
    std::fill(g, g + count * dimension, 0.0);
    for (const Edge& edge : edges) {
      const double *a = x + edge.a * dimension, *b = x + edge.b * dimension;
      double *to_a = g + edge.a * dimension, *to_b = g + edge.b * dimension;
      double along = 0;
      for (std::size_t k = 0; k < dimension; ++k) {
        along += a[k] * b[k];
        to_a[k] += 2 * edge.weight * b[k];
        to_b[k] += 2 * edge.weight * a[k];
      }
      sum += 2 * edge.weight * along;
    }
    return sum;
  };
  return {"max-cut relaxation, torus " + std::to_string(count),
          count,
          dimension,
          normal_numbers(count * dimension, 6),
          evaluate,
          1627,
          2485,
          20000,
          weights};
}

using Quaternion = std::array<double, 4>;

Quaternion product(const double* p, const double* q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1], p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

Quaternion conjugate(const double* q) {
  return {q[0], -q[1], -q[2], -q[3]};
}

// Rotations of nodes from measured rotations between them, 0.1 rad of noise: sum over edges of 1 - (q_a m_ab . q_b)^2.
// The start is 0.3 rad or so off the truth, or anywhere.
Problem synchronisation(bool near) {
  constexpr std::size_t count = 2000;
  struct Edge {
    std::size_t a, b;
    Quaternion measured;
  };
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> truth = normal_numbers(4 * count, 8);
  for (std::size_t i = 0; i < count; ++i) {
    const double length =
        std::hypot(std::hypot(truth[4 * i], truth[4 * i + 1]), std::hypot(truth[4 * i + 2], truth[4 * i + 3]));
    for (std::size_t k = 0; k < 4; ++k)
      truth[4 * i + k] /= length;
  }
  std::vector<Edge> edges;
  std::set<std::pair<std::size_t, std::size_t>> seen;
  while (edges.size() < 11993) {
    const std::size_t a = random() % count, b = random() % count;
    if (a == b || !seen.insert({std::min(a, b), std::max(a, b)}).second) continue;
    Quaternion between = product(conjugate(&truth[4 * a]).data(), &truth[4 * b]);
    const Quaternion noise{1, 0.05 * normal(random), 0.05 * normal(random), 0.05 * normal(random)};
    between = product(between.data(), noise.data());
    const double length = std::hypot(std::hypot(between[0], between[1]), std::hypot(between[2], between[3]));
    for (double& component : between)
      component /= length;
    edges.push_back({a, b, between});
  }
  const auto evaluate = [edges](const double* x, double* g) {
    double sum = 0;
    std::fill(g, g + 4 * count, 0.0);
    for (const Edge& edge : edges) {
      const Quaternion there = product(x + 4 * edge.a, edge.measured.data());
      const Quaternion back = product(x + 4 * edge.b, conjugate(edge.measured.data()).data());
      double along = 0;
      for (std::size_t k = 0; k < 4; ++k)
        along += there[k] * x[4 * edge.b + k];
      sum += 1 - along * along;
      for (std::size_t k = 0; k < 4; ++k) {
        g[4 * edge.b + k] -= 2 * along * there[k];
        g[4 * edge.a + k] -= 2 * along * back[k];
      }
    }
    return sum;
  };
  std::vector<double> start = normal_numbers(4 * count, 9);
  for (std::size_t k = 0; near && k < 4 * count; ++k)
    start[k] = truth[k] + 0.3 * start[k];
  return {near ? "quaternion synchronisation" : "the same from a random start",
          count,
          4,
          start,
          evaluate,
          near ? 424 : 0,
          near ? 34 : 0,
          near ? 189 : 0,
          {}};
}

}  // namespace

std::size_t problem_count() {
  return 7;
}

Problem make_problem(std::size_t index) {
  switch (index) {
    case 0:
      return thomson(50, 440, 271, 2858);
    case 1:
      return thomson(72, 498, 232, 4344);
    case 2:
      return random_rayleigh(500);
    case 3:
      return laplacian(200);
    case 4:
      return maximum_cut(20, 30);
    case 5:
      return synchronisation(true);
    default:
      return synchronisation(false);
  }
}

}  // namespace orbicube::bench
