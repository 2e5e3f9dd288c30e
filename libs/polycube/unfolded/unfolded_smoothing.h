// An unfolded map made less distorted, with all vertices but the polycube's corners free to move across its edges.
//
// What is minimized is a weighted sum over triangles of what is reported in the end: the distortions of angles and
// areas, |J|^2 / (2 det J) + (det J + 1 / det J) / 2, each 1 for an isometry at equal areas. It is infinite for what is
// flat, so that no triangle is ever flipped. Half of the weights are areas, half the same for each triangle.
#pragma once

#include "polycube/unfolded/unfolded_map.h"

namespace orbicube::polycube {

struct SmoothingOptions {
  int newton_steps = 100;  // maximum number, of all vertices at once
  int corner_rounds = 10;  // in each of which every corner may move by an edge, or several; 0: they stay
};

// Moves vertices one by one, takes out vertices that were added to the input wherever the rest fits better without, and
// then moves all at once by Newton's method with Gauss-Newton blocks (planar_triangles.h). The map must be positive,
// and stays so. Returns how many steps of all vertices it took. Throws Error "cancelled".
int smooth_unfolded(UnfoldedMap& map, const SmoothingOptions& options, const base::Host& host);

}  // namespace orbicube::polycube
