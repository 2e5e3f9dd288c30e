// Discretized obstacle problems with their published data (MINPACK-2: Averick, Carter, More and Xue 1992): torsion of a
// bar, membranes over and between obstacles, a journal bearing, a minimal surface; and a beam over an obstacle.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "bound_problems.h"

namespace orbicube::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

// v at a node of the grid with `side` nodes inside each way; zero on its boundary.
double at(const double* v, std::size_t side, std::size_t i, std::size_t j) {
  return i == 0 || j == 0 || i > side || j > side ? 0.0 : v[(j - 1) * side + i - 1];
}

// The integral of |grad v|^2 / 2 - c v over the unit square.
double membrane(const double* v, double* g, std::size_t side, double c) {
  const double h = 1 / static_cast<double>(side + 1);
  double f = 0;
  for (std::size_t j = 1; j <= side; ++j) {
    for (std::size_t i = 1; i <= side; ++i) {
      const double here = at(v, side, i, j);
      const double left = at(v, side, i - 1, j), right = at(v, side, i + 1, j);
      const double below = at(v, side, i, j - 1), above = at(v, side, i, j + 1);
      const double pull = 4 * here - left - right - below - above;
      f += 0.5 * here * pull - h * h * c * here;
      g[(j - 1) * side + i - 1] = pull - h * h * c;
    }
  }
  return f;
}

BoundProblem make_torsion(std::size_t side, double c, bool from_above) {
  BoundProblem p;
  p.name = "torsion c=" + std::to_string(static_cast<int>(c)) + (from_above ? " from above" : " from below");
  p.name += " n=" + std::to_string(side * side);
  const double h = 1 / static_cast<double>(side + 1);
  for (std::size_t j = 1; j <= side; ++j) {
    for (std::size_t i = 1; i <= side; ++i) {
      const double distance = h * static_cast<double>(std::min({i, j, side + 1 - i, side + 1 - j}));
      p.lower.push_back(-distance);
      p.upper.push_back(distance);
    }
  }
  p.start = from_above ? p.upper : p.lower;
  p.evaluate = [side, c](const double* v, double* g) { return membrane(v, g, side, c); };
  return p;
}

BoundProblem make_obstacle(std::size_t side, bool both, bool from_below) {
  BoundProblem p;
  p.name = std::string(both ? "obstacles B" : "obstacle A") + (from_below ? " from below" : " from above");
  p.name += " n=" + std::to_string(side * side);
  const double h = 1 / static_cast<double>(side + 1), speed_x = both ? 9.2 : 3.2, speed_y = both ? 9.3 : 3.3;
  for (std::size_t j = 1; j <= side; ++j) {
    for (std::size_t i = 1; i <= side; ++i) {
      const double wave =
          std::sin(speed_x * h * static_cast<double>(i)) * std::sin(speed_y * h * static_cast<double>(j));
      p.lower.push_back(wave * wave * wave);
      p.upper.push_back(both ? wave * wave + 0.02 : 2000.0);
    }
  }
  p.start = p.lower;
  if (!from_below) p.start = both ? p.upper : std::vector<double>(p.lower.size(), 1.0);
  for (std::size_t k = 0; k < p.start.size(); ++k)
    p.start[k] = std::clamp(p.start[k], p.lower[k], p.upper[k]);
  p.evaluate = [side](const double* v, double* g) { return membrane(v, g, side, 1); };
  return p;
}

// The pressure of a lubricant: the integral of (1 + e cos s)^3 |grad v|^2 / 2 - e sin(s) v over (0, 2 pi) x (0, 2 b).
double bearing(const double* v, double* g, std::size_t side, double e, double b) {
  const double hx = 2 * pi / static_cast<double>(side + 1), hy = 2 * b / static_cast<double>(side + 1);
  const auto weight = [&](double i) { return std::pow(1 + e * std::cos(i * hx), 3); };
  std::fill(g, g + side * side, 0.0);
  double f = 0;
  const auto add = [&](std::size_t i, std::size_t j, double slope) {
    if (i > 0 && j > 0 && i <= side && j <= side) g[(j - 1) * side + i - 1] += slope;
  };
  // Linear elements, two triangles a cell: gradients along its sides.
  for (std::size_t j = 0; j <= side; ++j) {
    for (std::size_t i = 0; i <= side; ++i) {
      const double low = weight(static_cast<double>(i)), high = weight(static_cast<double>(i) + 1);
      const double lower_weight = (2 * low + high) / 3, upper_weight = (low + 2 * high) / 3;
      const auto side_term = [&](std::size_t i0, std::size_t j0, std::size_t i1, std::size_t j1, double step,
                                 double w) {
        const double d = (at(v, side, i1, j1) - at(v, side, i0, j0)) / step;
        f += 0.25 * hx * hy * w * d * d;
        add(i1, j1, 0.5 * hx * hy * w * d / step);
        add(i0, j0, -0.5 * hx * hy * w * d / step);
      };
      side_term(i, j, i + 1, j, hx, lower_weight);
      side_term(i, j, i, j + 1, hy, lower_weight);
      side_term(i, j + 1, i + 1, j + 1, hx, upper_weight);
      side_term(i + 1, j, i + 1, j + 1, hy, upper_weight);
    }
  }
  for (std::size_t j = 1; j <= side; ++j) {
    for (std::size_t i = 1; i <= side; ++i) {
      const double load = hx * hy * e * std::sin(static_cast<double>(i) * hx);
      f -= load * at(v, side, i, j);
      add(i, j, -load);
    }
  }
  return f;
}

BoundProblem make_bearing(std::size_t side, double e, double b) {
  BoundProblem p;
  p.name = "bearing e=" + std::to_string(e).substr(0, 3) + " b=" + std::to_string(static_cast<int>(b)) +
           " n=" + std::to_string(side * side);
  for (std::size_t j = 1; j <= side; ++j) {
    for (std::size_t i = 1; i <= side; ++i)
      p.start.push_back(std::max(0.0, std::sin(2 * pi * static_cast<double>(i) / static_cast<double>(side + 1))));
  }
  p.lower.assign(side * side, 0.0);
  p.upper.assign(side * side, infinity);
  p.evaluate = [side, e, b](const double* v, double* g) { return bearing(v, g, side, e, b); };
  return p;
}

// The area of a surface over the unit square with zero boundary, above a plate of height 1 over its middle.
double area(const double* v, double* g, std::size_t side) {
  const double h = 1 / static_cast<double>(side + 1);
  std::fill(g, g + side * side, 0.0);
  double f = 0;
  const auto add = [&](std::size_t i, std::size_t j, double slope) {
    if (i > 0 && j > 0 && i <= side && j <= side) g[(j - 1) * side + i - 1] += slope;
  };
  for (std::size_t j = 0; j <= side; ++j) {
    for (std::size_t i = 0; i <= side; ++i) {
      const double a = at(v, side, i, j), b = at(v, side, i + 1, j), c = at(v, side, i, j + 1),
                   d = at(v, side, i + 1, j + 1);
      const double x0 = (b - a) / h, y0 = (c - a) / h, x1 = (d - c) / h, y1 = (d - b) / h;
      const double first = std::sqrt(1 + x0 * x0 + y0 * y0), second = std::sqrt(1 + x1 * x1 + y1 * y1);
      f += 0.5 * h * h * (first + second);
      add(i, j, -0.5 * h * (x0 + y0) / first);
      add(i + 1, j, 0.5 * h * (x0 / first - y1 / second));
      add(i, j + 1, 0.5 * h * (y0 / first - x1 / second));
      add(i + 1, j + 1, 0.5 * h * (x1 + y1) / second);
    }
  }
  return f;
}

BoundProblem make_minimal_surface(std::size_t side) {
  BoundProblem p;
  p.name = "minimal surface n=" + std::to_string(side * side);
  for (std::size_t j = 1; j <= side; ++j) {
    for (std::size_t i = 1; i <= side; ++i) {
      const bool middle = 4 * i >= side && 4 * i <= 3 * side && 4 * j >= side && 4 * j <= 3 * side;
      p.lower.push_back(middle ? 1.0 : 0.0);
    }
  }
  p.start = p.lower;
  p.upper.assign(side * side, infinity);
  p.evaluate = [side](const double* v, double* g) { return area(v, g, side); };
  return p;
}

// A clamped beam under a load over a flat obstacle: fourth differences, ill-conditioned.
BoundProblem make_beam(std::size_t n) {
  BoundProblem p;
  p.name = "beam over an obstacle n=" + std::to_string(n);
  p.start.assign(n, 0.0);
  p.lower.assign(n, -0.5);
  p.upper.assign(n, infinity);
  p.evaluate = [n](const double* x, double* g) {
    const auto value = [&](std::size_t i) { return i < 2 || i >= n + 2 ? 0.0 : x[i - 2]; };
    const double load = 2e3 / std::pow(static_cast<double>(n), 4);
    std::fill(g, g + n, load);
    double f = 0;
    for (std::size_t j = 0; j < n; ++j)
      f += load * x[j];
    for (std::size_t i = 1; i < n + 3; ++i) {
      const double bend = value(i - 1) - 2 * value(i) + value(i + 1);
      f += 0.5 * bend * bend;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t j = i - 1 + k;
        if (j >= 2 && j < n + 2) g[j - 2] += (k == 1 ? -2 : 1) * bend;
      }
    }
    return f;
  };
  return p;
}

}  // namespace

void add_obstacles(std::vector<BoundProblemMaker>& list) {
  list.push_back([] { return make_torsion(74, 5, false); });
  list.push_back([] { return make_torsion(74, 10, true); });
  list.push_back([] { return make_torsion(74, 20, false); });
  list.push_back([] { return make_obstacle(100, false, false); });
  list.push_back([] { return make_obstacle(100, false, true); });
  list.push_back([] { return make_obstacle(100, true, true); });
  list.push_back([] { return make_obstacle(100, true, false); });
  list.push_back([] { return make_bearing(50, 0.1, 10); });
  list.push_back([] { return make_bearing(50, 0.5, 10); });
  list.push_back([] { return make_bearing(50, 0.9, 1); });
  list.push_back([] { return make_minimal_surface(50); });
  list.push_back([] { return make_beam(40); });
}

}  // namespace orbicube::bench
