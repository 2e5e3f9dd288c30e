#include "harmonics/fitting/large_fit.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/random.h"
#include "harmonics/fitting/block_conjugate_gradients.h"
#include "harmonics/fitting/gauss_grid.h"
#include "harmonics/fitting/passes.h"

namespace orbicube::harmonics {
namespace {

// Width of the kernel that smooths the density for the preconditioner, in radians times degree: less resolves gaps
// whose small eigenvalues come back as large ones, more does not see the density.
constexpr double smoothing_width = 0.8;
// Least density in the preconditioner: of the median, and of the mean where the median is no measure.
constexpr double floor_of_median = 0.1, floor_of_mean = 1e-6;
// |G x - b| of |b|: of the functions, and of the random column.
constexpr double tolerance = 1e-12, probe_tolerance = 1e-4;
// A fit ends when the gradient at the samples is this fraction of the first.
constexpr double enough = 1e-11;
constexpr int max_refinements = 3;
// Functions that are solved for together.
constexpr std::size_t max_together = 3;

class LargeNormalEquations {
 public:
  LargeNormalEquations(const FitSamples& samples, const FitOptions& options, const base::Host& host)
      : grid_(options.degree, host),
        density_(host.memory),
        inverse_(host.memory),
        penalties_(host.memory),
        damping_(host.memory),
        scratch_(host.memory) {
    Coefficients moments = weight_moments(samples, options.degree, host);
    density_ = grid_.values(moments);
    grid_.weigh(density_);
    const double mean = samples.total_weight / (4 * std::numbers::pi);
    set_inverse(moments, options.degree, mean, host);
    for (std::uint32_t l = 0; l <= options.degree; ++l) {
      const double penalty = regularization_penalty(samples, options, l);
      penalties_.insert(penalties_.end(), 2 * std::size_t{l} + 1, penalty);
      damping_.insert(damping_.end(), 2 * std::size_t{l} + 1, std::sqrt(mean / (mean + penalty)));
    }
  }

  void multiply(std::span<const double> x, std::size_t channels, std::span<double> product) {
    grid_.multiply(density_, x, channels, product);
    add_penalty(x, channels, 1, product);
  }
  void precondition(std::span<const double> x, std::size_t channels, std::span<double> product) {
    scratch_.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      scratch_[i] = damping_[i / channels] * x[i];
    grid_.multiply(inverse_, scratch_, channels, product);
    for (std::size_t i = 0; i < x.size(); ++i)
      product[i] *= damping_[i / channels];
  }
  void add_penalty(std::span<const double> x, std::size_t channels, double factor, std::span<double> to) const {
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] += factor * penalties_[i / channels] * x[i];
  }

 private:
  // The inverse of the density that a heat kernel has smoothed.
  void set_inverse(Coefficients& moments, std::uint32_t degree, double mean, const base::Host& host) {
    constexpr const char* phase = "preparing the normal equations";
    const double time = 0.5 * smoothing_width * smoothing_width / (static_cast<double>(degree) * degree);
    for (std::uint32_t l = 0; l <= moments.degree; ++l) {
      const double factor = std::exp(-time * l * (l + 1.0));
      for (std::size_t k = std::size_t{l} * l; k < basis_size(l); ++k)
        moments.values[k] *= factor;
    }
    inverse_ = grid_.values(moments);
    host.report(phase, 0, 0);
    Array<double> sorted(density_.get_allocator().resource());
    for (std::size_t k = 0; k < inverse_.size(); ++k) {
      for (std::size_t lane = 0; lane < fourier_lanes; ++lane) {
        if (!grid_.exists(k / grid_.longitudes(), lane)) continue;
        for (const double value : {inverse_[k].real[lane], inverse_[k].imaginary[lane]}) {
          if (std::isfinite(value)) sorted.push_back(value);
        }
      }
    }
    host.report(phase, 0, 0);
    if (sorted.empty()) sorted.push_back(0);  // weights beyond the range of double
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    host.report(phase, 0, 0);
    const double least = std::max(floor_of_median * *middle, floor_of_mean * mean);
    for (ComplexLanes& value : inverse_) {
      for (std::size_t lane = 0; lane < fourier_lanes; ++lane) {
        value.real[lane] = 1 / std::max(value.real[lane], least);
        value.imaginary[lane] = 1 / std::max(value.imaginary[lane], least);
      }
    }
    host.report(phase, 0, 0);
    grid_.weigh(inverse_);
  }

  GaussGrid grid_;
  GaussGrid::Values density_, inverse_;
  Array<double> penalties_, damping_, scratch_;
};

// Solves for the columns of `right` and, in the first block of the first pass, for a random one.
class BlockSolver {
 public:
  BlockSolver(LargeNormalEquations& equations, std::uint32_t degree, const base::Host& host)
      : host_(host), degree_(degree), random_(basis_size(degree), host.memory) {
    multiply_ = [&equations](std::span<const double> x, std::size_t channels, std::span<double> product) {
      equations.multiply(x, channels, product);
    };
    precondition_ = [&equations](std::span<const double> x, std::size_t channels, std::span<double> product) {
      equations.precondition(x, channels, product);
    };
    std::mt19937_64 engine(1);
    for (double& entry : random_)
      entry = base::unit_interval(engine()) - 0.5;
  }

  // Adds the solution to x; returns whether all columns converged.
  bool add_solution(const Coefficients& right, bool probe, Coefficients& x, FitReport& report) {
    bool converged = true;
    for (std::size_t first = 0; first < right.channels; first += max_together) {
      const std::size_t count = std::min(max_together, right.channels - first);
      const bool with_probe = probe && first == 0;
      const std::size_t columns = count + (with_probe ? 1 : 0);
      Array<double> b(random_.size() * columns, host_.memory), solution(b.size(), host_.memory);
      for (std::size_t k = 0; k < random_.size(); ++k) {
        std::copy_n(&right.values[k * right.channels + first], count, &b[k * columns]);
        if (with_probe) b[k * columns + count] = random_[k];
      }
      Array<double> tolerances(columns, tolerance, host_.memory);
      if (with_probe) tolerances[count] = probe_tolerance;
      const std::uint64_t max_iterations = 400 + 4 * std::uint64_t{degree_};
      const BlockReport solved =
          block_conjugate_gradients(multiply_, precondition_, b, columns, tolerances, max_iterations, solution, host_);
      converged = converged && solved.converged;
      report.iterations += solved.iterations;
      for (std::size_t k = 0; k < random_.size(); ++k) {
        for (std::size_t c = 0; c < count; ++c)
          x.values[k * x.channels + first + c] += solution[k * columns + c];
      }
      if (with_probe) set_condition(solution, columns, count, solved.converged, report);
    }
    return converged;
  }

 private:
  // The random column's solution y has most in the direction of the smallest eigenvalue: y' G y / y' y.
  void set_condition(std::span<const double> solution, std::size_t columns, std::size_t column, bool converged,
                     FitReport& report) {
    double along = 0, square = 0;
    for (std::size_t k = 0; k < random_.size(); ++k) {
      const double y = solution[k * columns + column];
      along += y * random_[k];
      square += y * y;
    }
    Array<double> ignored(random_.size(), host_.memory);
    const double largest = conjugate_gradients(multiply_, random_, 1, ignored,
                                               {.max_iterations = 24, .phase = "measuring the condition"}, host_)
                               .largest;
    const double ratio = largest > 0 && square > 0 ? along / square / largest : 0;
    constexpr double rounding = 1e-13;  // of the eigenvalues of G, relative to the largest
    report.rank = converged && ratio >= rounding ? report.unknowns : 0;
    report.condition = 1 / std::sqrt(std::clamp(ratio, rounding, 1.0));
  }

  const base::Host& host_;
  std::uint32_t degree_;
  Array<double> random_;
  Multiply multiply_, precondition_;
};

}  // namespace

bool fit_large(const FitSamples& samples, const FitOptions& options, const base::Host& host, Coefficients& coefficients,
               FitReport& report) {
  if (options.degree < large_fit_degree) return false;
  LargeNormalEquations equations(samples, options, host);
  BlockSolver solver(equations, options.degree, host);
  coefficients = Coefficients(options.degree, samples.channels, host.memory);
  const auto add_solution = [&](const Coefficients& right, bool is_first) {
    return solver.add_solution(right, is_first, coefficients, report);
  };
  fit_in_passes(samples, equations, {.max_passes = max_refinements, .enough = enough}, coefficients, add_solution,
                host);
  return true;
}

}  // namespace orbicube::harmonics
