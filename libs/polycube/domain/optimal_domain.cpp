#include "polycube/domain/optimal_domain.h"
#include "polycube/surface/unit_size.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/error.h"
#include "projected_gradient/solver.h"

namespace orbicube::polycube {
namespace {

constexpr double max_stretch = 1000;

// Unknowns x and the lengths that they stand for, at a scale at which lengths are about 1.
class Unknowns {
 public:
  Unknowns(DomainVariables variables, std::span<const double> start, std::pmr::memory_resource* memory)
      : logarithmic_(variables == DomainVariables::logarithms),
        start_(start.size(), 0.0, memory),
        lower_(start.size(), 0.0, memory),
        upper_(start.size(), 0.0, memory),
        column_(start.size(), 0, memory),
        ones_(start.size(), 1.0, memory),
        lengths_(start.size(), 0.0, memory) {
    const auto count = static_cast<double>(start.size());
    double sum = 0;
    for (const double length : start)
      sum += logarithmic_ ? std::log(length) : length;
    scale_ = logarithmic_ ? std::exp(sum / count) : sum / count;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const double length = start[i] / scale_;
      const double least = std::min(length, 1.0) / max_stretch, most = std::max(length, 1.0) * max_stretch;
      start_[i] = logarithmic_ ? std::log(length) : length;
      lower_[i] = logarithmic_ ? std::log(least) : least;
      upper_[i] = logarithmic_ ? std::log(most) : most;
    }
    std::iota(column_.begin(), column_.end(), 0U);
    sum_ = std::accumulate(start_.begin(), start_.end(), 0.0);
    row_start_ = {0, start.size()};
  }

  projected_gradient::Problem problem() const {
    projected_gradient::Problem result;
    result.n = start_.size();
    result.lower = lower_;
    result.upper = upper_;
    result.row_start = row_start_;
    result.column = column_;
    result.value = ones_;
    result.rhs = {&sum_, 1};
    return result;
  }
  std::span<const double> start() const { return start_; }
  double scale() const { return scale_; }

  std::span<const double> lengths(std::span<const double> x) {
    for (std::size_t i = 0; i < x.size(); ++i)
      lengths_[i] = logarithmic_ ? std::exp(x[i]) : x[i];
    return lengths_;
  }
  // From one for the lengths that were requested last to one for x.
  void turn_gradient(std::span<double> gradient) const {
    if (!logarithmic_) return;
    for (std::size_t i = 0; i < gradient.size(); ++i)
      gradient[i] *= lengths_[i];
  }

 private:
  bool logarithmic_;
  double scale_ = 1, sum_ = 0;
  Array<double> start_, lower_, upper_;
  std::array<std::size_t, 2> row_start_{};
  Array<std::uint32_t> column_;
  Array<double> ones_, lengths_;
};

}  // namespace

bool lay_out(const CoordinateLayers& layers, std::span<const double> lengths, double scale,
             std::array<Array<double>, 3>& positions) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Array<double>& old = layers.positions[axis];
    Array<double>& along = positions[axis];
    const std::span<const double> own = lengths.subspan(layers.first_interval(axis), layers.intervals(axis));
    const double extent = scale * std::accumulate(own.begin(), own.end(), 0.0);
    along.resize(old.size());
    along[0] = old.front() + 0.5 * ((old.back() - old.front()) - extent);
    for (std::size_t i = 0; i < own.size(); ++i) {
      along[i + 1] = along[i] + scale * own[i];
      if (!(along[i + 1] > along[i])) return false;
    }
  }
  return true;
}

DomainMinimum minimise_domain(const DomainEnergy& energy, std::span<const double> start, const DomainOptions& options,
                              const base::Host& host) {
  base::require(start.size() == energy.size(), "one length for each interval is required");
  return minimise_domain(
      [&](std::span<const double> lengths, std::span<double> gradient) { return energy.evaluate(lengths, gradient); },
      start, options, host);
}

DomainMinimum minimise_domain(const LengthEnergy& energy, std::span<const double> start, const DomainOptions& options,
                              const base::Host& host) {
  using projected_gradient::Request;
  using projected_gradient::Stop;
  for (const double length : start)
    base::require(std::isfinite(length) && length > 0, "lengths must be positive");
  DomainMinimum result(host.memory);
  Unknowns unknowns(options.variables, start, host.memory);
  projected_gradient::Options solver_options;
  solver_options.gradient_tolerance = options.gradient_tolerance;
  solver_options.max_iterations = options.max_iterations;
  projected_gradient::Solver solver(unknowns.problem(), solver_options, unknowns.start(), host);
  Array<double> gradient(start.size(), 0.0, host.memory);
  for (;;) {
    const Request request = solver.step();
    if (request == Request::done) break;
    if (request == Request::iteration) {
      result.energies.push_back(solver.result().value);
      continue;
    }
    const double value = energy(unknowns.lengths(solver.point()), gradient);
    unknowns.turn_gradient(gradient);
    if (std::isfinite(value))
      solver.tell(value, gradient);
    else
      solver.tell_failure();
  }
  const projected_gradient::Result found = solver.result();
  if (found.stop == Stop::cancelled) throw base::Error("cancelled", "domain");
  result.evaluations = found.evaluations;
  if (!std::isfinite(found.value)) {
    // A triangle of a certified map may be flat but for rounding: the lengths stay.
    result.lengths.assign(start.begin(), start.end());
    return result;
  }
  result.converged = found.stop == Stop::converged || found.stop == Stop::stalled;
  const std::span<const double> best = unknowns.lengths(solver.best_point());
  for (const double length : best)
    result.lengths.push_back(length * unknowns.scale());
  return result;
}

namespace {

// Moves the polycube to what rounding makes of the best lengths, or, where that is no valid map, of lengths on the way
// back. Returns the energy there and fills in the certificate; nothing where the polycube stays.
std::optional<double> move_layers(const DomainEnergy& energy, const CoordinateLayers& layers,
                                  std::span<const double> best, const DomainOptions& options, SurfaceMap& map,
                                  double start_energy, Certificate& certificate, const base::Host& host) {
  constexpr int max_tries = 6;
  SurfaceMap trial(host.memory);
  trial.positions = map.positions;
  trial.triangles = map.triangles;
  trial.labels = map.labels;
  trial.polycube.resize(map.polycube.size());
  std::array<Array<double>, 3> positions{Array<double>(host.memory), Array<double>(host.memory),
                                         Array<double>(host.memory)};
  Array<double> lengths(best.begin(), best.end(), host.memory);
  for (int i = 0; i < max_tries; ++i) {
    // At the scale at which the polycube has the area that it has.
    const double scale = std::sqrt(energy.area(energy.lengths()) / energy.area(lengths));
    if (lay_out(layers, lengths, scale, positions)) {
      place_vertices(layers, positions, trial.polycube);
      CoordinateLayers now(host.memory);
      now.positions = positions;
      now.places = layers.places;
      const DomainEnergy after(trial, now, options.measure, options.area_weight, host);
      const double value = after.evaluate(after.lengths(), {});
      if (value < start_energy * (1 - min_energy_gain)) {
        certificate = certify(trial.polycube, trial.triangles, host);
        if (certificate.valid()) {
          map.polycube.swap(trial.polycube);
          return value;
        }
      }
    }
    for (std::size_t k = 0; k < lengths.size(); ++k)
      lengths[k] = std::sqrt(lengths[k] * energy.lengths()[k]);
  }
  return std::nullopt;
}

}  // namespace

OptimalDomain optimize_domain(SurfaceMap& map, const DomainOptions& options, const base::Host& host) {
  base::require(map.labels.size() == map.triangles.size() && !map.labels.empty(), "the map is not certified");
  base::require(std::isfinite(options.area_weight) && options.area_weight >= 0, "area_weight must not be negative");
  base::require(options.measure == DomainMeasure::surface_mean || options.measure == DomainMeasure::face_mean ||
                    options.measure == DomainMeasure::harmonic,
                "unknown measure");
  const AtUnitSize unit(map);
  const CoordinateLayers layers = find_layers(map, host);
  const DomainEnergy energy(map, layers, options.measure, options.area_weight, host);
  DomainMinimum minimum = minimise_domain(energy, energy.lengths(), options, host);
  OptimalDomain result(host.memory);
  result.evaluations = minimum.evaluations;
  result.converged = minimum.converged;
  result.layers = layers.layers();
  result.cells = energy.cells();
  result.crossing = energy.crossing();

  const double start_energy = energy.evaluate(energy.lengths(), {});
  const std::optional<double> reached =
      move_layers(energy, layers, minimum.lengths, options, map, start_energy, result.certificate, host);
  if (!reached) result.certificate = certify(map.polycube, map.triangles, host);
  const double final_energy = reached.value_or(start_energy);
  base::require(result.certificate.valid(), "the map is not certified");
  // What the result does not reach is not claimed.
  result.energies.push_back(start_energy);
  for (std::size_t i = 1; i < minimum.energies.size(); ++i)
    result.energies.push_back(std::clamp(minimum.energies[i], final_energy, start_energy));
  if (result.energies.back() != final_energy) result.energies.push_back(final_energy);
  result.distortion = measure_distortion(map, host);
  return result;
}

}  // namespace orbicube::polycube
