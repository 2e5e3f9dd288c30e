// Scalar f without bounds.
#include <algorithm>
#include <array>
#include <cmath>

#include "suite.h"

namespace orbicube::bench {
namespace {

using Size = std::size_t;

double number(Size i) {
  return static_cast<double>(i);
}
double square(double x) {
  return x * x;
}

void arwhead(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i + 1 < n; ++i)
    *f += square(square(x[i]) + square(x[n - 1])) - 4 * x[i] + 3;
}
void engval_one(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i + 1 < n; ++i)
    *f += square(square(x[i]) + square(x[i + 1])) - 4 * x[i] + 3;
}
// Dixon and Maany's family with the weights and powers of its members A and I.
double dixon_maany(Size n, const double* x, double alpha, double beta, double gamma, double delta, double power) {
  const Size m = n / 3;
  double f = 1;
  for (Size i = 0; i < n; ++i) {
    const double weight = std::pow(number(i + 1) / number(n), power);
    f += alpha * square(x[i]) * weight;
    if (i + 1 < n) f += beta * square(x[i] * (x[i + 1] + square(x[i + 1])));
    if (i < 2 * m) f += gamma * square(x[i]) * std::pow(x[i + m], 4);
    if (i < m) f += delta * x[i] * x[i + 2 * m] * weight;
  }
  return f;
}
void dixmaana(Size n, const double* x, double* f) {
  *f = dixon_maany(n, x, 1, 0, 0.125, 0.125, 0);
}
void dixmaani(Size n, const double* x, double* f) {
  *f = dixon_maany(n, x, 1, 0, 0.125, 0.125, 2);
}
void edensch(Size n, const double* x, double* f) {
  *f = 16;
  for (Size i = 0; i + 1 < n; ++i)
    *f += std::pow(x[i] - 2, 4) + square(x[i] * x[i + 1] - 2 * x[i + 1]) + square(x[i + 1] + 1);
}
void liarwhd(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i < n; ++i)
    *f += 4 * square(square(x[i]) - x[0]) + square(x[i] - 1);
}
void nondia(Size n, const double* x, double* f) {
  *f = square(x[0] - 1);
  for (Size i = 1; i < n; ++i)
    *f += 100 * square(x[0] - square(x[i - 1]));
}
void tridia(Size n, const double* x, double* f) {
  *f = square(x[0] - 1);
  for (Size i = 1; i < n; ++i)
    *f += number(i + 1) * square(2 * x[i] - x[i - 1]);
}
void dqrtic(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i < n; ++i)
    *f += std::pow(x[i] - number(i + 1), 4);
}
void power(Size n, const double* x, double* f) {
  double sum = 0;
  for (Size i = 0; i < n; ++i)
    sum += number(i + 1) * square(x[i]);
  *f = square(sum);
}
void cragg_levy(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i + 3 < n; i += 2) {
    const double t = x[i + 2] - x[i + 3];
    *f += std::pow(std::exp(x[i]) - x[i + 1], 4) + 100 * std::pow(x[i + 1] - x[i + 2], 6) +
          std::pow(std::tan(t) + t, 4) + std::pow(x[i], 8) + square(x[i + 3] - 1);
  }
}
void fletchcr(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i + 1 < n; ++i)
    *f += 100 * square(x[i + 1] - x[i] + 1 - square(x[i]));
}
void nonconvex(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i < n; ++i) {
    const double s = x[i] + x[(3 * i + 1) % n] + x[(7 * i + 2) % n];
    *f += square(s) + 4 * std::cos(s);
  }
}
void cosine(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i + 1 < n; ++i)
    *f += std::cos(square(x[i]) - 0.5 * x[i + 1]);
}
void schmvett(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i + 2 < n; ++i) {
    *f -= 1 / (1 + square(x[i] - x[i + 1])) + std::sin((3.14159265358979 * x[i + 1] + x[i + 2]) / 2) +
          std::exp(-square((x[i] + x[i + 2]) / x[i + 1] - 2));
  }
}
void tquartic(Size n, const double* x, double* f) {
  *f = square(x[0] - 1);
  for (Size i = 1; i < n; ++i)
    *f += square(square(x[0]) - square(x[i]));
}
void dixon(Size n, const double* x, double* f) {
  *f = square(x[0] - 1) + square(x[n - 1] - 1);
  for (Size i = 0; i + 1 < n; ++i)
    *f += square(x[i] - x[i + 1]);
}
void allinitu(Size, const double* x, double* f) {
  *f = x[2] - 1 + square(x[0]) + square(x[1]) + square(x[2] + x[3]) + square(std::sin(x[2])) + square(x[0] * x[1]) +
       square(std::sin(x[3])) + square(std::sin(x[0] - 1));
  *f += square(x[3] - 1) + std::pow(x[1] - x[3] + 1, 4);
}
void brkmcc(Size, const double* x, double* f) {
  *f = square(x[0] - 2) + square(x[1] - 1) + 0.04 / (1 + 0.25 * square(x[0]) + square(x[1])) +
       5 * square(x[0] - 2 * x[1] + 1);
}
void cliff(Size, const double* x, double* f) {
  *f = square((x[0] - 3) / 100) - (x[0] - x[1]) + std::exp(std::min(20 * (x[0] - x[1]), 300.0));
}
void sisser(Size, const double* x, double* f) {
  *f = 3 * std::pow(x[0], 4) - 2 * square(x[0] * x[1]) + 3 * std::pow(x[1], 4);
}
void hairy(Size, const double* x, double* f) {
  const double d = x[0] - x[1];
  *f = 30 * square(std::sin(7 * x[0])) * square(std::cos(7 * x[1])) + 100 * std::sqrt(0.01 + square(d)) +
       100 * std::sqrt(0.01 + square(x[0]));
}
void mexican_hat(Size, const double* x, double* f) {
  const double a = square(x[0] - 1), b = x[1] - square(x[0]), ring = 10000 * square(b) + a;
  *f = -2 * a - square(b) / 10000 + square(ring - 0.02) * 1e-4;
}
void himmelbg(Size, const double* x, double* f) {
  *f = (2 * square(x[0]) + 3 * square(x[1])) * std::exp(-x[0] - x[1]);
}
void maratos(Size, const double* x, double* f) {
  *f = x[0] + 100 * square(square(x[0]) + square(x[1]) - 1);
}
void zangwil(Size, const double* x, double* f) {
  *f = (16 * square(x[0]) + 16 * square(x[1]) - 8 * x[0] * x[1] - 56 * x[0] - 256 * x[1] + 991) / 15;
}
void broyden_power(Size n, const double* x, double* f) {
  // Luksan and Vlcek's generalized Broyden tridiagonal function.
  *f = 0;
  for (Size i = 0; i < n; ++i) {
    const double before = i > 0 ? x[i - 1] : 0, after = i + 1 < n ? x[i + 1] : 0;
    *f += std::pow(std::abs((3 - 2 * x[i]) * x[i] - before - after + 1), 7.0 / 3);
  }
}
void toint_seven(Size n, const double* x, double* f) {
  // Toint's seven-diagonal generalization of Broyden's function.
  broyden_power(n, x, f);
  for (Size i = 0; i < n / 2; ++i)
    *f += std::pow(std::abs(x[i] + x[i + n / 2]), 7.0 / 3);
}
void nazareth(Size n, const double* x, double* f) {
  *f = 0;
  for (Size i = 0; i < n; ++i) {
    double sum = number(n) + number(i + 1);
    for (Size j = 0; j < n; ++j) {
      const double a = 5 * (1 + number((i + 1) % 5) + number((j + 1) % 5)), b = number(i + 1 + j + 1) / 10;
      sum -= a * std::sin(x[j]) / number(n) + b * std::cos(x[j]) / number(n);
    }
    *f += square(sum) / number(n);
  }
}
void boundary_energy(Size n, const double* x, double* f) {
  // The energy of -u'' + exp u = 0 on n inner nodes with u = 0 and u = 1 at the ends.
  const double h = 1 / number(n + 1);
  *f = 0;
  for (Size i = 0; i <= n; ++i) {
    const double a = i > 0 ? x[i - 1] : 0, b = i < n ? x[i] : 1;
    *f += square(b - a) / (2 * h) + h * (std::exp(a) + std::exp(b)) / 2;
  }
}
void lennard_jones(Size n, const double* x, double* f) {
  // Points of a line of springs that repel each other.
  *f = 0;
  for (Size i = 0; i + 2 < n; i += 3) {
    *f += 0.1 * (square(x[i]) + square(x[i + 1]) + square(x[i + 2]));
    for (Size j = 0; j < i; j += 3) {
      const double d = square(x[i] - x[j]) + square(x[i + 1] - x[j + 1]) + square(x[i + 2] - x[j + 2]);
      *f += 1 / (0.05 + d);
    }
  }
}

}  // namespace

std::vector<SuiteRow> suite_values() {
  return {
      {"ARWHEAD", 10, 0, {1}, {}, {}, 0, arwhead},
      {"ENGVAL1", 10, 0, {2}, {}, {}, 0, engval_one},
      {"DIXMAANA", 12, 0, {2}, {}, {}, 0, dixmaana},
      {"DIXMAANI", 9, 0, {2}, {}, {}, 0, dixmaani},
      {"EDENSCH", 10, 0, {8}, {}, {}, 0, edensch},
      {"LIARWHD", 8, 0, {4}, {}, {}, 0, liarwhd},
      {"NONDIA", 8, 0, {-1}, {}, {}, 0, nondia},
      {"TRIDIA", 10, 0, {1}, {}, {}, 0, tridia},
      {"DQRTIC", 10, 0, {2}, {}, {}, 0, dqrtic},
      {"POWER", 10, 0, {1}, {}, {}, 0, power},
      {"CRAGGLVY", 8, 0, {1, 2, 2, 2, 2, 2, 2, 2}, {}, {}, 0, cragg_levy},
      {"FLETCHCR", 6, 0, {0}, {}, {}, 0, fletchcr},
      {"NONCVXU2", 10, 0, {1}, {}, {}, 1, nonconvex},
      {"COSINE", 10, 0, {1}, {}, {}, 0, cosine},
      {"SCHMVETT", 8, 0, {0.5}, {}, {}, 0, schmvett},
      {"TQUARTIC", 8, 0, {0.1}, {}, {}, 0, tquartic},
      {"DIXON3DQ", 10, 0, {-1}, {}, {}, 0, dixon},
      {"ALLINITU", 4, 0, {0}, {}, {}, 0, allinitu},
      {"BRKMCC, without its pole", 2, 0, {0.5}, {}, {}, 0, brkmcc},
      {"CLIFF", 2, 0, {0, -1}, {}, {}, 0, cliff},
      {"SISSER", 2, 0, {1, 0.1}, {}, {}, 0, sisser},
      {"HAIRY", 2, 0, {-5, -7}, {}, {}, 0, hairy},
      {"MEXHAT, softened", 2, 0, {0.86, 0.72}, {}, {}, 0, mexican_hat},
      {"HIMMELBG", 2, 0, {0.5}, {}, {}, 0, himmelbg},
      {"MARATOSB, softened", 2, 0, {1.1, 0.1}, {}, {}, 0, maratos},
      {"ZANGWIL2", 2, 0, {3, 8}, {}, {}, 0, zangwil},
      {"generalized Broyden", 10, 0, {-1}, {}, {}, 0, broyden_power},
      {"Toint 7-diagonal", 10, 0, {-1}, {}, {}, 0, toint_seven},
      {"Nazareth trigonometric", 6, 0, {0.2}, {}, {}, 0, nazareth},
      {"boundary energy", 15, 0, {0.1}, {}, {}, 0, boundary_energy},
      {"repelling points", 12, 0, {0.3, -0.5, 0.7, 1.1, 0.2, -0.9}, {}, {}, 0.1, lennard_jones},
  };
}

}  // namespace orbicube::bench
