// The minimum-distortion map to a polycube as it is: what of the surface goes to its corners and edges moves (the
// dissertation's section 4.4), and everything in between with it.
//
// A round moves each corner in its own region to where the region's distortion is least (corner_search.h), draws the
// edges there again (corner_cut.h), takes out vertices that were added for edges and are in their faces now, and then
// smooths the whole map. With the best proportions of the polycube in turn, that is the dissertation's Algorithm 3.
#pragma once

#include "polycube/corners/corner_search.h"
#include "polycube/domain/optimal_domain.h"
#include "polycube/map/certificate.h"
#include "polycube/surface/distortion.h"

namespace orbicube::polycube {

struct CornerOptions {
  CornerMethod method = CornerMethod::trust_region;
  double area_weight = 1;          // of areas beside angles, not negative
  bool domain = false;             // before each round the best proportions (the dissertation's Algorithm 3)
  int rounds = 6;                  // maximum number
  double min_gain = 1e-3;          // of what the energy exceeds that of an isometry by, in a round
  std::size_t max_vertices = 500;  // of a region
  int smoothing_steps = 2;         // of the whole map, after each round
};

struct OptimalCorners {
  explicit OptimalCorners(std::pmr::memory_resource* memory) : energies(memory), certificate(memory) {}

  // Of the map given, and after each round (with `domain`, after the best proportions and after the corners): those of
  // DomainMeasure::surface_mean. Never rises.
  Array<double> energies;
  std::uint64_t evaluations = 0;  // of a region
  double map_evaluations = 0;     // the same in maps: triangles that were solved, over those of the map
  std::size_t moves = 0;          // of corners, over all rounds
  std::size_t movable = 0;        // corners with room for a region, in the first round
  bool converged = false;
  Certificate certificate;  // of the result, valid
  Distortion distortion;    // of the result
};

// Lowers the distortion of a positive map with its corners and the edges of its polycube where they are; steps and
// least area as in CornerMoveOptions. Triangles stay positive, exactly.
void smooth_map(WorkingMap& map, double area_weight, double min_area, int steps, const base::Host& host);

// The map must be certified; it is certified again, and refined where edges of the polycube are now. Without `domain`
// the polycube stays. The energy never rises; the map is as it was, to the bit, when nothing better is found. Throws
// Error "invalid-argument" (options; a map that is not certified), "cancelled".
OptimalCorners optimize_corners(SurfaceMap& map, const CornerOptions& options, const base::Host& host);

}  // namespace orbicube::polycube
