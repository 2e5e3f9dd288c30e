#include "corners.h"

#ifdef ORBICUBE_BENCH_NLOPT
#include <nlopt.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <vector>

#include "bench/measuring.h"
#include "map_files.h"
#include "polycube/corners/optimal_corners.h"

namespace orbicube::bench {
namespace {

using namespace orbicube::polycube;

void row(const std::string& name, const SurfaceMap& given, CornerMethod method, const base::Host& host) {
  SurfaceMap map = given;
  const Distortion before = measure_distortion(map, host);
  const double start = cpu_seconds();
  const OptimalCorners found = optimize_corners(map, {.method = method}, host);
  const double seconds = cpu_seconds() - start;
  std::printf("%-16s %-12s %7zu %7zu %4zu %4zu %7.4f %7.4f %6.3f/%.3f %6.3f/%.3f %3zu %6lu %6.1f %6.1f\n", name.c_str(),
              method == CornerMethod::gradient ? "gradient" : "trust region", given.triangles.size(),
              map.triangles.size(), found.certificate.corners, found.movable, found.energies.front(),
              found.energies.back(), before.angle_mean, before.area_mean, found.distortion.angle_mean,
              found.distortion.area_mean, found.energies.size() - 1, static_cast<unsigned long>(found.evaluations),
              found.map_evaluations, seconds);
  std::fflush(stdout);
}

// All regions of one round: what they cost together with their corners at some positions, and the number of
// evaluations.
struct Round {
  Round(const SurfaceMap& map, const base::Host& host)
      : working(map, host), regions(RegionFinder(working, host).find_disjoint(CornerOptions().max_vertices)) {
    for (const CornerRegion& region : regions) {
      moves.emplace_back(region, working.area, CornerMoveOptions(), host);
      triangles += static_cast<double>(region.triangles.size());
      now += moves.back().energy_now();
    }
  }

  double evaluate(const double* x) {
    ++evaluations;
    double sum = 0;
    for (std::size_t k = 0; k < moves.size(); ++k) {
      const double energy = moves[k].evaluate({x[2 * k], x[2 * k + 1]}, nullptr);
      // Worse than anything.
      sum += std::isfinite(energy) ? energy : 2 * moves[k].energy_now();
    }
    return sum;
  }

  WorkingMap working;
  Array<CornerRegion> regions;
  std::deque<CornerMove> moves;
  double triangles = 0, now = 0;
  std::size_t evaluations = 0;
};

#ifdef ORBICUBE_BENCH_NLOPT
// Evaluations of the whole map until BOBYQA has the energy; `most` when it has not by then, and what it has.
std::size_t bobyqa(Round& round, double target, std::size_t most, double* reached) {
  const auto n = static_cast<unsigned>(2 * round.moves.size());
  const nlopt_opt solver = nlopt_create(NLOPT_LN_BOBYQA, n);
  const double bound = CornerMove::reach / std::sqrt(2.0);
  nlopt_set_lower_bounds1(solver, -bound);
  nlopt_set_upper_bounds1(solver, bound);
  nlopt_set_initial_step1(solver, 0.25);
  nlopt_set_xtol_abs1(solver, 1e-4);
  nlopt_set_maxeval(solver, static_cast<int>(most));
  nlopt_set_stopval(solver, target);
  nlopt_set_min_objective(
      solver, [](unsigned, const double* x, double*, void* user) { return static_cast<Round*>(user)->evaluate(x); },
      &round);
  std::vector<double> x(n, 0.0);
  round.evaluations = 0;
  nlopt_optimize(solver, x.data(), reached);
  nlopt_destroy(solver);
  return round.evaluations;
}
#endif

// One round of both methods beside NLopt on the same regions, in evaluations of the whole map.
void compare(const std::string& name, const SurfaceMap& map, const base::Host& host) {
  Round round(map, host);
  std::printf("%-16s %zu regions, %.0f of %zu triangles, energy %.6f", name.c_str(), round.regions.size(),
              round.triangles, map.triangles.size(), round.now);
  for (const CornerMethod method : {CornerMethod::trust_region, CornerMethod::gradient}) {
    const double start = cpu_seconds();
    double energy = 0, solved = 0;
    for (std::size_t k = 0; k < round.moves.size(); ++k) {
      const CornerSearch found = search_corner(round.moves[k], method, 0.25, host);
      energy += found.energy;
      solved += static_cast<double>(found.evaluations * round.regions[k].triangles.size());
    }
    std::printf("; %s %.6f in %.1f maps, %.1f s", method == CornerMethod::gradient ? "gradient" : "trust region",
                energy, solved / round.triangles, cpu_seconds() - start);
    std::fflush(stdout);
#ifdef ORBICUBE_BENCH_NLOPT
    if (method == CornerMethod::gradient) continue;
    const auto most = static_cast<std::size_t>(15 * solved / round.triangles);
    double reached = 0;
    const std::size_t needed = bobyqa(round, energy, most, &reached);
    std::printf("; BOBYQA %.6f in %zu%s", reached, needed, reached <= energy ? "" : " (not reached)");
    std::fflush(stdout);
#endif
  }
  std::printf("\n");
}

}  // namespace

void measure_corners(std::span<const std::string> files, std::size_t corners, const base::Host& host) {
  std::printf("%-16s %-12s %7s %7s %4s %4s %7s %7s %12s %12s %3s %6s %6s %6s\n", "shape", "method", "faces", "after",
              "cor.", "mov.", "start", "reached", "before", "after", "it.", "eval.", "maps", "s");
  for (const std::string& file : files) {
    try {
      const SurfaceMap map =
          file.ends_with(map_ending) ? read_map(file, host) : make_map(file, Method::automatic, corners, host);
      for (const CornerMethod method : {CornerMethod::trust_region, CornerMethod::gradient})
        row(stem_of(file), map, method, host);
      compare(stem_of(file), map, host);
    } catch (const base::Error& error) {
      std::printf("%-16s %s: %s\n", stem_of(file).c_str(), error.kind(), error.what());
    }
  }
}

}  // namespace orbicube::bench
