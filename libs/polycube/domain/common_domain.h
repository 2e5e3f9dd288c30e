// The best proportions of a polycube that several shapes share: distances between its planes that minimize the sum of
// the energies of all their maps (the dissertation's section 4.5 with the method of 4.3).
#pragma once

#include <vector>

#include "polycube/domain/optimal_domain.h"

namespace orbicube::polycube {

struct CommonDomain {
  explicit CommonDomain(std::pmr::memory_resource* memory) : energies(memory), before(memory), after(memory) {}

  Array<double> energies;  // sums: of the maps given, and after each iteration; never rises. The last is the result's
  Array<double> before, after;  // of each map
  std::uint64_t evaluations = 0;
  bool converged = false;
  std::vector<Certificate> certificates;  // of each result, valid
  std::vector<Distortion> distortions;    // likewise
};

// Moves map.polycube of each map and nothing else; all stay maps to one polycube. The maps must be certified and to the
// very same polycube. The sum never rises; where rounding stands in the way of the optimum, what lies between it and
// the maps given. Throws Error "invalid-argument" (options, no maps, other polycubes), "cancelled".
CommonDomain optimize_domain(std::span<SurfaceMap* const> maps, const DomainOptions& options, const base::Host& host);

// The energy of a certified map by that measure.
double energy_of(const SurfaceMap& map, const DomainOptions& options, const base::Host& host);

}  // namespace orbicube::polycube
