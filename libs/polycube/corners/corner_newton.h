// Newton's method on the triangles of a part of a map, unfolded around a corner: constants of the search for corners.
#pragma once

#include "untangle/triangles/planar_newton.h"

namespace orbicube::polycube {

constexpr untangle::PlanarNewtonOptions corner_newton = {
    .phase = "corners", .max_trials = 25, .max_doublings = 0, .left_product_first = false};

// Regions are small and hardly flipped: eps falls fast, and the search goes elsewhere where that is not enough.
inline untangle::PlanarSchedule corner_schedule(int steps, double area_weight) {
  return {.max_steps = steps, .area_weight = area_weight, .steps_an_eps = 4, .fall = 0.4, .patience = steps};
}

}  // namespace orbicube::polycube
