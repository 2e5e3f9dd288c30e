#include "polycube/domain/common_domain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"

namespace orbicube::polycube {
namespace {

class CommonOptimization {
 public:
  CommonOptimization(std::span<SurfaceMap* const> maps, const DomainOptions& options, const base::Host& host)
      : maps_(maps), options_(options), host_(host), gradient_(host.memory), result_(host.memory) {
    for (const SurfaceMap* map : maps) {
      base::require(map != nullptr && map->labels.size() == map->triangles.size() && !map->labels.empty(),
                    "a map is not certified");
      layers_.push_back(find_layers(*map, host));
      base::require(layers_.back().positions == layers_.front().positions, "the maps are to different polycubes");
    }
    for (std::size_t i = 0; i < maps.size(); ++i)
      energies_.emplace_back(*maps[i], layers_[i], options.measure, options.area_weight, host);
    gradient_.resize(energies_.front().size());
  }

  CommonDomain run() {
    const DomainEnergy& first = energies_.front();
    DomainMinimum minimum =
        minimise_domain(LengthEnergy([&](std::span<const double> lengths, std::span<double> gradient) {
                          return sum(lengths, gradient);
                        }),
                        first.lengths(), options_, host_);
    result_.evaluations = minimum.evaluations;
    result_.converged = minimum.converged;
    for (const DomainEnergy& energy : energies_)
      result_.before.push_back(energy.evaluate(first.lengths(), {}));
    const double start = sum(first.lengths(), {});
    // What rounding makes of the optimum, or, where that is no valid map, of lengths on the way back.
    constexpr int max_tries = 6;
    double found = start;
    Array<double> lengths(minimum.lengths, host_.memory);
    for (int i = 0; i < max_tries && found == start; ++i) {
      found = try_lengths(lengths, start);
      for (std::size_t k = 0; k < lengths.size(); ++k)
        lengths[k] = std::sqrt(lengths[k] * first.lengths()[k]);
    }
    if (found == start) {
      result_.after = result_.before;
      for (const SurfaceMap* map : maps_)
        result_.certificates.push_back(certify(map->polycube, map->triangles, host_));
    }
    for (std::size_t i = 0; i < maps_.size(); ++i) {
      base::require(result_.certificates[i].valid(), "a map is not certified");
      result_.distortions.push_back(measure_distortion(*maps_[i], host_));
    }
    // What the result does not reach is not claimed.
    result_.energies.push_back(start);
    for (std::size_t i = 1; i < minimum.energies.size(); ++i)
      result_.energies.push_back(std::clamp(minimum.energies[i], found, start));
    if (result_.energies.back() != found) result_.energies.push_back(found);
    return std::move(result_);
  }

 private:
  double sum(std::span<const double> lengths, std::span<double> gradient) {
    double value = 0;
    std::fill(gradient.begin(), gradient.end(), 0.0);
    for (const DomainEnergy& energy : energies_) {
      const double own =
          energy.evaluate(lengths, gradient.empty() ? std::span<double>() : std::span<double>(gradient_));
      if (!std::isfinite(own)) return std::numeric_limits<double>::infinity();
      value += own;
      for (std::size_t i = 0; i < gradient.size(); ++i)
        gradient[i] += gradient_[i];
    }
    return value;
  }

  // The sum of the energies of the maps with these lengths, as they are rounded; `start`, with nothing changed, when
  // that is no less or a map is not valid.
  double try_lengths(std::span<const double> lengths, double start) {
    const DomainEnergy& first = energies_.front();
    std::array<Array<double>, 3> positions{Array<double>(host_.memory), Array<double>(host_.memory),
                                           Array<double>(host_.memory)};
    const double scale = std::sqrt(first.area(first.lengths()) / first.area(lengths));
    if (!lay_out(layers_.front(), lengths, scale, positions)) return start;
    std::vector<Array<Vector3>> moved;
    std::vector<Certificate> certificates;
    Array<double> after(host_.memory);
    double value = 0;
    for (std::size_t i = 0; i < maps_.size(); ++i) {
      Array<Vector3>& polycube = moved.emplace_back(maps_[i]->polycube.size(), Vector3::Zero(), host_.memory);
      place_vertices(layers_[i], positions, polycube);
      certificates.push_back(certify(polycube, maps_[i]->triangles, host_));
      if (!certificates.back().valid()) return start;
      SurfaceMap trial(host_.memory);
      trial.positions = maps_[i]->positions;
      trial.triangles = maps_[i]->triangles;
      trial.labels = maps_[i]->labels;
      trial.polycube = polycube;
      after.push_back(energy_of(trial, options_, host_));
      value += after.back();
    }
    if (!(value < start * (1 - min_energy_gain))) return start;
    for (std::size_t i = 0; i < maps_.size(); ++i)
      maps_[i]->polycube = std::move(moved[i]);  // which may be in other memory
    result_.certificates = std::move(certificates);
    result_.after = std::move(after);
    return value;
  }

  std::span<SurfaceMap* const> maps_;
  const DomainOptions& options_;
  const base::Host& host_;
  std::vector<CoordinateLayers> layers_;
  std::vector<DomainEnergy> energies_;
  Array<double> gradient_;
  CommonDomain result_;
};

void check(const DomainOptions& options) {
  base::require(std::isfinite(options.area_weight) && options.area_weight >= 0, "area_weight must not be negative");
  base::require(options.measure == DomainMeasure::surface_mean || options.measure == DomainMeasure::face_mean ||
                    options.measure == DomainMeasure::harmonic,
                "unknown measure");
}

}  // namespace

CommonDomain optimize_domain(std::span<SurfaceMap* const> maps, const DomainOptions& options, const base::Host& host) {
  check(options);
  base::require(!maps.empty(), "no maps");
  return CommonOptimization(maps, options, host).run();
}

double energy_of(const SurfaceMap& map, const DomainOptions& options, const base::Host& host) {
  check(options);
  const CoordinateLayers layers = find_layers(map, host);
  const DomainEnergy energy(map, layers, options.measure, options.area_weight, host);
  return energy.evaluate(energy.lengths(), {});
}

}  // namespace orbicube::polycube
