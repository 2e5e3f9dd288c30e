#include "domain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "bench/measuring.h"
#include "map_files.h"
#include "polycube/domain/optimal_domain.h"

namespace orbicube::bench {
namespace {

using namespace orbicube::polycube;

// How far apart the energies are that are reached from other starts, and how many starts there were.
struct Spread {
  double most = 0;
  int starts = 0;
};

Spread spread_of(const DomainEnergy& energy, const DomainMinimum& minimum, const DomainOptions& options,
                 const base::Host& host) {
  Spread result;
  std::mt19937_64 random(7);
  for (int i = 0; i < 40 && result.starts < 8; ++i) {
    // Farther and farther less, until no triangle is flipped.
    const double most = std::log(3.0) * std::pow(0.8, i / 2);
    std::uniform_real_distribution<double> exponent(-most, most);
    std::vector<double> start(energy.lengths().begin(), energy.lengths().end());
    for (double& length : start)
      length *= std::exp(exponent(random));
    if (!std::isfinite(energy.evaluate(start, {}))) continue;
    ++result.starts;
    const DomainMinimum other = minimise_domain(energy, start, options, host);
    result.most = std::max(result.most, std::abs(other.energies.back() / minimum.energies.back() - 1));
  }
  return result;
}

void row(const std::string& name, const SurfaceMap& map, const base::Host& host) {
  constexpr std::array<const char*, 3> names = {"surface", "faces", "harmonic"};
  for (const DomainMeasure measure : {DomainMeasure::surface_mean, DomainMeasure::face_mean, DomainMeasure::harmonic}) {
    double start = cpu_seconds();
    const CoordinateLayers layers = find_layers(map, host);
    const DomainEnergy energy(map, layers, measure, 1, host);
    const double sums = cpu_seconds() - start;
    DomainOptions options{.measure = measure};
    start = cpu_seconds();
    const DomainMinimum minimum = minimise_domain(energy, energy.lengths(), options, host);
    const double solved = cpu_seconds() - start;
    const Spread spread = spread_of(energy, minimum, options, host);
    options.variables = DomainVariables::lengths;
    const DomainMinimum by_lengths = minimise_domain(energy, energy.lengths(), options, host);
    SurfaceMap best = map;
    const Distortion before = measure_distortion(map, host);
    options.variables = DomainVariables::logarithms;
    start = cpu_seconds();
    const OptimalDomain found = optimize_domain(best, options, host);
    const double all = cpu_seconds() - start;
    std::printf(
        "%-16s %-8s %7zu %4zu %4zu %5zu %6zu %7.4f %7.4f %7.4f %6.3f/%.3f %6.3f/%.3f %4lu %5lu %5.0f %5.0f %5.0f %8.1e "
        "(%d)\n",
        name.c_str(), names[static_cast<std::size_t>(measure)], map.triangles.size(), found.certificate.corners,
        found.layers, found.cells, found.crossing, found.energies.front(), minimum.energies.back(),
        found.energies.back(), before.angle_mean, before.area_mean, found.distortion.angle_mean,
        found.distortion.area_mean, static_cast<unsigned long>(minimum.evaluations),
        static_cast<unsigned long>(by_lengths.evaluations), 1e3 * sums, 1e3 * solved, 1e3 * (all - sums - solved),
        spread.most, spread.starts);
    std::fflush(stdout);
  }
}

}  // namespace

void measure_domains(std::span<const std::string> files, std::size_t corners, const base::Host& host) {
  std::printf(
      "l, v: by labels, grid-based; angle/area: means over triangles, before and after; eval.: evaluations, in "
      "logarithms of lengths and in lengths;"
      "\nms of the processor: sums, minimum, certificate and the rest; spread: of the energies from other starts\n"
      "%-16s %-8s %7s %4s %4s %5s %6s %7s %7s %7s %12s %12s %4s %5s %5s %5s %5s %8s\n",
      "shape", "mean", "faces", "cor.", "lay.", "cells", "across", "start", "minimum", "reached", "before", "after",
      "eval", "(len)", "sums", "min.", "rest", "spread");
  for (const std::string& file : files) {
    const std::string stem = stem_of(file);
    for (const bool grid_based : {false, true}) {
      const bool is_map = file.ends_with(map_ending);
      if (is_map && grid_based) continue;
      try {
        if (is_map)
          row(stem, read_map(file, host), host);
        else
          row(stem + (grid_based ? ", v" : ", l"),
              make_map(file, grid_based ? Method::voxels : Method::labels, corners, host), host);
      } catch (const base::Error& error) {
        std::printf("%-16s %s: %s\n", stem.c_str(), error.kind(), error.what());
      }
    }
  }
}

}  // namespace orbicube::bench
