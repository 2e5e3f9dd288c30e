// Maps of several shapes to one polycube made less distorted: the proportions of the polycube, the maps across its
// edges and the positions of its corners on the shapes, in turns (the dissertation's section 4.5 with the methods of
// 4.3 and 4.4). The maps stay certified and to one polycube.
#pragma once

#include <span>
#include <vector>

#include "polycube/corners/optimal_corners.h"
#include "polycube/domain/common_domain.h"

namespace orbicube::polycube {

struct CommonImprovementOptions {
  DomainOptions domain = {};  // measure and weight of the energies
  bool proportions = true;    // false: the polycube stays, to the bit
  bool corners = false;       // corners move on the shapes
  CornerMethod corner_search = CornerMethod::trust_region;
};

// Maps to one polycube, with what is known of them.
struct CommonMaps {
  explicit CommonMaps(std::pmr::memory_resource* memory) : energies(memory) {}

  std::vector<SurfaceMap> maps;
  std::vector<Certificate> certificates;  // of each, valid
  std::vector<Distortion> distortions;
  Array<double> energies;  // sums: at the start, then after each improvement; never rises
};

// Computes the best proportions, unless the polycube stays, and certificates, distortions and energies. Throws what
// optimize_domain does; "no-valid-result" for a map that is not certified.
void settle(CommonMaps& common, const CommonImprovementOptions& options, const base::Host& host);

// Smooths settled maps across edges, moves corners where that is requested, and settles them again, up to `rounds`
// times or until that gains less than a thousandth. originals[i] is the shape that shape i is a copy of, or i: copies
// keep the map of their original. Throws Error "cancelled".
void improve(CommonMaps& common, std::span<const std::size_t> originals, int rounds,
             const CommonImprovementOptions& options, const base::Host& host);

}  // namespace orbicube::polycube
