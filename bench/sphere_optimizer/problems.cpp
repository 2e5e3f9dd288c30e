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

// f and the gradient of a sum over pairs.
Problem pair_problem(std::string name, std::size_t count, std::size_t dimension, std::vector<double> start,
                     const PairSum& sum, Problem::Reference reference) {
  const auto evaluate = [=](const double* x, double* g) {
    double value = 0;
    std::fill(g, g + count * dimension, 0.0);
    for (std::size_t k = 0; k < sum.pairs.size(); ++k) {
      const std::size_t a = sum.pairs[k].first * dimension, b = sum.pairs[k].second * dimension;
      value += sum.term(k, x + a, x + b, g + a);
      sum.term(k + sum.pairs.size(), x + b, x + a, g + b);
    }
    return value;
  };
  return {std::move(name), count, dimension, std::move(start), evaluate, sum, reference};
}

// N equal charges on the sphere.
Problem thomson(std::size_t count, Problem::Reference reference) {
  PairSum sum;
  for (std::uint32_t a = 0; a < count; ++a) {
    for (std::uint32_t b = a + 1; b < count; ++b)
      sum.pairs.emplace_back(a, b);
  }
  sum.term = [](std::size_t, const double* x, const double* y, double* g) {
    const std::array away{x[0] - y[0], x[1] - y[1], x[2] - y[2]};
    const double inverse = 1 / std::sqrt(away[0] * away[0] + away[1] * away[1] + away[2] * away[2]);
    for (std::size_t k = 0; g != nullptr && k < 3; ++k)
      g[k] -= inverse * inverse * inverse * away[k];
    return inverse;
  };
  return pair_problem("Thomson " + std::to_string(count), count, 3, normal_numbers(3 * count, 1), sum, reference);
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
  return {"Rayleigh quotient, GOE-" + std::to_string(n), 1, n, normal_numbers(n, 3), evaluate, {}, {353, 161, 20000}};
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
          {},
          {2176, 2775, 20000}};
}

// The relaxation of max-cut with weights of both signs on a torus: sum over i, j of w_ij x_i.x_j.
Problem maximum_cut(std::size_t side, std::size_t dimension) {
  const std::size_t count = side * side;
  PairSum sum;
  std::vector<double> weight, weights(count * count);
  std::mt19937_64 random(5);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t j : {i / side * side + (i + 1) % side, (i + side) % count}) {
      sum.pairs.emplace_back(i, j);
      weight.push_back(random() % 2 ? 1.0 : -1.0);
      weights[i * count + j] = weights[j * count + i] = weight.back();
    }
  }
  sum.term = [weight, dimension](std::size_t pair, const double* x, const double* y, double* g) {
    const double twice = 2 * weight[pair % weight.size()];
    double along = 0;
    for (std::size_t k = 0; k < dimension; ++k) {
      along += x[k] * y[k];
      if (g != nullptr) g[k] += twice * y[k];
    }
    return twice * along;
  };
  Problem problem = pair_problem("max-cut relaxation, torus " + std::to_string(count), count, dimension,
                                 normal_numbers(count * dimension, 6), sum, {1627, 2485, 20000});
  problem.weights = weights;
  return problem;
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
  const auto unit = [](Quaternion q) {
    const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    for (double& component : q)
      component /= length;
    return q;
  };
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> truth = normal_numbers(4 * count, 8);
  for (std::size_t i = 0; i < 4 * count; i += 4) {
    const Quaternion q = unit({truth[i], truth[i + 1], truth[i + 2], truth[i + 3]});
    std::copy(q.begin(), q.end(), truth.begin() + static_cast<std::ptrdiff_t>(i));
  }
  PairSum sum;
  std::vector<Quaternion> measured;
  std::set<std::pair<std::size_t, std::size_t>> seen;
  while (sum.pairs.size() < 11993) {
    const std::size_t a = random() % count, b = random() % count;
    if (a == b || !seen.insert({std::min(a, b), std::max(a, b)}).second) continue;
    const Quaternion between = product(conjugate(&truth[4 * a]).data(), &truth[4 * b]);
    const Quaternion noise{1, 0.05 * normal(random), 0.05 * normal(random), 0.05 * normal(random)};
    measured.push_back(unit(product(between.data(), noise.data())));
    sum.pairs.emplace_back(a, b);
  }
  sum.term = [measured](std::size_t pair, const double* x, const double* y, double* g) {
    const bool forward = pair < measured.size();
    const Quaternion& m = measured[pair % measured.size()];
    // q_a m . q_b = q_a . q_b m'
    const Quaternion image = product(y, (forward ? conjugate(m.data()) : m).data());
    double along = 0;
    for (std::size_t k = 0; k < 4; ++k)
      along += image[k] * x[k];
    for (std::size_t k = 0; g != nullptr && k < 4; ++k)
      g[k] -= 2 * along * image[k];
    return 1 - along * along;
  };
  std::vector<double> start = normal_numbers(4 * count, 9);
  for (std::size_t k = 0; near && k < 4 * count; ++k)
    start[k] = truth[k] + 0.3 * start[k];
  return pair_problem(near ? "quaternion synchronisation" : "the same from a random start", count, 4, start, sum,
                      near ? Problem::Reference{424, 34, 189} : Problem::Reference{});
}

// Quaternions on a cubic lattice, side^3 of them, with up to six neighbors each: sum of 1 - (x_i . x_j)^2.
Problem lattice(std::size_t side) {
  const std::size_t count = side * side * side;
  PairSum sum;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % side + 1 < side) sum.pairs.emplace_back(i, i + 1);
    if (i / side % side + 1 < side) sum.pairs.emplace_back(i, i + side);
    if (i / side / side + 1 < side) sum.pairs.emplace_back(i, i + side * side);
  }
  sum.term = [](std::size_t, const double* x, const double* y, double* g) {
    double along = 0;
    for (std::size_t k = 0; k < 4; ++k)
      along += x[k] * y[k];
    for (std::size_t k = 0; g != nullptr && k < 4; ++k)
      g[k] -= 2 * along * y[k];
    return 1 - along * along;
  };
  std::vector<double> start = normal_numbers(4 * count, 10);
  for (std::size_t i = 0; i < 4 * count; i += 4)
    start[i] += 1.5;
  return pair_problem("quaternions on a lattice of " + std::to_string(side) + "^3", count, 4, start, sum, {});
}

}  // namespace

std::size_t problem_count() {
  return 8;
}

Problem make_problem(std::size_t index) {
  switch (index) {
    case 0:
      return thomson(50, {440, 271, 2858});
    case 1:
      return thomson(72, {498, 232, 4344});
    case 2:
      return random_rayleigh(500);
    case 3:
      return laplacian(200);
    case 4:
      return maximum_cut(20, 30);
    case 5:
      return synchronisation(true);
    case 6:
      return synchronisation(false);
    default:
      return lattice(20);
  }
}

}  // namespace orbicube::bench
