// Tied maps made positive, and then less distorted: all variables of a tied map move at once, patches, arcs and insides
// together, by the library `untangle`. The steps are Gauss-Newton's.
#pragma once

#include "polycube/map/tied_map.h"
#include "untangle/triangles/planar_newton.h"

namespace orbicube::polycube {

struct UntanglingLimits {
  int steps = 150;         // of Gauss-Newton until every triangle is positive
  double first_eps = 0;    // 0: from the worst determinant
  double area_weight = 1;  // lambda: how much changes of area count beside those of angles
};

class Untangling {
 public:
  Untangling(TiedMap& map, const base::Host& host);

  // Whether every triangle is positive, in floating point, at the end.
  bool untangle(const UntanglingLimits& limits);

  // Lowers the energy of a positive map in at most the given number of steps, and keeps it positive.
  void polish(int steps, double area_weight);

  std::size_t flipped() const { return newton_.flipped(); }
  // Of Gauss-Newton, by both.
  std::size_t steps_taken() const { return newton_.steps(); }

 private:
  TiedMap& map_;
  untangle::PlanarTriangles triangles_;
  untangle::PlanarNewton newton_;
};

}  // namespace orbicube::polycube
