// Problems with bounds.
#include <array>
#include <cmath>

#include "suite.h"

namespace orbicube::bench {
namespace {

constexpr double pi = 3.14159265358979323846, infinity = 1e20;
using Size = std::size_t;

double number(Size i) {
  return static_cast<double>(i);
}
double square(double x) {
  return x * x;
}

void rosenbrock(Size, const double* x, double* r) {
  r[0] = 10 * (x[1] - x[0] * x[0]);
  r[1] = 1 - x[0];
}
void hs3(Size, const double* x, double* f) {
  *f = x[1] + 1e-5 * square(x[1] - x[0]);
}
void hs4(Size, const double* x, double* f) {
  *f = std::pow(x[0] + 1, 3) / 3 + x[1];
}
void hs5(Size, const double* x, double* f) {
  *f = std::sin(x[0] + x[1]) + square(x[0] - x[1]) - 1.5 * x[0] + 2.5 * x[1] + 1;
}
void hs25(Size, const double* x, double* r) {
  for (Size i = 0; i < 99; ++i) {
    const double t = number(i + 1) / 100, u = 25 + std::pow(-50 * std::log(t), 2.0 / 3);
    r[i] = std::exp(-std::pow(std::abs(u - x[1]), x[2]) / x[0]) - t;
  }
}
void hs38(Size, const double* x, double* f) {
  *f = 100 * square(x[1] - square(x[0])) + square(1 - x[0]) + 90 * square(x[3] - square(x[2])) + square(1 - x[2]) +
       10.1 * (square(x[1] - 1) + square(x[3] - 1)) + 19.8 * (x[1] - 1) * (x[3] - 1);
}
void hs45(Size, const double* x, double* f) {
  *f = 2 - x[0] * x[1] * x[2] * x[3] * x[4] / 120;
}
void hs110(Size n, const double* x, double* f) {
  double product = 1;
  *f = 0;
  for (Size i = 0; i < n; ++i) {
    *f += square(std::log(x[i] - 2)) + square(std::log(10 - x[i]));
    product *= x[i];
  }
  *f -= std::pow(product, 0.2);
}
void hatflda(Size n, const double* x, double* r) {
  r[0] = x[0] - 1;
  for (Size i = 1; i < n; ++i)
    r[i] = x[i - 1] - std::sqrt(x[i]);
}
void hatfldc(Size n, const double* x, double* r) {
  r[0] = x[0] - 1;
  r[n - 1] = x[n - 1] - 1;
  for (Size i = 1; i + 1 < n; ++i)
    r[i] = x[i + 1] - square(x[i]);
}
void eg1(Size, const double* x, double* f) {
  *f = square(x[0]) + square(x[1] * x[2]) * square(x[1] * x[2]) + x[0] * x[2] + x[1] * std::sin(x[0] + x[2]) + x[1];
}
void logros(Size, const double* x, double* f) {
  *f = std::log(1 + 10000 * square(x[1] - square(x[0])) + square(1 - x[0]));
}
void camel(Size, const double* x, double* f) {
  const double a = square(x[0]), b = square(x[1]);
  *f = 4 * a - 2.1 * a * a + a * a * a / 3 + x[0] * x[1] - 4 * b + 4 * b * b;
}
void mdhole(Size, const double* x, double* f) {
  *f = 100 * square(std::sin(x[0]) - x[1]) + x[0];
}
void pspdoc(Size, const double* x, double* f) {
  *f = std::sqrt(1 + square(x[0]) + square(x[1] - x[2])) + std::sqrt(1 + square(x[1]) + square(x[2] - x[3]));
}
void hart(Size, const double* x, double* f) {
  constexpr std::array<double, 4> c = {1, 1.2, 3, 3.2};
  constexpr std::array<std::array<double, 6>, 4> a = {
      {{10, 3, 17, 3.5, 1.7, 8}, {0.05, 10, 17, 0.1, 8, 14}, {3, 3.5, 1.7, 10, 17, 8}, {17, 8, 0.05, 10, 0.1, 14}}};
  constexpr std::array<std::array<double, 6>, 4> p = {{{0.1312, 0.1696, 0.5569, 0.0124, 0.8283, 0.5886},
                                                       {0.2329, 0.4135, 0.8307, 0.3736, 0.1004, 0.9991},
                                                       {0.2348, 0.1451, 0.3522, 0.2883, 0.3047, 0.6650},
                                                       {0.4047, 0.8828, 0.8732, 0.5743, 0.1091, 0.0381}}};
  *f = 0;
  for (Size i = 0; i < 4; ++i) {
    double sum = 0;
    for (Size j = 0; j < 6; ++j)
      sum += a[i][j] * square(x[j] - p[i][j]);
    *f -= c[i] * std::exp(-sum);
  }
}
void s368(Size n, const double* x, double* f) {
  double two = 0, three = 0, four = 0;
  for (Size i = 0; i < n; ++i) {
    two += square(x[i]);
    three += x[i] * square(x[i]);
    four += square(square(x[i]));
  }
  *f = square(three) - two * four;
}
void mccormick(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i + 1 < n; ++i)
    *f += -1.5 * x[i] + 2.5 * x[i + 1] + 1 + square(x[i] - x[i + 1]) + std::sin(x[i] + x[i + 1]);
}
// A membrane on a square grid with a load of both signs, each node kept near the border by a wedge or an obstacle.
void membrane(Size n, const double* x, double* f) {
  const Size side = static_cast<Size>(std::lround(std::sqrt(number(n))));
  const double h = 1 / number(side + 1);
  const auto at = [&](Size i, Size j) {
    return i < 1 || j < 1 || i > side || j > side ? 0 : x[(i - 1) * side + j - 1];
  };
  *f = 0;
  for (Size i = 0; i <= side; ++i) {
    for (Size j = 0; j <= side; ++j) {
      *f += (square(at(i + 1, j) - at(i, j)) + square(at(i, j + 1) - at(i, j))) / 2;
      *f -= h * h * 20 * std::sin(pi * number(i) * h * 2) * at(i, j);
    }
  }
}
void bdexp(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i + 2 < n; ++i)
    *f += (x[i] + x[i + 1]) * std::exp(-x[i + 2] * (x[i] + x[i + 1]));
}
void quadratic(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i < n; ++i)
    *f += number(i + 1) * square(x[i] + x[(2 * i) % n] + x[(3 * i) % n]) / 2;
}
void indefinite_quadratic(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i < n; ++i)
    *f += (4 * i < 3 * n ? 1 : -1) * number(i + 1) * square(x[i] + x[(2 * i) % n] + x[(3 * i) % n]) / 2;
}
void chained_rosenbrock(Size n, const double* x, double* r) {
  for (Size i = 0; i + 1 < n; ++i) {
    r[2 * i] = 10 * (x[i + 1] - x[i] * x[i]);
    r[2 * i + 1] = 1 - x[i];
  }
}
void broyden_tridiagonal(Size n, const double* x, double* r) {
  for (Size i = 0; i < n; ++i)
    r[i] = (3 - 2 * x[i]) * x[i] - (i > 0 ? x[i - 1] : 0) - (i + 1 < n ? 2 * x[i + 1] : 0) + 1;
}
void exponentials(Size, const double* x, double* r) {
  for (Size i = 0; i < 20; ++i) {
    const double t = 0.1 * number(i), y = 2 * std::exp(-t) + 3 * std::exp(-4 * t) + 0.05 * std::sin(9 * t);
    r[i] = x[0] * std::exp(-x[1] * t) + x[2] * std::exp(-x[3] * t) - y;
  }
}
void linear_program(Size n, const double* x, double* f) {
  double sum = -1;
  *f = 0;
  for (Size i = 0; i < n; ++i) {
    *f += std::sin(number(i + 1)) * x[i];
    sum += x[i];
  }
  *f += 10 * square(sum);
}

}  // namespace

std::vector<SuiteRow> suite_bounded() {
  return {
      {"HS1", 2, 2, {-2, 1}, {-infinity, -1.5}, {infinity}, 0, rosenbrock},
      {"HS2", 2, 2, {-2, 1.5}, {-infinity, 1.5}, {infinity}, 0, rosenbrock},
      {"HS3", 2, 0, {10, 1}, {-infinity, 0}, {infinity}, 0, hs3},
      {"HS4", 2, 0, {1.125, 0.125}, {1, 0}, {infinity}, 0, hs4},
      {"HS5", 2, 0, {0}, {-1.5, -3}, {4, 3}, 0, hs5},
      {"HS25", 3, 99, {60, 12.5, 3}, {0.1, 0, 0}, {100, 25.6, 5}, 0, hs25},
      {"HS38", 4, 0, {-3, -1}, {-10}, {10}, 0, hs38},
      {"HS45", 5, 0, {0.5}, {0}, {1, 2, 3, 4, 5}, 0, hs45},
      {"HS110", 10, 0, {9}, {2.001}, {9.999}, 0, hs110},
      {"HATFLDA", 4, 4, {0.1}, {1e-7}, {infinity}, 0, hatflda},
      {"HATFLDB", 4, 4, {0.1}, {1e-7}, {infinity, 0.8, infinity, infinity}, 0, hatflda},
      {"HATFLDC", 8, 8, {0.9}, {0}, {10}, 0, hatfldc},
      {"EG1", 3, 0, {0}, {-infinity, -1, 1}, {infinity, 1, 2}, 0, eg1},
      {"LOGROS", 2, 0, {-1.2, 1}, {0}, {infinity}, 0, logros},
      {"CAMEL6", 2, 0, {1.1}, {-3, -1.5}, {3, 1.5}, 0, camel},
      {"MDHOLE", 2, 0, {10, 1}, {0, -infinity}, {infinity}, 0, mdhole},
      {"PSPDOC", 4, 0, {3}, {-infinity}, {-1, infinity, infinity, infinity}, 0, pspdoc},
      {"HART6", 6, 0, {0.2}, {0}, {1}, 0, hart},
      {"S368", 8, 0, {0.15}, {0}, {1}, 0.1, s368},
      {"MCCORMCK", 10, 0, {0}, {-1.5}, {3}, 0, mccormick},
      {"torsion", 9, 0, {0}, {-0.25, -0.25, -0.25, -0.25, -0.5}, {0.25, 0.25, 0.25, 0.25, 0.5}, 0, membrane},
      {"obstacle", 9, 0, {0.2}, {0.1, 0, 0.05}, {0.3}, 0, membrane},
      {"BDEXP", 10, 0, {1}, {0}, {10}, 0, bdexp},
      {"CVXBQP1", 10, 0, {0.5}, {0.1}, {10}, 0, quadratic},
      {"NCVXBQP1", 10, 0, {0.5}, {0.1}, {10}, 0, indefinite_quadratic},
      {"Rosenbrock chain in a box", 8, 14, {-1.2, 1}, {-2}, {0.8, 1.5}, 0, chained_rosenbrock},
      {"Broyden in a box", 10, 10, {-0.4}, {-0.5}, {0, 0.5}, 0, broyden_tridiagonal},
      {"exponentials in a box", 4, 20, {1, 2, 1, 2}, {0}, {2.5, 3, 2.5, 3.5}, 0, exponentials},
      {"simplex penalty", 12, 0, {0.08}, {0}, {1}, 0, linear_program},
  };
}

}  // namespace orbicube::bench
