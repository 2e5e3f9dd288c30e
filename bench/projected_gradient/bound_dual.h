// Forward differentiation for the small problems, which are written as values alone.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "bound_problems.h"

namespace orbicube::bench {

struct Dual {
  static constexpr std::size_t width = 25;
  double value = 0;
  std::array<double, width> slope{};

  Dual() = default;
  Dual(double constant) : value(constant) {}

  // This value with the slopes times `factor`.
  Dual chained(double new_value, double factor) const {
    Dual result(new_value);
    for (std::size_t k = 0; k < width; ++k)
      result.slope[k] = factor * slope[k];
    return result;
  }
};

inline Dual combined(double value, const Dual& a, double by_a, const Dual& b, double by_b) {
  Dual result(value);
  for (std::size_t k = 0; k < Dual::width; ++k)
    result.slope[k] = by_a * a.slope[k] + by_b * b.slope[k];
  return result;
}
inline Dual operator+(const Dual& a, const Dual& b) {
  return combined(a.value + b.value, a, 1, b, 1);
}
inline Dual operator-(const Dual& a, const Dual& b) {
  return combined(a.value - b.value, a, 1, b, -1);
}
inline Dual operator-(const Dual& a) {
  return a.chained(-a.value, -1);
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return combined(a.value * b.value, a, b.value, b, a.value);
}
inline Dual operator/(const Dual& a, const Dual& b) {
  return combined(a.value / b.value, a, 1 / b.value, b, -a.value / (b.value * b.value));
}
inline Dual& operator+=(Dual& a, const Dual& b) {
  return a = a + b;
}
inline Dual& operator*=(Dual& a, const Dual& b) {
  return a = a * b;
}
inline Dual exp(const Dual& a) {
  return a.chained(std::exp(a.value), std::exp(a.value));
}
inline Dual log(const Dual& a) {
  return a.chained(std::log(a.value), 1 / a.value);
}
inline Dual sin(const Dual& a) {
  return a.chained(std::sin(a.value), std::cos(a.value));
}
inline Dual cos(const Dual& a) {
  return a.chained(std::cos(a.value), -std::sin(a.value));
}
inline Dual sqrt(const Dual& a) {
  return a.chained(std::sqrt(a.value), 0.5 / std::sqrt(a.value));
}
inline Dual pow(const Dual& a, double exponent) {
  return a.chained(std::pow(a.value, exponent), exponent * std::pow(a.value, exponent - 1));
}
inline Dual square(const Dual& a) {
  return a * a;
}

using Duals = std::vector<Dual>;

// The problem whose value is `f`, of up to Dual::width unknowns.
template <class Function>
BoundProblem dual_problem(std::string name, std::vector<double> start, std::vector<double> lower,
                          std::vector<double> upper, double optimum, Function f) {
  BoundProblem p;
  p.name = std::move(name);
  p.start = std::move(start);
  p.lower = std::move(lower);
  p.upper = std::move(upper);
  p.optimum = optimum;
  const std::size_t n = p.start.size();
  p.evaluate = [n, f](const double* x, double* gradient) {
    Duals variables(n);
    for (std::size_t j = 0; j < n; ++j) {
      variables[j].value = x[j];
      variables[j].slope[j] = 1;
    }
    const Dual value = f(variables);
    for (std::size_t j = 0; j < n; ++j)
      gradient[j] = value.slope[j];
    return value.value;
  };
  return p;
}

}  // namespace orbicube::bench
