// The best place for one corner, the others staying: with our derivative-free trust region, or with gradients.
#pragma once

#include <cstdint>

#include "polycube/corners/corner_move.h"

namespace orbicube::polycube {

enum class CornerMethod : std::int32_t {
  trust_region = 0,  // values alone, as the dissertation's section 4.4.2
  gradient = 1,      // projected gradients, with what corner_move.h knows of the derivative
};

struct CornerSearch {
  Vector2d at = Vector2d::Zero();
  double energy = 0;  // there; the region's as it is when nothing better was found
  std::uint64_t evaluations = 0;
  bool improved = false;  // then `move` is as that evaluation left it
};

// `step` is the first radius, in parts of the largest circle around the corner within the region.
CornerSearch search_corner(CornerMove& move, CornerMethod method, double step, const base::Host& host);

}  // namespace orbicube::polycube
