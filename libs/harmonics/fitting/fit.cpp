#include "harmonics/fitting/fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "base/counted.h"
#include "base/random.h"
#include "harmonics/fitting/conjugate_gradients.h"
#include "harmonics/fitting/fit_samples.h"
#include "harmonics/fitting/gram_operator.h"
#include "harmonics/fitting/householder.h"
#include "harmonics/fitting/large_fit.h"
#include "harmonics/fitting/passes.h"

namespace orbicube::harmonics {
namespace {

FitSamples checked(std::span<const Vector3> directions, std::span<const double> weights, std::span<const double> values,
                   std::size_t channels, const FitOptions& options) {
  const auto wrong = [](const std::string& text) -> base::Error { return {"invalid-argument", text}; };
  require_degree(options.degree);
  if (!(options.regularization >= 0) || !std::isfinite(options.regularization))
    throw wrong("regularization is negative");
  if (options.method < FitMethod::automatic || options.method > FitMethod::iterative) throw wrong("unknown method");
  if (channels == 0) throw wrong("no values");
  if (directions.empty()) throw wrong("no directions");
  if (values.size() != directions.size() * channels)
    throw wrong(base::counted(values.size(), "value") + ", " + std::to_string(directions.size() * channels) +
                " are needed");
  if (!weights.empty() && weights.size() != directions.size())
    throw wrong(base::counted(weights.size(), "weight") + " for " + base::counted(directions.size(), "direction"));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]))
      throw wrong("the value at direction " + std::to_string(i / channels) + " is not finite");
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] >= 0) || !std::isfinite(weights[i]))
      throw wrong("weight " + std::to_string(i) + " is negative or not finite");
  }
  FitSamples samples{directions, weights, values, channels, 0};
  samples.total_weight = base::blocked_sum(samples.count(), [&](std::size_t i) { return samples.weight(i); });
  if (!(samples.total_weight > 0) || !std::isfinite(samples.total_weight)) throw wrong("the weights add up to nothing");
  return samples;
}

// Of the iterative method.
constexpr int max_passes = 8;
constexpr std::uint64_t max_iterations = 2000;  // in each

Coefficients fit_dense(const FitSamples& samples, const FitOptions& options, const base::Host& host,
                       FitReport& report) {
  const std::size_t unknowns = basis_size(options.degree), n = samples.count(), channels = samples.channels;
  const std::size_t rows = n + (options.regularization > 0 ? unknowns : 0);
  Array<double> matrix(rows * unknowns, host.memory), right(rows * channels, host.memory),
      x(unknowns * channels, host.memory);
  {
    Array<double> basis(n * unknowns, host.memory);
    evaluate(samples.directions, options.degree, basis, host);
    for (std::size_t i = 0; i < n; ++i) {
      const double root = std::sqrt(samples.weight(i));
      for (std::size_t k = 0; k < unknowns; ++k)
        matrix[k * rows + i] = root * basis[i * unknowns + k];
      for (std::size_t c = 0; c < channels; ++c)
        right[c * rows + i] = root * samples.values[i * channels + c];
    }
  }
  for (std::uint32_t l = 0; l <= options.degree && rows > n; ++l) {
    for (std::size_t k = basis_index(l, -static_cast<std::int32_t>(l)); k < basis_size(l); ++k)
      matrix[k * rows + n + k] = std::sqrt(regularization_penalty(samples, options, l));
  }
  const DenseSolution solution = solve_dense(matrix, rows, unknowns, right, channels, x, host);
  report.rank = solution.rank;
  report.condition = solution.condition;
  Coefficients coefficients(options.degree, channels, host.memory);
  for (std::size_t k = 0; k < unknowns; ++k) {
    for (std::size_t c = 0; c < channels; ++c)
      coefficients.values[k * channels + c] = x[c * unknowns + k];
  }
  return coefficients;
}

class NormalEquations {
 public:
  NormalEquations(const FitSamples& samples, const FitOptions& options, const base::Host& host)
      : gram_(weight_moments(samples, options.degree, host), host),
        penalties_(basis_size(options.degree), host.memory) {
    for (std::uint32_t l = 0; l <= options.degree; ++l) {
      for (std::size_t k = std::size_t{l} * l; k < basis_size(l); ++k)
        penalties_[k] = regularization_penalty(samples, options, l);
    }
  }

  void multiply(std::span<const double> x, std::size_t channels, std::span<double> product) {
    gram_.multiply(x, channels, product);
    add_penalty(x, channels, 1, product);
  }
  void add_penalty(std::span<const double> x, std::size_t channels, double factor, std::span<double> to) const {
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] += factor * penalties_[i / channels] * x[i];
  }

  // The rank of G by Cholesky's factorization with pivoting, of its entries. O(size^3).
  std::size_t rank(const base::Host& host) {
    const std::size_t size = penalties_.size();
    Array<double> matrix(size * size, host.memory);
    Array<double> unit(size * channel_group, host.memory), product(size * channel_group, host.memory);
    for (std::size_t k = 0; k < size; k += channel_group) {
      host.report("counting the rank", k, 2 * size);
      std::fill(unit.begin(), unit.end(), 0.0);
      const std::size_t here = std::min(channel_group, size - k);
      for (std::size_t c = 0; c < here; ++c)
        unit[(k + c) * channel_group + c] = 1;
      multiply(unit, channel_group, product);
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t c = 0; c < here; ++c)
          matrix[(k + c) * size + i] = product[i * channel_group + c];
      }
    }
    using Columns = Eigen::Map<Eigen::MatrixXd>;
    const auto n = static_cast<Eigen::Index>(size);
    Columns g(matrix.data(), n, n);
    const double threshold = static_cast<double>(size) * 1e-15 * g.diagonal().maxCoeff();
    for (Eigen::Index k = 0; k < n; ++k) {
      host.report("counting the rank", size + static_cast<std::size_t>(k), 2 * size);
      Eigen::Index best = k;
      for (Eigen::Index j = k + 1; j < n; ++j)
        best = g(j, j) > g(best, best) ? j : best;
      if (g(best, best) <= threshold) return static_cast<std::size_t>(k);
      g.col(k).swap(g.col(best));
      g.row(k).swap(g.row(best));
      // What is left of the matrix, all of it: the swaps then need no case apart.
      const double pivot = g(k, k);
      const Eigen::Index rest = n - k - 1;
      const Eigen::VectorXd column = g.col(k).tail(rest);
      for (Eigen::Index j = 0; j < rest; ++j)
        g.col(k + 1 + j).tail(rest) -= column[j] / pivot * column;
    }
    return size;
  }

 private:
  GramOperator gram_;
  Array<double> penalties_;
};

Coefficients fit_iterative(const FitSamples& samples, const FitOptions& options, const base::Host& host,
                           FitReport& report) {
  const std::size_t unknowns = basis_size(options.degree), channels = samples.channels;
  NormalEquations equations(samples, options, host);
  const Multiply multiply = [&](std::span<const double> x, std::size_t columns, std::span<double> product) {
    equations.multiply(x, columns, product);
  };
  Coefficients coefficients(options.degree, channels, host.memory);

  // A random right side has something in every direction, also in those that the samples say nothing of.
  {
    Array<double> random(unknowns, host.memory), ignored(unknowns, host.memory);
    std::mt19937_64 engine(1);
    for (double& entry : random)
      entry = base::unit_interval(engine()) - 0.5;
    constexpr double tolerance = 1e-4;
    const ConjugateGradientsReport probe =
        conjugate_gradients(multiply, random, 1, ignored,
                            {.tolerance = tolerance,
                             .max_iterations = 400 + 4 * std::uint64_t{options.degree},
                             .phase = "measuring the condition"},
                            host);
    report.iterations += probe.iterations;
    const double ratio = probe.largest > 0 && !probe.singular ? probe.smallest / probe.largest : 0;
    constexpr double rounding = 1e-13;  // of the eigenvalues of G, relative to the largest
    // A system that takes this number of iterations may have a smallest eigenvalue that they have not come to.
    const bool doubtful = ratio < rounding || probe.residual > tolerance;
    constexpr std::uint32_t counted_up_to = 40;
    report.rank = !doubtful ? unknowns : options.degree <= counted_up_to ? equations.rank(host) : 0;
    report.condition = 1 / std::sqrt(std::max(ratio, rounding));
  }

  Array<double> change(unknowns * channels, host.memory);
  const auto add_solution = [&](const Coefficients& right, bool) {
    const ConjugateGradientsReport solved = conjugate_gradients(
        multiply, right.values, channels, change, {.tolerance = 1e-8, .max_iterations = max_iterations}, host);
    report.iterations += solved.iterations;
    for (std::size_t i = 0; i < change.size(); ++i)
      coefficients.values[i] += change[i];
    return true;
  };
  fit_in_passes(samples, equations, {.max_passes = max_passes, .enough = 1e-15}, coefficients, add_solution, host);
  return coefficients;
}

// Hours that end in coefficients that the samples do not determine are for who chooses them.
void refuse_too_high_degree(std::size_t samples, const FitOptions& options) {
  // By the third power of the degree, of one processor, for the most iterations of either iterative method.
  const double degree = options.degree, most = 400 + 4 * degree;
  const double seconds_of_cube =
      options.degree < large_fit_degree ? 5e-8 * (max_passes * max_iterations + 4 * degree) : 1.5e-8 * most;
  const double seconds = std::max(60.0, seconds_of_cube * std::pow(degree + 1, 3));
  const auto highest = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(samples))) - 1;
  throw base::Error("invalid-argument",
                    "degree " + std::to_string(options.degree) + " has " +
                        base::counted(basis_size(options.degree), "coefficient") + ", more than the " +
                        base::counted(samples, "sample") + ", and may take " +
                        (seconds < 7200 ? base::counted(std::lround(seconds / 60), "minute")
                                        : base::counted(std::lround(seconds / 3600), "hour")) +
                        "; that many samples determine degree " + std::to_string(highest) +
                        ": lower the degree, or set a regularization, or choose the iterative method");
}

}  // namespace

Coefficients weight_moments(const FitSamples& samples, std::uint32_t degree, const base::Host& host) {
  Coefficients moments(2 * degree, 1, host.memory);
  const Array<double> ones(samples.weights.empty() ? samples.count() : 0, 1.0, host.memory);
  analyse(samples.directions, {}, samples.weights.empty() ? std::span<const double>(ones) : samples.weights, moments,
          "moments of the weights", host);
  return moments;
}

Coefficients fit(std::span<const Vector3> directions, std::span<const double> weights, std::span<const double> values,
                 std::size_t channels, const FitOptions& options, const base::Host& host, FitReport& report) {
  const FitSamples samples = checked(directions, weights, values, channels, options);
  report = {};
  report.unknowns = basis_size(options.degree);
  const double n = static_cast<double>(samples.count()), k = static_cast<double>(report.unknowns);
  constexpr double dense_work = 5e8;
  const bool dense = n * k * k <= dense_work || (n < k && options.regularization == 0 && n * n * k <= dense_work);
  if (options.method == FitMethod::automatic && !dense && n < k && options.regularization == 0)
    refuse_too_high_degree(samples.count(), options);
  report.method = options.method != FitMethod::automatic ? options.method
                  : dense                                ? FitMethod::dense
                                                         : FitMethod::iterative;
  Coefficients coefficients(host.memory);
  if (report.method == FitMethod::dense)
    coefficients = fit_dense(samples, options, host, report);
  else if (!fit_large(samples, options, host, coefficients, report))
    coefficients = fit_iterative(samples, options, host, report);
  Array<double> fitted(values.size(), host.memory);
  synthesise(coefficients, directions, fitted, host);
  const double sum = base::blocked_sum(values.size(), [&](std::size_t i) {
    return samples.weight(i / channels) * (values[i] - fitted[i]) * (values[i] - fitted[i]);
  });
  report.residual = std::sqrt(sum / samples.total_weight);
  return coefficients;
}

}  // namespace orbicube::harmonics
