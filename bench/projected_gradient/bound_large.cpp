// Many unknowns: CUTEst's quadratics (BIGGSB1, CVXBQP, NCVXBQP) and separable problems, and problems of learning with
// data from fixed seeds: nonnegative least squares and logistic regression, the dual of a support vector machine.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "bound_problems.h"
#include "machine_dual.h"

namespace orbicube::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

BoundProblem uniform_problem(std::string name, std::size_t n, double start, double lower, double upper) {
  BoundProblem p;
  p.name = std::move(name) + " n=" + std::to_string(n);
  p.start.assign(n, start);
  p.lower.assign(n, lower);
  p.upper.assign(n, upper);
  return p;
}

BoundProblem make_biggsb1(std::size_t n) {
  BoundProblem p = uniform_problem("BIGGSB1", n, 0, 0, 0.9);
  p.lower[n - 1] = -infinity;
  p.upper[n - 1] = infinity;
  p.optimum = 0.015;
  p.evaluate = [n](const double* x, double* g) {
    std::fill(g, g + n, 0.0);
    double f = (x[0] - 1) * (x[0] - 1) + (1 - x[n - 1]) * (1 - x[n - 1]);
    g[0] = 2 * (x[0] - 1);
    g[n - 1] = -2 * (1 - x[n - 1]);
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const double d = x[i + 1] - x[i];
      f += d * d;
      g[i + 1] += 2 * d;
      g[i] -= 2 * d;
    }
    return f;
  };
  return p;
}

// The sum of i (x_i + x_j + x_k)^2 / 2 with j and k a times and b times i; negative beyond `positive` terms.
BoundProblem make_box_quadratic(const char* name, std::size_t n, std::size_t a, std::size_t b, std::size_t positive) {
  BoundProblem p = uniform_problem(name, n, 0.5, 0.1, 10);
  p.tolerance = 1e-6;
  p.evaluate = [=](const double* x, double* g) {
    std::fill(g, g + n, 0.0);
    double f = 0;
    for (std::size_t i = 1; i <= n; ++i) {
      const std::size_t j = (a * i - 1) % n, k = (b * i - 1) % n;
      const double weight = i <= positive ? static_cast<double>(i) : -static_cast<double>(i);
      const double sum = x[i - 1] + x[j] + x[k];
      f += 0.5 * weight * sum * sum;
      g[i - 1] += weight * sum;
      g[j] += weight * sum;
      g[k] += weight * sum;
    }
    return f;
  };
  return p;
}

BoundProblem make_mccormick(std::size_t n) {
  BoundProblem p = uniform_problem("MCCORMCK", n, 0, -1.5, 3);
  p.evaluate = [n](const double* x, double* g) {
    std::fill(g, g + n, 0.0);
    double f = 0;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const double d = x[i] - x[i + 1], s = x[i] + x[i + 1];
      f += -1.5 * x[i] + 2.5 * x[i + 1] + 1 + d * d + std::sin(s);
      g[i] += -1.5 + 2 * d + std::cos(s);
      g[i + 1] += 2.5 - 2 * d + std::cos(s);
    }
    return f;
  };
  return p;
}

BoundProblem make_nonscomp(std::size_t n) {
  BoundProblem p = uniform_problem("NONSCOMP", n, 3, -100, 100);
  for (std::size_t i = 0; i < n; i += 2)
    p.lower[i] = 1;
  p.optimum = 0;
  p.evaluate = [n](const double* x, double* g) {
    std::fill(g, g + n, 0.0);
    double f = (x[0] - 1) * (x[0] - 1);
    g[0] = 2 * (x[0] - 1);
    for (std::size_t i = 1; i < n; ++i) {
      const double d = x[i] - x[i - 1] * x[i - 1];
      f += 4 * d * d;
      g[i] += 8 * d;
      g[i - 1] -= 16 * d * x[i - 1];
    }
    return f;
  };
  return p;
}

BoundProblem make_explin(std::size_t n, bool growing) {
  BoundProblem p = uniform_problem(growing ? "EXPLIN2" : "EXPLIN", n, 0, 0, 10);
  p.evaluate = [n, growing](const double* x, double* g) {
    constexpr std::size_t m = 100;
    double f = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double slope = -10 * static_cast<double>(i + 1);
      f += slope * x[i];
      g[i] = slope;
    }
    for (std::size_t i = 0; i < m; ++i) {
      const double factor = growing ? 0.1 * static_cast<double>(i + 1) / m : 0.1;
      const double e = std::exp(factor * x[i] * x[i + 1]);
      f += e;
      g[i] += e * factor * x[i + 1];
      g[i + 1] += e * factor * x[i];
    }
    return f;
  };
  return p;
}

BoundProblem make_chained_rosenbrock(std::size_t n) {
  BoundProblem p = uniform_problem("chained Rosenbrock, x <= 0.8", n, 1, -2, 0.8);
  for (std::size_t i = 0; i < n; i += 2)
    p.start[i] = -1.2;
  p.start[1] = 0.5;
  p.evaluate = [n](const double* x, double* g) {
    std::fill(g, g + n, 0.0);
    double f = 0;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const double d = x[i + 1] - x[i] * x[i], e = 1 - x[i];
      f += 100 * d * d + e * e;
      g[i] += -400 * x[i] * d - 2 * e;
      g[i + 1] += 200 * d;
    }
    return f;
  };
  return p;
}

BoundProblem make_powell_singular(std::size_t n) {
  BoundProblem p = uniform_problem("Powell singular, x >= 0.05 at every fourth", n, 0, -infinity, infinity);
  for (std::size_t i = 0; i < n; i += 4) {
    p.start[i] = 3;
    p.start[i + 1] = -1;
    p.start[i + 3] = 1;
    p.lower[i + 3] = 0.05;
  }
  p.evaluate = [n](const double* x, double* g) {
    double f = 0;
    for (std::size_t i = 0; i < n; i += 4) {
      const double a = x[i] + 10 * x[i + 1], b = x[i + 2] - x[i + 3], c = x[i + 1] - 2 * x[i + 2], d = x[i] - x[i + 3];
      f += a * a + 5 * b * b + c * c * c * c + 10 * d * d * d * d;
      g[i] = 2 * a + 40 * d * d * d;
      g[i + 1] = 20 * a + 4 * c * c * c;
      g[i + 2] = 10 * b - 8 * c * c * c;
      g[i + 3] = -10 * b - 40 * d * d * d;
    }
    return f;
  };
  return p;
}

using Matrix = std::vector<double>;

// f(x) = loss(M x), with loss' into its argument's place.
template <class Loss>
auto through_matrix(std::shared_ptr<Matrix> matrix, std::size_t rows, std::size_t n, Loss loss) {
  return [=](const double* x, double* g) {
    std::fill(g, g + n, 0.0);
    double f = 0;
    for (std::size_t i = 0; i < rows; ++i) {
      const double* row = matrix->data() + i * n;
      double product = 0, slope = 0;
      for (std::size_t j = 0; j < n; ++j)
        product += row[j] * x[j];
      f += loss(i, product, slope);
      for (std::size_t j = 0; j < n; ++j)
        g[j] += slope * row[j];
    }
    return f;
  };
}

std::shared_ptr<Matrix> normal_matrix(std::size_t rows, std::size_t n, double decades, unsigned seed) {
  auto matrix = std::make_shared<Matrix>(rows * n);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      (*matrix)[i * n + j] = normal(random) * std::pow(10, decades * static_cast<double>(j) / static_cast<double>(n));
  }
  return matrix;
}

BoundProblem make_least_squares(std::size_t rows, std::size_t n, double decades) {
  BoundProblem p = uniform_problem("nonnegative least squares, " + std::to_string(static_cast<int>(decades)) +
                                       (decades == 1 ? " decade" : " decades"),
                                   n, 0, 0, infinity);
  auto rhs = std::make_shared<std::vector<double>>(rows);
  for (std::size_t i = 0; i < rows; ++i)
    (*rhs)[i] = std::sin(static_cast<double>(i * i));
  p.evaluate =
      through_matrix(normal_matrix(rows, n, decades, 1), rows, n, [rhs](std::size_t i, double r, double& slope) {
        slope = r - (*rhs)[i];
        return 0.5 * slope * slope;
      });
  return p;
}

BoundProblem make_logistic(std::size_t rows, std::size_t n) {
  BoundProblem p = uniform_problem("nonnegative logistic", n, 0, 0, infinity);
  auto matrix = normal_matrix(rows, n, 0, 2);
  auto label = std::make_shared<std::vector<double>>(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    double sum = 2 * std::sin(static_cast<double>(i * i));
    for (std::size_t j = 0; j < n; ++j)
      sum += (j % 2 == 0 ? 0.2 : -0.2) * (*matrix)[i * n + j];
    (*label)[i] = sum > 0 ? 1 : -1;
  }
  p.evaluate = through_matrix(matrix, rows, n, [label](std::size_t i, double r, double& slope) {
    const double margin = (*label)[i] * r;
    const double e = std::exp(-std::abs(margin));
    slope = -(*label)[i] * (margin > 0 ? e / (1 + e) : 1 / (1 + e));
    return std::log1p(e) + std::max(0.0, -margin);
  });
  return p;
}

// Without an offset, so that there are bounds alone; Gaussian kernel, two overlapping normal clouds in 5 dimensions.
BoundProblem make_support_vectors(std::size_t n) {
  BoundProblem p = uniform_problem("SVM dual without offset", n, 0, 0, 10);
  auto points = normal_matrix(n, 5, 0, 11);
  auto q = std::make_shared<Matrix>(n * n);
  const auto label = [](std::size_t i) { return i % 2 == 0 ? 1.0 : -1.0; };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      double distance = 0;
      for (std::size_t k = 0; k < 5; ++k) {
        const double d = (*points)[i * 5 + k] - (*points)[j * 5 + k] + 0.5 * (label(i) - label(j));
        distance += d * d;
      }
      (*q)[i * n + j] = label(i) * label(j) * std::exp(-distance / 5);
    }
  }
  p.evaluate = [n, q](const double* x, double* g) { return machine_dual(*q, n, x, g); };
  return p;
}

}  // namespace

void add_large_problems(std::vector<BoundProblemMaker>& list) {
  constexpr std::size_t n = 10000;
  list.push_back([] { return make_biggsb1(1000); });
  list.push_back([] {
    BoundProblem p = make_box_quadratic("CVXBQP1", n, 2, 3, n);
    p.optimum = 2.2502250e6;
    return p;
  });
  list.push_back([] { return make_box_quadratic("CVXBQP2", n, 3, 5, n); });
  list.push_back([] { return make_box_quadratic("CVXBQP3", n, 5, 7, n); });
  list.push_back([] { return make_box_quadratic("NCVXBQP1", n, 2, 3, n / 2); });
  list.push_back([] { return make_box_quadratic("NCVXBQP2", n, 2, 3, 3 * n / 4); });
  list.push_back([] { return make_box_quadratic("NCVXBQP3", n, 2, 3, 7 * n / 8); });
  list.push_back([] { return make_mccormick(5000); });
  list.push_back([] { return make_nonscomp(5000); });
  list.push_back([] { return make_explin(1200, false); });
  list.push_back([] { return make_explin(1200, true); });
  list.push_back([] { return make_chained_rosenbrock(1000); });
  list.push_back([] { return make_powell_singular(1000); });
  list.push_back([] { return make_least_squares(400, 300, 0); });
  list.push_back([] { return make_least_squares(400, 300, 1); });
  list.push_back([] { return make_least_squares(400, 300, 2); });
  list.push_back([] { return make_logistic(800, 200); });
  list.push_back([] { return make_support_vectors(500); });
}

std::size_t bound_problem_count() {
  std::vector<BoundProblemMaker> list;
  add_small_problems(list);
  add_fits(list);
  add_obstacles(list);
  add_large_problems(list);
  return list.size();
}

BoundProblem make_bound_problem(std::size_t index) {
  std::vector<BoundProblemMaker> list;
  add_small_problems(list);
  add_fits(list);
  add_obstacles(list);
  add_large_problems(list);
  return list.at(index)();
}

}  // namespace orbicube::bench
