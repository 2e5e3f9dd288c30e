// A certified map to a polycube made less distorted: vertices move across edges of the polycube (unfolded_smoothing.h),
// edges are cut again where they then run (polycube_edges.h), and the polycube takes the best proportions
// (optimal_domain.h), in turns.
#pragma once

#include <span>

#include "polycube/map/certificate.h"
#include "polycube/surface/distortion.h"

namespace orbicube::polycube {

struct ImprovementOptions {
  int rounds = 8;        // maximum number
  int newton_steps = 0;  // of all vertices at once, in all rounds; 0: as many as the count of triangles allows
  bool domain = true;    // false: the polycube stays, to the bit
  std::span<const Vector3> held_corners = {};  // places on the polycube; what is mapped there stays
};

// The map is certified, and so is the result; it has corners and faces of the same kind in the same order of planes.
// Returns the distortion of the result, whose means over triangles do not add up to more than before; without `domain`
// these means and those over the surface together.
// Throws Error "cancelled".
Distortion improve_map(SurfaceMap& map, Certificate& certificate, const ImprovementOptions& options,
                       const base::Host& host);

}  // namespace orbicube::polycube
