// Where the cells of a grid must be small for the feature graph to be among their edges: along short arcs, and between
// arcs that are close to each other without meeting.
#pragma once

#include "hexmesh/features/feature_shape.h"
#include "hexmesh/features/grading/axis_grading.h"

namespace orbicube::hexmesh {

class FeatureDemands {
 public:
  // Of gaps up to `reach` wide. Keeps a reference to the shape.
  FeatureDemands(const FeatureShape& shape, double reach, const base::Host& host);

  // Makes cells small enough: `strength` of each arc is the number of cells along it, and across to others, that it
  // requires; of two arcs with a gap between the larger counts.
  void refine(std::span<const double> strength, AxisGrading& grading) const;

 private:
  void add_arc(Index arc);
  void add_gaps(Index arc, Index other, double reach);

  struct Demand {
    Vector3 from, to;
    double size = 0;  // of one cell, for the strength 1
    Index arc = 0, other = 0;
  };

  const FeatureShape& shape_;
  Array<Demand> demands_;
};

}  // namespace orbicube::hexmesh
