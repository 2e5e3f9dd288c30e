// Few unknowns: Hock and Schittkowski's problems with bounds, CUTEst's HATFLD and others, More, Garbow and Hillstrom's
// with bounds that hold at the minimum or near it.
#include <numbers>

#include "bound_dual.h"

namespace orbicube::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Dual rosenbrock(const Dual& a, const Dual& b, double weight) {
  return weight * square(b - a * a) + square(1.0 - a);
}

Dual colville(const Duals& x) {
  return 100.0 * square(x[1] - x[0] * x[0]) + square(1.0 - x[0]) + 90.0 * square(x[3] - x[2] * x[2]) +
         square(1.0 - x[2]) + 10.1 * (square(x[1] - 1.0) + square(x[3] - 1.0)) + 19.8 * (x[1] - 1.0) * (x[3] - 1.0);
}

Dual exponential_fit_25(const Duals& x) {
  Dual sum;
  for (int i = 1; i <= 99; ++i) {
    const double u = 25 + std::pow(-50 * std::log(0.01 * i), 2.0 / 3);
    const Dual base = u - x[1];
    // (u - x2)^x3 where it has no value counts as zero.
    const Dual power = base.value > 0 ? exp(x[2] * log(base)) : Dual(0);
    sum += square(exp(-power / x[0]) - 0.01 * i);
  }
  return sum;
}

Dual hs110(const Duals& x) {
  Dual sum, product(1);
  for (const Dual& v : x) {
    sum += square(log(v - 2.0)) + square(log(10.0 - v));
    product *= v;
  }
  return sum - pow(product, 0.2);
}

void add_hock_schittkowski(std::vector<BoundProblemMaker>& list) {
  using std::vector;
  const auto add = [&](const char* name, vector<double> start, vector<double> lower, vector<double> upper,
                       double optimum,
                       auto f) { list.push_back([=] { return dual_problem(name, start, lower, upper, optimum, f); }); };
  const double inf = infinity;
  add("HS1", {-2, 1}, {-inf, -1.5}, {inf, inf}, 0, [](const Duals& x) { return rosenbrock(x[0], x[1], 100); });
  add("HS2", {-2, 1}, {-inf, 1.5}, {inf, inf}, unknown, [](const Duals& x) { return rosenbrock(x[0], x[1], 100); });
  add("HS3", {10, 1}, {-inf, 0}, {inf, inf}, 0, [](const Duals& x) { return x[1] + 1e-5 * square(x[1] - x[0]); });
  add("HS3MOD", {10, 1}, {-inf, 0}, {inf, inf}, 0, [](const Duals& x) { return x[1] + square(x[1] - x[0]); });
  add("HS4", {1.125, 0.125}, {1, 0}, {inf, inf}, 8.0 / 3,
      [](const Duals& x) { return pow(x[0] + 1.0, 3) / 3.0 + x[1]; });
  add("HS5", {0, 0}, {-1.5, -3}, {4, 3}, -0.5 * std::sqrt(3.0) - std::numbers::pi / 3,
      [](const Duals& x) { return sin(x[0] + x[1]) + square(x[0] - x[1]) - 1.5 * x[0] + 2.5 * x[1] + 1.0; });
  add("HS25", {100, 12.5, 3}, {0.1, 0, 0}, {100, 25.6, 5}, unknown, exponential_fit_25);
  add("HS38", {-3, -1, -3, -1}, vector(4, -10.0), vector(4, 10.0), 0, colville);
  add("HS45", vector(5, 2.0), vector(5, 0.0), {1, 2, 3, 4, 5}, 1,
      [](const Duals& x) { return 2.0 - x[0] * x[1] * x[2] * x[3] * x[4] / 120.0; });
  add("HS110", vector(10, 9.0), vector(10, 2.001), vector(10, 9.999), -45.77846971, hs110);
}

void add_cutest(std::vector<BoundProblemMaker>& list) {
  using std::vector;
  const auto add = [&](const char* name, vector<double> start, vector<double> lower, vector<double> upper,
                       double optimum,
                       auto f) { list.push_back([=] { return dual_problem(name, start, lower, upper, optimum, f); }); };
  const double inf = infinity;
  const auto hatfld = [](const Duals& x) {
    Dual sum = square(x[0] - 1.0);
    for (std::size_t i = 1; i < x.size(); ++i)
      sum += square(x[i - 1] - sqrt(x[i]));
    return sum;
  };
  add("HATFLDA", vector(4, 0.1), vector(4, 1e-7), vector(4, inf), 0, hatfld);
  add("HATFLDB", vector(4, 0.1), vector(4, 1e-7), {inf, 0.8, inf, inf}, 5.5728090e-3, hatfld);
  add("HATFLDC", vector(25, 0.9), vector(25, 0.0), vector(25, 10.0), 0, [](const Duals& x) {
    Dual sum = square(x[0] - 1.0) + square(x.back() - 1.0);
    for (std::size_t i = 1; i + 1 < x.size(); ++i)
      sum += square(x[i + 1] - x[i] * x[i]);
    return sum;
  });
  add("LOGROS", {-1.2, 1}, {0, 0}, {inf, inf}, 0,
      [](const Duals& x) { return log(1.0 + rosenbrock(x[0], x[1], 10000)); });
  add("MDHOLE", {10, 1}, {0, -inf}, {inf, inf}, 0,
      [](const Duals& x) { return x[0] + 100.0 * square(sin(x[0]) - x[1]); });
  add("CAMEL6", {1.1, 1.1}, {-3, -1.5}, {3, 1.5}, unknown, [](const Duals& x) {
    const Dual a = x[0] * x[0], b = x[1] * x[1];
    return (4.0 - 2.1 * a + a * a / 3.0) * a + x[0] * x[1] + 4.0 * (b - 1.0) * b;
  });
}

Dual helical_valley(const Duals& x) {
  const double turn = std::atan2(x[1].value, x[0].value) / (2 * std::numbers::pi);
  const Dual radius = sqrt(x[0] * x[0] + x[1] * x[1]);
  const double square_radius = radius.value * radius.value * 2 * std::numbers::pi;
  const Dual angle = combined(turn, x[0], -x[1].value / square_radius, x[1], x[0].value / square_radius);
  return 100.0 * (square(x[2] - 10.0 * angle) + square(radius - 1.0)) + x[2] * x[2];
}

Dual watson(const Duals& x) {
  Dual sum = square(x[0]) + square(x[1] - x[0] * x[0] - 1.0);
  for (int i = 1; i <= 29; ++i) {
    const double t = i / 29.0;
    Dual first, second;
    for (std::size_t j = x.size(); j-- > 0;)
      second = x[j] + t * second;
    for (std::size_t j = x.size(); j-- > 1;)
      first = static_cast<double>(j) * x[j] + t * first;
    sum += square(first - second * second - 1.0);
  }
  return sum;
}

void add_more_garbow_hillstrom(std::vector<BoundProblemMaker>& list) {
  using std::vector;
  const auto add = [&](const char* name, vector<double> start, vector<double> lower, vector<double> upper,
                       double optimum,
                       auto f) { list.push_back([=] { return dual_problem(name, start, lower, upper, optimum, f); }); };
  const double inf = infinity;
  add("Wood, x <= 0.9", {-3, -1, -3, -1}, vector(4, -inf), vector(4, 0.9), unknown, colville);
  add("Beale, x1 <= 2", {1, 1}, {-inf, -inf}, {2, inf}, unknown, [](const Duals& x) {
    return square(1.5 - x[0] * (1.0 - x[1])) + square(2.25 - x[0] * (1.0 - x[1] * x[1])) +
           square(2.625 - x[0] * (1.0 - x[1] * x[1] * x[1]));
  });
  add("helical valley, x1 <= 0.8", {-1, 0, 0}, {-inf, -inf, -1}, {0.8, inf, 1}, unknown, helical_valley);
  add("Watson n=9, x >= -1", vector(9, 0.0), vector(9, -1.0), vector(9, 1.0), unknown, watson);
  add("Powell badly scaled", {0, 1}, {0, 1}, {1, 9}, unknown,
      [](const Duals& x) { return square(1e4 * x[0] * x[1] - 1.0) + square(exp(-x[0]) + exp(-x[1]) - 1.0001); });
  add("Brown badly scaled", {1, 1}, {0, 3e-5}, {1e6, 100}, unknown,
      [](const Duals& x) { return square(x[0] - 1e6) + square(x[1] - 2e-6) + square(x[0] * x[1] - 2.0); });
  add("Brown almost linear n=10", vector(10, 0.5), vector(10, -100.0), vector(10, 0.95), unknown, [](const Duals& x) {
    Dual total = -static_cast<double>(x.size() + 1), product(1), sum;
    for (const Dual& v : x) {
      total += v;
      product *= v;
    }
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
      sum += square(x[i] + total);
    return sum + square(product - 1.0);
  });
}

}  // namespace

void add_small_problems(std::vector<BoundProblemMaker>& list) {
  add_hock_schittkowski(list);
  add_cutest(list);
  add_more_garbow_hillstrom(list);
}

}  // namespace orbicube::bench
