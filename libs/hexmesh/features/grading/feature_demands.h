// Where the cells of a grid must be small for the feature graph to be among their edges: along short arcs, and between
// arcs that are close to each other without meeting; and along arcs that turn.
#pragma once

#include <algorithm>

#include "hexmesh/features/feature_shape.h"
#include "hexmesh/features/grading/axis_grading.h"

namespace orbicube::hexmesh {

class FeatureDemands {
 public:
  // Of gaps up to `reach` wide; arcs are straight along `straight`. Keeps a reference to the shape.
  FeatureDemands(const FeatureShape& shape, double reach, double straight, const base::Host& host);

  // Makes cells small enough: `strength` of each arc is the number of cells along it, and across to others, that it
  // requires; of two arcs with a gap between the larger counts. Cells along bends may be `wider` times as wide as
  // usual.
  void refine(std::span<const double> strength, double wider, AxisGrading& grading) const;
  // Returns the arcs that require the smallest cells, up to 1.5 times the smallest of all, ascending.
  Array<Index> most_demanding(std::span<const double> strength, const base::Host& host) const;

 private:
  struct Demand {
    Vector3 from, to;
    double size = 0;  // of one cell, for the strength 1
    Index arc = 0, other = 0;
    double max_size = 0;  // for any strength, where it is a bend

    double size_for(std::span<const double> strength) const { return size / std::max(strength[arc], strength[other]); }
  };

  void add_arc(Index arc);
  void add_turns(Index arc, double straight);
  void add_gaps(Index arc, Index other, double reach);

  const FeatureShape& shape_;
  Array<Demand> demands_;
};

}  // namespace orbicube::hexmesh
