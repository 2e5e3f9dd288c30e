// What becomes of the sharp edges of a surface in a mesh: options and figures that hexmesh.h has.
#pragma once

#include <string>
#include <vector>

#include "hexmesh/types.h"

namespace orbicube::hexmesh {

// Which edges of the surface are features, that chains of edges of the mesh should follow: none; those of the feature
// angle and, of tagged ones, those at which the surface turns more than beside them; all tagged ones and no others;
// those of the feature angle alone; as automatic for machined parts or sharp lines (machined_shape.h) and where edges
// are tagged, else none.
enum class Features : std::int32_t { off = 0, automatic = 1, tags = 2, angles = 3, machined = 4 };

// A curve or a corner of the surface that the mesh does not have.
struct MissingFeature {
  bool corner = false;                                   // otherwise a curve
  Index number = 0;                                      // among the curves or corners
  Vector3 from = Vector3::Zero(), to = Vector3::Zero();  // its ends
  double captured = 0;                                   // of its length, that edges of the mesh follow
  std::string why;
};

struct FeatureFigures {
  std::size_t curves = 0, corners = 0;  // of the feature graph: arcs, and vertices where they end, branch or bend
  double captured = 1;                  // of the length of the curves, that edges of the mesh follow
  // The largest scaled Jacobian that hexahedra at the corners and along the curves can have where each sector between
  // two curves has two of them.
  double bound = 1;
  bool replaced = false;  // whether the mesh is the one with the embedded graph, not that of the method
  std::vector<MissingFeature> missing;

  std::size_t missing_curves() const;
  std::size_t missing_corners() const { return missing.size() - missing_curves(); }
};

// "2 of 30 curves and 1 of 12 corners are missing; curve 7 from (x, y, z) to (x, y, z), 40 % captured: why", with the
// first `most` of them. Empty where none is missing.
std::string missing_text(const FeatureFigures& figures, std::size_t most);

}  // namespace orbicube::hexmesh
