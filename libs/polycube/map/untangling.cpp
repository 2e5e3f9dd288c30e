#include "polycube/map/untangling.h"

namespace orbicube::polycube {

Untangling::Untangling(TiedMap& map, const base::Host& host)
    : map_(map),
      triangles_(triangles_of(map, host)),
      newton_(triangles_, map.value.size(), {.phase = "map", .shift = 1e-10}, host) {}

bool Untangling::untangle(const UntanglingLimits& limits) {
  return newton_.untangle(
      map_.value, {.max_steps = limits.steps, .area_weight = limits.area_weight, .first_eps = limits.first_eps});
}

void Untangling::polish(int steps, double area_weight) {
  constexpr double little = 1e-5;
  newton_.polish(map_.value, steps, little, area_weight);
  newton_.min_determinant(map_.value);
}

}  // namespace orbicube::polycube
