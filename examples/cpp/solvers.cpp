// The example problems of examples/c in C++: a fit without derivatives, a mix of feeds, points that repel each other.
// Returns 0 only when the results are right.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <orbicube/projected_gradient.hpp>
#include <orbicube/sphere_optimizer.hpp>
#include <orbicube/trust_region.hpp>

using orbicube::Doubles;
using orbicube::View;

// Fits a / (1 + b t) + c to eight measurements, within bounds.
static bool decay() {
  const auto model = [](Doubles x, std::size_t i) { return x[0] / (1 + x[1] * (0.5 * double(i))) + x[2]; };
  const std::array<double, 3> truth = {2.5, 0.7, 0.4};
  const auto misfit = [&](Doubles x, View<double> residuals) {
    for (std::size_t i = 0; i < residuals.size(); ++i)
      residuals[i] = model(x, i) - model(truth, i);
  };
  orbicube::trust_region::Problem problem;
  problem.lower = {0, 0, -1};
  problem.upper = {10, 2, 1};
  std::vector<double> x = {1, 0.1, 0};
  const auto result = orbicube::trust_region::least_squares(misfit, x, 8, problem);
  std::printf("decay: %s after %d evaluations, %.9f %.9f %.9f\n", orbicube::trust_region::stop_name(result.stop),
              int(result.evaluations), x[0], x[1], x[2]);

  // The same by reverse communication.
  orbicube::trust_region::Solver solver(std::array<double, 3>{1, 0.1, 0}, 8, problem);
  std::vector<double> residuals(8);
  while (solver.ask()) {
    misfit(solver.point(), residuals);
    solver.tell(residuals);
  }
  return solver.best() == x && std::abs(x[0] - 2.5) < 1e-7 && std::abs(x[1] - 0.7) < 1e-7;
}

// The cheapest mix of five feeds that reaches a given share of protein.
static bool feeds() {
  const std::array<double, 5> price = {0.9, 0.3, 0.5, 1.4, 0.2}, usual = {0.2, 0.3, 0.2, 0.1, 0.2},
                              weight = {2, 1, 3, 1, 4};
  const auto cost = [&](Doubles x, View<double> gradient) {
    double sum = 0;
    for (std::size_t j = 0; j < x.size(); ++j) {
      const double away = x[j] - usual[j];
      sum = sum + (price[j] * x[j] + 0.5 * weight[j] * away * away);
      gradient[j] = price[j] + weight[j] * away;
    }
    return sum;
  };
  orbicube::projected_gradient::Problem problem;
  problem.lower.assign(5, 0.0);
  problem.upper.assign(5, 0.6);
  problem.rows.add({{0, 1}, {1, 1}, {2, 1}, {3, 1}, {4, 1}}, 1);
  problem.rows.add({{0, 0.12}, {1, 0.09}, {2, 0.35}, {3, 0.44}, {4, 0.05}}, 0.2);
  std::vector<double> x(5);
  const auto result = orbicube::projected_gradient::minimize(cost, x, problem);
  std::printf("feeds: %s after %d evaluations, %.9f %.9f %.9f %.9f %.9f\n",
              orbicube::projected_gradient::stop_name(result.stop), int(result.evaluations), x[0], x[1], x[2], x[3],
              x[4]);
  return result.stop == OBC_PROJECTED_GRADIENT_CONVERGED && result.equality_residual < 1e-14 &&
         *std::min_element(x.begin(), x.end()) >= 0;
}

// Twelve points on a sphere that repel each other settle at the corners of an icosahedron.
static bool charges() {
  const auto energy = [](Doubles x, View<double> gradient) {
    double sum = 0;
    std::fill(gradient.begin(), gradient.end(), 0.0);
    for (std::size_t i = 0; i < x.size(); i += 3) {
      for (std::size_t j = 0; j < i; j += 3) {
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k)
          square += (x[i + k] - x[j + k]) * (x[i + k] - x[j + k]);
        const double term = 1 / square;
        sum += term;
        for (std::size_t k = 0; k < 3; ++k) {
          const double pull = 2 * term * term * (x[i + k] - x[j + k]);
          gradient[i + k] -= pull;
          gradient[j + k] += pull;
        }
      }
    }
    return sum;
  };
  std::vector<double> x(36);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = double(i * i * 7 % 37) / 37 - 0.5;
  const auto result = orbicube::sphere_optimizer::minimize(energy, x, 3);
  std::printf("charges: %s after %d evaluations, energy %.9f\n", orbicube::sphere_optimizer::stop_name(result.stop),
              int(result.evaluations), result.value);
  return std::abs(result.value - 39) < 1e-9;
}

int main() try { return decay() && feeds() && charges() ? 0 : 1; } catch (const orbicube::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
