// Sums of squares without bounds.
#include <array>
#include <cmath>

#include "suite.h"

namespace orbicube::bench {
namespace {

constexpr double pi = 3.14159265358979323846;
using Size = std::size_t;

double number(Size i) {
  return static_cast<double>(i);
}

void powell_badly_scaled(Size, const double* x, double* r) {
  r[0] = 1e4 * x[0] * x[1] - 1;
  r[1] = std::exp(-x[0]) + std::exp(-x[1]) - 1.0001;
}
void brown_badly_scaled(Size, const double* x, double* r) {
  r[0] = x[0] - 1e6;
  r[1] = x[1] - 2e-6;
  r[2] = x[0] * x[1] - 2;
}
void beale(Size, const double* x, double* r) {
  constexpr std::array<double, 3> y = {1.5, 2.25, 2.625};
  for (Size i = 0; i < 3; ++i)
    r[i] = y[i] - x[0] * (1 - std::pow(x[1], number(i + 1)));
}
void gaussian(Size, const double* x, double* r) {
  constexpr std::array<double, 15> y = {.0009, .0044, .0175, .054, .1295, .242,  .3521, .3989,
                                        .3521, .242,  .1295, .054, .0175, .0044, .0009};
  for (Size i = 0; i < 15; ++i) {
    const double t = (7 - number(i)) / 2;
    r[i] = x[0] * std::exp(-x[1] * (t - x[2]) * (t - x[2]) / 2) - y[i];
  }
}
void gulf(Size, const double* x, double* r) {
  for (Size i = 0; i < 10; ++i) {
    const double t = number(i + 1) / 100, y = 25 + std::pow(-50 * std::log(t), 2.0 / 3);
    r[i] = std::exp(-std::pow(std::abs(y - x[1]), x[2]) / x[0]) - t;
  }
}
void wood(Size n, const double* x, double* r) {
  for (Size i = 0; i + 3 < n; i += 4, x += 4, r += 6) {
    r[0] = 10 * (x[1] - x[0] * x[0]);
    r[1] = 1 - x[0];
    r[2] = std::sqrt(90.0) * (x[3] - x[2] * x[2]);
    r[3] = 1 - x[2];
    r[4] = std::sqrt(10.0) * (x[1] + x[3] - 2);
    r[5] = (x[1] - x[3]) / std::sqrt(10.0);
  }
}
void biggs(Size, const double* x, double* r) {
  for (Size i = 0; i < 13; ++i) {
    const double t = number(i + 1) / 10, y = std::exp(-t) - 5 * std::exp(-10 * t) + 3 * std::exp(-4 * t);
    r[i] = x[2] * std::exp(-t * x[0]) - x[3] * std::exp(-t * x[1]) + x[5] * std::exp(-t * x[4]) - y;
  }
}
void penalty_one(Size n, const double* x, double* r) {
  r[n] = -0.25;
  for (Size i = 0; i < n; ++i) {
    r[i] = std::sqrt(1e-5) * (x[i] - 1);
    r[n] += x[i] * x[i];
  }
}
void penalty_two(Size n, const double* x, double* r) {
  const double a = std::sqrt(1e-5);
  r[0] = x[0] - 0.2;
  r[2 * n - 1] = -1;
  for (Size i = 0; i < n; ++i) {
    r[2 * n - 1] += number(n - i) * x[i] * x[i];
    if (i == 0) continue;
    const double y = std::exp(number(i + 1) / 10) + std::exp(number(i) / 10);
    r[i] = a * (std::exp(x[i] / 10) + std::exp(x[i - 1] / 10) - y);
    r[n + i - 1] = a * (std::exp(x[i] / 10) - std::exp(-0.1));
  }
}
void variably_dimensioned(Size n, const double* x, double* r) {
  double sum = 0;
  for (Size i = 0; i < n; ++i) {
    r[i] = x[i] - 1;
    sum += number(i + 1) * r[i];
  }
  r[n] = sum;
  r[n + 1] = sum * sum;
}
void trigonometric(Size n, const double* x, double* r) {
  double sum = 0;
  for (Size i = 0; i < n; ++i)
    sum += std::cos(x[i]);
  for (Size i = 0; i < n; ++i)
    r[i] = number(n) - sum + number(i + 1) * (1 - std::cos(x[i])) - std::sin(x[i]);
}
void boundary_value(Size n, const double* x, double* r) {
  const double h = 1 / number(n + 1);
  for (Size i = 0; i < n; ++i) {
    const double t = number(i + 1) * h, before = i > 0 ? x[i - 1] : 0, after = i + 1 < n ? x[i + 1] : 0;
    r[i] = 2 * x[i] - before - after + h * h * std::pow(x[i] + t + 1, 3) / 2;
  }
}
void integral_equation(Size n, const double* x, double* r) {
  const double h = 1 / number(n + 1);
  for (Size i = 0; i < n; ++i) {
    const double t = number(i + 1) * h;
    double sum = 0;
    for (Size j = 0; j < n; ++j) {
      const double s = number(j + 1) * h, cube = std::pow(x[j] + s + 1, 3);
      sum += j <= i ? (1 - t) * s * cube : t * (1 - s) * cube;
    }
    r[i] = x[i] + h * sum / 2;
  }
}
void broyden_tridiagonal(Size n, const double* x, double* r) {
  for (Size i = 0; i < n; ++i)
    r[i] = (3 - 2 * x[i]) * x[i] - (i > 0 ? x[i - 1] : 0) - (i + 1 < n ? 2 * x[i + 1] : 0) + 1;
}
void broyden_banded(Size n, const double* x, double* r) {
  for (Size i = 0; i < n; ++i) {
    r[i] = x[i] * (2 + 5 * x[i] * x[i]) + 1;
    for (Size j = i < 5 ? 0 : i - 5; j < n && j <= i + 1; ++j) {
      if (j != i) r[i] -= x[j] * (1 + x[j]);
    }
  }
}
void extended_rosenbrock(Size n, const double* x, double* r) {
  for (Size i = 0; i + 1 < n; i += 2) {
    r[i] = 10 * (x[i + 1] - x[i] * x[i]);
    r[i + 1] = 1 - x[i];
  }
}
void extended_powell(Size n, const double* x, double* r) {
  for (Size i = 0; i + 3 < n; i += 4) {
    r[i] = x[i] + 10 * x[i + 1];
    r[i + 1] = std::sqrt(5.0) * (x[i + 2] - x[i + 3]);
    r[i + 2] = (x[i + 1] - 2 * x[i + 2]) * (x[i + 1] - 2 * x[i + 2]);
    r[i + 3] = std::sqrt(10.0) * (x[i] - x[i + 3]) * (x[i] - x[i + 3]);
  }
}
void chained_rosenbrock(Size n, const double* x, double* r) {
  for (Size i = 0; i + 1 < n; ++i) {
    r[2 * i] = 10 * (x[i + 1] - x[i] * x[i]);
    r[2 * i + 1] = 1 - x[i];
  }
}
void chained_wood(Size n, const double* x, double* r) {
  for (Size i = 0; i + 3 < n; i += 2, x += 2, r += 6)
    wood(4, x, r);
}
void denschnb(Size, const double* x, double* r) {
  r[0] = x[0] - 2;
  r[1] = r[0] * x[1];
  r[2] = x[1] + 1;
}
void denschnc(Size, const double* x, double* r) {
  r[0] = x[0] * x[0] + x[1] * x[1] - 2;
  r[1] = std::exp(x[0] - 1) + x[1] * x[1] * x[1] - 2;
}
void denschnd(Size, const double* x, double* r) {
  r[0] = x[0] * x[0] + x[1] * x[1] * x[1] - std::pow(x[2], 4);
  r[1] = 2 * x[0] * x[1] * x[2];
  r[2] = 2 * x[0] * x[1] - 3 * x[1] * x[2] + x[0] * x[2];
}
void denschne(Size, const double* x, double* r) {
  r[0] = x[0];
  r[1] = x[1] + x[1] * x[1];
  r[2] = std::exp(x[2]) - 1;
}
void denschnf(Size, const double* x, double* r) {
  const double s = x[0] + x[1], d = x[0] - x[1], e = x[0] - 3;
  r[0] = 2 * s * s + d * d - 8;
  r[1] = 5 * x[0] * x[0] + e * e - 9;
}
void engval_two(Size, const double* x, double* r) {
  const double s = x[0] * x[0] + x[1] * x[1];
  r[0] = s + x[2] * x[2] - 1;
  r[1] = s + (x[2] - 2) * (x[2] - 2) - 1;
  r[2] = x[0] + x[1] + x[2] - 1;
  r[3] = x[0] + x[1] - x[2] + 1;
  r[4] = x[0] * x[0] * x[0] + 3 * x[1] * x[1] + (5 * x[2] - x[0] + 1) * (5 * x[2] - x[0] + 1) - 36;
}
void himmelblau(Size, const double* x, double* r) {
  r[0] = x[0] * x[0] + x[1] - 11;
  r[1] = x[0] + x[1] * x[1] - 7;
}
void expfit(Size, const double* x, double* r) {
  for (Size i = 0; i < 10; ++i) {
    const double t = 0.25 * number(i + 1);
    r[i] = x[0] * std::exp(x[1] * t) - t;
  }
}
void sine_valley(Size, const double* x, double* r) {
  r[0] = 10 * (x[1] - std::sin(x[0]));
  r[1] = 0.5 * x[0];
}
void toint_trigonometric(Size n, const double* x, double* r) {
  // Luksan and Vlcek's problem of Toint: coupled sines of a band.
  for (Size i = 0; i < n; ++i) {
    const double before = i > 0 ? x[i - 1] : 0, after = i + 1 < n ? x[i + 1] : 0;
    r[i] = 0.5 * number(i + 1) * (1 - std::cos(x[i])) + std::sin(before) - std::sin(after);
  }
}
void logistic(Size, const double* x, double* r) {
  constexpr std::array<double, 12> y = {5.308,  7.24,   9.638,  12.866, 17.069, 23.192,
                                        31.443, 38.558, 50.156, 62.948, 75.995, 91.972};
  for (Size i = 0; i < 12; ++i)
    r[i] = 100 * x[0] / (1 + 10 * x[1] * std::exp(-0.1 * x[2] * number(i + 1))) - y[i];
}
void hilbert(Size n, const double* x, double* r) {
  for (Size i = 0; i < n; ++i) {
    r[i] = 0;
    for (Size j = 0; j < n; ++j)
      r[i] += (x[j] - 1) / number(i + j + 1);
  }
}
void circles(Size n, const double* x, double* r) {
  // Positions in the plane from their distances to eight anchors and to each other.
  Size k = 0;
  for (Size i = 0; i + 1 < n; i += 2) {
    const double a = 0.7 * number(i + 1), px = std::cos(a) + 0.2 * number(i), py = std::sin(2 * a);
    for (Size j = 0; j < 3; ++j) {
      const double b = 2 * pi * number(j) / 3, ax = 4 * std::cos(b), ay = 4 * std::sin(b);
      r[k++] = std::hypot(x[i] - ax, x[i + 1] - ay) - std::hypot(px - ax, py - ay);
    }
  }
}

}  // namespace

std::vector<SuiteRow> suite_squares() {
  return {
      {"Powell badly scaled", 2, 2, {0, 1}, {}, {}, 0, powell_badly_scaled},
      {"Brown badly scaled", 2, 3, {1}, {}, {}, 0, brown_badly_scaled},
      {"Beale", 2, 3, {1}, {}, {}, 0, beale},
      {"Gaussian", 3, 15, {0.4, 1, 0}, {}, {}, 0, gaussian},
      {"Gulf", 3, 10, {5, 2.5, 0.15}, {}, {}, 0, gulf},
      {"Wood", 4, 6, {-3, -1}, {}, {}, 0, wood},
      {"Biggs EXP6", 6, 13, {1, 2, 1, 1, 1, 1}, {}, {}, 0, biggs},
      {"penalty I", 10, 11, {1}, {}, {}, 1, penalty_one},
      {"penalty II", 4, 8, {0.5}, {}, {}, 0, penalty_two},
      {"variably dimensioned", 10, 12, {0.9}, {}, {}, -0.1, variably_dimensioned},
      {"trigonometric", 10, 10, {0.1}, {}, {}, 0, trigonometric},
      {"boundary value", 8, 8, {-0.1}, {}, {}, 0, boundary_value},
      {"integral equation", 8, 8, {-0.1}, {}, {}, 0, integral_equation},
      {"Broyden tridiagonal", 10, 10, {-1}, {}, {}, 0, broyden_tridiagonal},
      {"Broyden banded", 10, 10, {-1}, {}, {}, 0, broyden_banded},
      {"extended Rosenbrock", 10, 10, {-1.2, 1}, {}, {}, 0, extended_rosenbrock},
      {"extended Powell", 8, 8, {3, -1, 0, 1}, {}, {}, 0, extended_powell},
      {"chained Rosenbrock", 6, 10, {-1.2, 1}, {}, {}, 0, chained_rosenbrock},
      {"chained Wood", 8, 18, {-3, -1}, {}, {}, 0, chained_wood},
      {"DENSCHNB", 2, 3, {1}, {}, {}, 0, denschnb},
      {"DENSCHNC", 2, 2, {2, 3}, {}, {}, 0, denschnc},
      {"DENSCHND", 3, 3, {10}, {}, {}, 0, denschnd},
      {"DENSCHNE", 3, 3, {2, 3, -8}, {}, {}, 0, denschne},
      {"DENSCHNF", 2, 2, {2, 0}, {}, {}, 0, denschnf},
      {"ENGVAL2", 3, 5, {1, 2, 0}, {}, {}, 0, engval_two},
      {"Himmelblau", 2, 2, {1}, {}, {}, 0, himmelblau},
      {"EXPFIT", 2, 10, {0}, {}, {}, 0, expfit},
      {"sine valley", 2, 2, {4.7, -1}, {}, {}, 0, sine_valley},
      {"coupled sines", 8, 8, {1}, {}, {}, 0, toint_trigonometric},
      {"weeds", 3, 12, {1}, {}, {}, 0, logistic},
      {"Hilbert", 5, 5, {-3}, {}, {}, 0, hilbert},
      {"distances", 6, 9, {0.5, -0.5}, {}, {}, 0, circles},
  };
}

}  // namespace orbicube::bench
