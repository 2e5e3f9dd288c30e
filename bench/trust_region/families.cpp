// The residuals of the 22 families and their standard starts, from the papers that More and Wild list: More, Garbow and
// Hillstrom 1981, "Testing unconstrained optimization software", and the CUTEr collection for the last four.
#include "families.h"

#include <array>
#include <cmath>
#include <numbers>

namespace orbicube::bench {
namespace {

constexpr std::array bard = {0.14, 0.18, 0.22, 0.25, 0.29, 0.32, 0.35, 0.39, 0.37, 0.58, 0.73, 0.96, 1.34, 2.10, 4.39};
constexpr std::array kowalik = {0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627, 0.0456, 0.0342, 0.0323, 0.0235, 0.0246};
constexpr std::array kowalik_at = {4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625};
constexpr std::array meyer = {34780., 28610., 23650., 19630., 16370., 13720., 11540., 9744.,
                              8261.,  7030.,  6005.,  5147.,  4427.,  3820.,  3307.,  2872.};
constexpr std::array osborne_1 = {0.844, 0.908, 0.932, 0.936, 0.925, 0.908, 0.881, 0.850, 0.818, 0.784, 0.751,
                                  0.718, 0.685, 0.658, 0.628, 0.603, 0.580, 0.558, 0.538, 0.522, 0.506, 0.490,
                                  0.478, 0.467, 0.457, 0.448, 0.438, 0.431, 0.424, 0.420, 0.414, 0.411, 0.406};
constexpr std::array osborne_2 = {1.366, 1.191, 1.112, 1.013, 0.991, 0.885, 0.831, 0.847, 0.786, 0.725, 0.746,
                                  0.679, 0.608, 0.655, 0.616, 0.606, 0.602, 0.626, 0.651, 0.724, 0.649, 0.649,
                                  0.694, 0.644, 0.624, 0.661, 0.612, 0.558, 0.533, 0.495, 0.500, 0.423, 0.395,
                                  0.375, 0.372, 0.391, 0.396, 0.405, 0.428, 0.429, 0.523, 0.562, 0.607, 0.653,
                                  0.672, 0.708, 0.633, 0.668, 0.645, 0.632, 0.591, 0.559, 0.597, 0.625, 0.739,
                                  0.710, 0.729, 0.720, 0.636, 0.581, 0.428, 0.292, 0.162, 0.098, 0.054};

double square(double a) {
  return a * a;
}

double number(std::size_t i) {
  return static_cast<double>(i);
}

void linear(int family, std::size_t n, std::size_t m, const double* x, double* r) {
  if (family == 1) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j)
      sum += x[j];
    for (std::size_t i = 0; i < m; ++i)
      r[i] = (i < n ? x[i] : 0.0) - (2 * sum / number(m) + 1);
    return;
  }
  // Rank one, with and without zero columns and rows.
  const bool zeros = family == 3;
  double sum = 0;
  for (std::size_t j = zeros ? 1 : 0; j + (zeros ? 1 : 0) < n; ++j)
    sum += number(j + 1) * x[j];
  for (std::size_t i = 0; i < m; ++i)
    r[i] = (zeros ? (i + 1 == m ? 0.0 : number(i)) : number(i + 1)) * sum - 1;
}

void helical_valley(const double* x, double* r) {
  double turn = 0.25;
  if (x[0] != 0) turn = std::atan(x[1] / x[0]) / (2 * std::numbers::pi) + (x[0] < 0 ? 0.5 : 0.0);
  r[0] = 10 * (x[2] - 10 * turn);
  r[1] = 10 * (std::sqrt(square(x[0]) + square(x[1])) - 1);
  r[2] = x[2];
}

void watson(std::size_t n, const double* x, double* r) {
  for (std::size_t i = 0; i < 29; ++i) {
    const double t = number(i + 1) / 29;
    double slope = 0, value = 0, power = 1;
    for (std::size_t j = 0; j < n; ++j) {
      value += power * x[j];
      if (j + 1 < n) slope += number(j + 1) * power * x[j + 1];
      power *= t;
    }
    r[i] = slope - square(value) - 1;
  }
  r[29] = x[0];
  r[30] = x[1] - square(x[0]) - 1;
}

void chebyquad(std::size_t n, std::size_t m, const double* x, double* r) {
  for (std::size_t i = 0; i < m; ++i)
    r[i] = 0;
  for (std::size_t j = 0; j < n; ++j) {
    double before = 1, now = 2 * x[j] - 1;
    const double twice = 2 * now;
    for (std::size_t i = 0; i < m; ++i) {
      r[i] += now;
      const double next = twice * now - before;
      before = now;
      now = next;
    }
  }
  for (std::size_t i = 0; i < m; ++i)
    r[i] = r[i] / number(n) + (i % 2 == 1 ? 1 / (square(number(i + 1)) - 1) : 0.0);
}

void osborne(int which, const double* x, double* r) {
  if (which == 1) {
    for (std::size_t i = 0; i < osborne_1.size(); ++i) {
      const double t = 10 * number(i);
      r[i] = osborne_1[i] - (x[0] + x[1] * std::exp(-x[3] * t) + x[2] * std::exp(-x[4] * t));
    }
    return;
  }
  for (std::size_t i = 0; i < osborne_2.size(); ++i) {
    const double t = number(i) / 10;
    double sum = x[0] * std::exp(-x[4] * t);
    for (std::size_t k = 0; k < 3; ++k)
      sum += x[k + 1] * std::exp(-x[k + 5] * square(t - x[k + 8]));
    r[i] = osborne_2[i] - sum;
  }
}

// sin^5 log v + cos^5 log v, times v.
double mancino_term(double v) {
  return v * (std::pow(std::sin(std::log(v)), 5) + std::pow(std::cos(std::log(v)), 5));
}

void heart(const double* x, double* r) {
  r[0] = x[0] + x[1] + 0.69;
  r[1] = x[2] + x[3] + 0.044;
  r[2] = x[4] * x[0] + x[5] * x[1] - x[6] * x[2] - x[7] * x[3] + 1.57;
  r[3] = x[6] * x[0] + x[7] * x[1] + x[4] * x[2] + x[5] * x[3] + 1.31;
  r[4] = 2.65;
  r[5] = -2.0;
  r[6] = 12.6;
  r[7] = -9.48;
  // Real and imaginary parts of (a + ib)(t + iv)^2 and ^3, for two pairs.
  for (std::size_t k = 0; k < 2; ++k) {
    const double a = x[k], b = x[k + 2], t = x[k + 4], v = x[k + 6];
    const double second = square(t) - square(v), cross = 2 * t * v;
    const double third = t * (square(t) - 3 * square(v)), fourth = v * (square(v) - 3 * square(t));
    r[4] += a * second - b * cross;
    r[5] += b * second + a * cross;
    r[6] += a * third + b * fourth;
    r[7] += b * third - a * fourth;
  }
}

}  // namespace

void family_residuals(int family, std::size_t n, std::size_t m, const double* x, double* r) {
  switch (family) {
    case 1:
    case 2:
    case 3:
      return linear(family, n, m, x, r);
    case 4:  // Rosenbrock
      r[0] = 10 * (x[1] - square(x[0]));
      r[1] = 1 - x[0];
      return;
    case 5:
      return helical_valley(x, r);
    case 6:  // Powell's singular function
      r[0] = x[0] + 10 * x[1];
      r[1] = std::sqrt(5.0) * (x[2] - x[3]);
      r[2] = square(x[1] - 2 * x[2]);
      r[3] = std::sqrt(10.0) * square(x[0] - x[3]);
      return;
    case 7:  // Freudenstein and Roth
      r[0] = -13 + x[0] + ((5 - x[1]) * x[1] - 2) * x[1];
      r[1] = -29 + x[0] + ((1 + x[1]) * x[1] - 14) * x[1];
      return;
    case 8:
      for (std::size_t i = 0; i < bard.size(); ++i) {
        const double u = number(i + 1), v = 16 - u, w = u < v ? u : v;
        r[i] = bard[i] - (x[0] + u / (x[1] * v + x[2] * w));
      }
      return;
    case 9:
      for (std::size_t i = 0; i < kowalik.size(); ++i) {
        const double t = kowalik_at[i];
        r[i] = kowalik[i] - x[0] * (t * (t + x[1])) / (t * (t + x[2]) + x[3]);
      }
      return;
    case 10:
      for (std::size_t i = 0; i < meyer.size(); ++i)
        r[i] = x[0] * std::exp(x[1] / (5 * number(i + 1) + 45 + x[2])) - meyer[i];
      return;
    case 11:
      return watson(n, x, r);
    case 12:  // Box, three-dimensional
      for (std::size_t i = 0; i < m; ++i) {
        const double whole = number(i + 1), t = whole / 10;
        r[i] = std::exp(-t * x[0]) - std::exp(-t * x[1]) + (std::exp(-whole) - std::exp(-t)) * x[2];
      }
      return;
    case 13:  // Jennrich and Sampson
      for (std::size_t i = 0; i < m; ++i) {
        const double t = number(i + 1);
        r[i] = 2 + 2 * t - std::exp(t * x[0]) - std::exp(t * x[1]);
      }
      return;
    case 14:  // Brown and Dennis
      for (std::size_t i = 0; i < m; ++i) {
        const double t = number(i + 1) / 5;
        r[i] = square(x[0] + t * x[1] - std::exp(t)) + square(x[2] + std::sin(t) * x[3] - std::cos(t));
      }
      return;
    case 15:
      return chebyquad(n, m, x, r);
    case 16: {  // Brown's almost linear function
      double sum = -number(n + 1), product = 1;
      for (std::size_t j = 0; j < n; ++j) {
        sum += x[j];
        product *= x[j];
      }
      for (std::size_t i = 0; i + 1 < n; ++i)
        r[i] = x[i] + sum;
      r[n - 1] = product - 1;
      return;
    }
    case 17:
      return osborne(1, x, r);
    case 18:
      return osborne(2, x, r);
    case 19:  // Bdqrtic
      for (std::size_t i = 0; i + 4 < n; ++i) {
        r[i] = 3 - 4 * x[i];
        r[n - 4 + i] =
            square(x[i]) + 2 * square(x[i + 1]) + 3 * square(x[i + 2]) + 4 * square(x[i + 3]) + 5 * square(x[n - 1]);
      }
      return;
    case 20:  // Cube
      r[0] = x[0] - 1;
      for (std::size_t i = 1; i < n; ++i)
        r[i] = 10 * (x[i] - x[i - 1] * x[i - 1] * x[i - 1]);
      return;
    case 21:  // Mancino
      for (std::size_t i = 0; i < n; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < n; ++j)
          sum += mancino_term(std::sqrt(square(x[i]) + number(i + 1) / number(j + 1)));
        r[i] = 1400 * x[i] + std::pow(number(i) - 49, 3) + sum;
      }
      return;
    case 22:
      return heart(x, r);
    default:
      return;
  }
}

std::vector<double> family_start(int family, std::size_t n) {
  switch (family) {
    case 4:
      return {-1.2, 1};
    case 5:
      return {-1, 0, 0};
    case 6:
      return {3, -1, 0, 1};
    case 7:
      return {0.5, -2};
    case 9:
      return {0.25, 0.39, 0.415, 0.39};
    case 10:
      return {0.02, 4000, 250};
    case 12:
      return {0, 10, 20};
    case 13:
      return {0.3, 0.4};
    case 14:
      return {25, 5, -5, -1};
    case 17:
      return {0.5, 1.5, 1, 0.01, 0.02};
    case 18:
      return {1.3, 0.65, 0.65, 0.7, 0.6, 3, 5, 7, 2, 4.5, 5.5};
    case 22:
      return {-0.3, -0.39, 0.3, -0.344, -1.2, 2.69, 1.59, -1.5};
    default:
      break;
  }
  std::vector<double> x(n, family == 11 || family == 16 || family == 20 ? 0.5 : 1.0);
  for (std::size_t i = 0; i < n; ++i) {
    if (family == 15) x[i] = number(i + 1) / number(n + 1);
    if (family == 21) {
      double sum = 0;
      for (std::size_t j = 0; j < n; ++j)
        sum += mancino_term(std::sqrt(number(i + 1) / number(j + 1)));
      x[i] = -8.710996e-4 * (std::pow(number(i) - 49, 3) + sum);
    }
  }
  return x;
}

}  // namespace orbicube::bench
