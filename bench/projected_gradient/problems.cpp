#include "problems.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <random>

#include "machine_dual.h"

namespace orbicube::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void add_row(Problem& p, const std::vector<std::pair<std::uint32_t, double>>& entries, double rhs) {
  for (const auto& [column, value] : entries) {
    p.column.push_back(column);
    p.value.push_back(value);
  }
  p.row_start.push_back(p.column.size());
  p.rhs.push_back(rhs);
}

// A start with the same coordinate everywhere, and the same bounds.
void set_box(Problem& p, std::size_t n, double start, double lower, double upper) {
  p.start.assign(n, start);
  p.lower.assign(n, lower);
  p.upper.assign(n, upper);
}

// 0.5 sum w (x - c)^2.
double weighted_distance(const std::vector<double>& weight, const std::vector<double>& center, const double* x,
                         double* g) {
  double f = 0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const double d = x[i] - center[i];
    g[i] = weight[i] * d;
    f += 0.5 * g[i] * d;
  }
  return f;
}

double chained_rosenbrock(std::size_t n, const double* x, double* g) {
  double f = 0;
  std::fill(g, g + n, 0.0);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double a = x[i + 1] - x[i] * x[i], b = 1 - x[i];
    f += 100 * a * a + b * b;
    g[i] += -400 * a * x[i] - 2 * b;
    g[i + 1] += 200 * a;
  }
  return f;
}

// Hock and Schittkowski 1981, problems 1, 2 and 53.
Problem hock_schittkowski(int number) {
  Problem p;
  p.name = "HS" + std::to_string(number);
  if (number != 53) {
    p.start = {-2, 1};
    p.lower = {-infinity, number == 1 ? -1.5 : 1.5};
    p.upper = {infinity, infinity};
    p.evaluate = [](const double* x, double* g) { return chained_rosenbrock(2, x, g); };
    return p;
  }
  set_box(p, 5, 2.0, -10.0, 10.0);
  add_row(p, {{0, 1}, {1, 3}}, 0);
  add_row(p, {{2, 1}, {3, 1}, {4, -2}}, 0);
  add_row(p, {{1, 1}, {4, -1}}, 0);
  p.evaluate = [](const double* x, double* g) {
    const double a = x[0] - x[1], b = x[1] + x[2] - 2, c = x[3] - 1, d = x[4] - 1;
    g[0] = 2 * a;
    g[1] = -2 * a + 2 * b;
    g[2] = 2 * b;
    g[3] = 2 * c;
    g[4] = 2 * d;
    return a * a + b * b + c * c + d * d;
  };
  return p;
}

Problem chained_rosenbrock_box(std::size_t n) {
  Problem p;
  p.name = "chained Rosenbrock n=" + std::to_string(n);
  p.start.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    p.start[i] = i % 2 == 0 ? -1.2 : 0.8;
  p.lower.assign(n, -2.0);
  p.upper.assign(n, 0.8);
  p.evaluate = [n](const double* x, double* g) { return chained_rosenbrock(n, x, g); };
  return p;
}

// The elastic-plastic torsion of MINPACK-2 (Averick, Carter, More, Xue 1992) with c = 5 on side^2 inner nodes:
// piecewise linear elements on a square split into triangles, |u| at most the distance to the boundary, started at
// zero.
Problem torsion(std::size_t side) {
  Problem p;
  p.name = "torsion n=" + std::to_string(side * side);
  const double h = 1.0 / static_cast<double>(side + 1);
  for (std::size_t i = 1; i <= side; ++i) {
    for (std::size_t j = 1; j <= side; ++j) {
      p.upper.push_back(static_cast<double>(std::min({i, j, side + 1 - i, side + 1 - j})) * h);
      p.lower.push_back(-p.upper.back());
    }
  }
  p.start.assign(side * side, 0.0);
  p.evaluate = [side, h](const double* x, double* g) {
    const double load = 5 * h * h;
    double f = 0;
    for (std::size_t i = 0; i < side; ++i) {
      for (std::size_t j = 0; j < side; ++j) {
        const std::size_t k = i * side + j;
        const double left = j > 0 ? x[k - 1] : 0, right = j + 1 < side ? x[k + 1] : 0;
        const double below = i > 0 ? x[k - side] : 0, above = i + 1 < side ? x[k + side] : 0;
        g[k] = 4 * x[k] - left - right - below - above - load;
        f += 0.5 * x[k] * (g[k] - load);
      }
    }
    return f;
  };
  return p;
}

// 0.5 |B x - c|^2 with x >= 0 and columns scaled over two decades; half of the unknowns are zero in what c was made of.
Problem nonnegative_least_squares(std::size_t n) {
  Problem p;
  p.name = "NNLS n=" + std::to_string(n);
  const std::size_t rows = 2 * n;
  auto matrix = std::make_shared<std::vector<double>>(rows * n);
  auto rhs = std::make_shared<std::vector<double>>(rows);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> scale(n), planted(n);
  for (std::size_t j = 0; j < n; ++j) {
    scale[j] = std::pow(10.0, 2.0 * static_cast<double>(j) / static_cast<double>(n - 1) - 2.0);
    planted[j] = std::max(0.0, normal(random));
  }
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      (*matrix)[i * n + j] = normal(random) * scale[j] / std::sqrt(static_cast<double>(rows));
      (*rhs)[i] += (*matrix)[i * n + j] * planted[j];
    }
    (*rhs)[i] += 0.1 * normal(random);
  }
  set_box(p, n, 0.0, 0.0, infinity);
  p.evaluate = [n, rows, matrix, rhs](const double* x, double* g) {
    double f = 0;
    std::fill(g, g + n, 0.0);
    for (std::size_t i = 0; i < rows; ++i) {
      const double* row = matrix->data() + i * n;
      double r = -(*rhs)[i];
      for (std::size_t j = 0; j < n; ++j)
        r += row[j] * x[j];
      f += 0.5 * r * r;
      for (std::size_t j = 0; j < n; ++j)
        g[j] += r * row[j];
    }
    return f;
  };
  return p;
}

// Dual of a support vector machine: two overlapping normal clouds in 5 dimensions, Gaussian kernel, 0 <= x <= 10, y'x =
// 0.
Problem support_vector_machine(std::size_t n) {
  Problem p;
  p.name = "SVM dual n=" + std::to_string(n);
  constexpr std::size_t dimension = 5;
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::vector<double> point(n * dimension), label(n);
  for (std::size_t i = 0; i < n; ++i) {
    label[i] = i % 2 == 0 ? 1 : -1;
    for (std::size_t k = 0; k < dimension; ++k)
      point[i * dimension + k] = normal(random) + 0.5 * label[i];
  }
  auto q = std::make_shared<std::vector<double>>(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      double distance = 0;
      for (std::size_t k = 0; k < dimension; ++k) {
        const double d = point[i * dimension + k] - point[j * dimension + k];
        distance += d * d;
      }
      (*q)[i * n + j] = label[i] * label[j] * std::exp(-distance / dimension);
    }
  }
  std::vector<std::pair<std::uint32_t, double>> row;
  for (std::size_t i = 0; i < n; ++i)
    row.emplace_back(static_cast<std::uint32_t>(i), label[i]);
  add_row(p, row, 0);
  set_box(p, n, 0.0, 0.0, 10.0);
  p.evaluate = [n, q](const double* x, double* g) { return machine_dual(*q, n, x, g); };
  return p;
}

// 0.5 sum w (x - c)^2 over a'x = 1, x >= 0, with a and w positive and of different sizes.
Problem weighted_simplex(std::size_t n) {
  Problem p;
  p.name = "weighted simplex n=" + std::to_string(n);
  auto weight = std::make_shared<std::vector<double>>(n);
  auto center = std::make_shared<std::vector<double>>(n);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform;
  std::vector<std::pair<std::uint32_t, double>> row;
  for (std::size_t i = 0; i < n; ++i) {
    (*weight)[i] = 1 + uniform(random);
    (*center)[i] = uniform(random) / std::sqrt(static_cast<double>(n));
    row.emplace_back(static_cast<std::uint32_t>(i), 0.5 + uniform(random));
  }
  add_row(p, row, 1);
  set_box(p, n, 1.0 / static_cast<double>(n), 0.0, infinity);
  p.evaluate = [weight, center](const double* x, double* g) { return weighted_distance(*weight, *center, x, g); };
  return p;
}

// 0.5 sum w (x - c)^2 + sum of fourth powers of neighbors' differences over the doubly stochastic matrices: 2 side
// rows, one of them redundant, weights over three decades.
Problem transport(std::size_t side) {
  Problem p;
  const std::size_t n = side * side;
  p.name = "transport n=" + std::to_string(n) + ", " + std::to_string(2 * side) + " rows";
  auto weight = std::make_shared<std::vector<double>>(n);
  auto center = std::make_shared<std::vector<double>>(n);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform;
  for (std::size_t i = 0; i < n; ++i) {
    (*weight)[i] = std::pow(10.0, 3 * uniform(random));
    (*center)[i] = 2 * uniform(random) / static_cast<double>(side);
  }
  for (std::size_t i = 0; i < side; ++i) {
    std::vector<std::pair<std::uint32_t, double>> row, column;
    for (std::size_t k = 0; k < side; ++k) {
      row.emplace_back(static_cast<std::uint32_t>(i * side + k), 1);
      column.emplace_back(static_cast<std::uint32_t>(k * side + i), 1);
    }
    add_row(p, row, 1);
    add_row(p, column, 1);
  }
  set_box(p, n, 0.0, 0.0, infinity);
  p.evaluate = [n, weight, center](const double* x, double* g) {
    double f = weighted_distance(*weight, *center, x, g);
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const double d = x[i] - x[i + 1], cube = 1e3 * d * d * d;
      f += cube * d;
      g[i] += 4 * cube;
      g[i + 1] -= 4 * cube;
    }
    return f;
  };
  return p;
}

constexpr Problem (*makers[])() = {[] { return hock_schittkowski(1); },
                                   [] { return hock_schittkowski(2); },
                                   [] { return hock_schittkowski(53); },
                                   [] { return chained_rosenbrock_box(1000); },
                                   [] { return torsion(32); },
                                   [] { return torsion(100); },
                                   [] { return torsion(316); },
                                   [] { return nonnegative_least_squares(2000); },
                                   [] { return support_vector_machine(1000); },
                                   [] { return weighted_simplex(100000); },
                                   [] { return transport(100); }};

}  // namespace

std::size_t problem_count() {
  return std::size(makers);
}

Problem make_problem(std::size_t index) {
  return makers[std::min(index, std::size(makers) - 1)]();
}

}  // namespace orbicube::bench
