// The state of the dissertation's method: a polycube, its corner points on the surface, and the map that they
// determine.
#pragma once

#include <optional>

#include "polycube/dissertation/patch_map.h"
#include "polycube/map/certificate.h"

namespace orbicube::polycube::dissertation {

// Evaluates maps for corner points at any vertices, with one factor and the paths found before.
class PrintedMapper {
 public:
  PrintedMapper(const EditableSurface& surface, const base::Host& host);

  const EditableSurface& surface() const { return surface_; }
  const HarmonicCounts& counts() const { return system_.counts(); }

  // The paths alone.
  Drawn draw(const Layout& layout, std::span<const Index> corner_points);
  // Throws Error "no-valid-result" where the equations cannot be solved, "cancelled". `drawn` must be valid.
  PatchMap map(const Layout& layout, const Drawn& drawn);
  // The map with split edges, certified. Throws Error "no-valid-result" with the place and the number of flipped
  // triangles, or what else is wrong.
  FinishedMap finish(const Layout& layout, const Drawn& drawn, Certificate& certificate) const;

 private:
  const EditableSurface& surface_;
  const base::Host& host_;
  Array<double> weights_;
  HarmonicSystem system_;
  ShortestPaths shortest_;
};

// How a corner of the polycube is projected to the surface, which section 4.2.1 leaves to its reference.
enum class Projection { nearest, along_normal };

// For each node of the layout a vertex of the surface: the nearest one, or that of the triangle that the line through
// the corner along the mean of its rectangles' normals hits nearest to it (the nearest one where it hits none).
Array<Index> project_corners(const Layout& layout, const EditableSurface& surface, Projection projection,
                             const base::Host& host);

}  // namespace orbicube::polycube::dissertation
