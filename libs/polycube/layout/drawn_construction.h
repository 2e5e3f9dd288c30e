// A map of a surface to a polycube that is given: its layout is drawn on the surface and mapped, as the
// grid-based construction does with its own polycubes. What says where to draw is the polycube's pose, a map of a
// similar shape, or points of the surface that belong to corners.
#pragma once

#include "polycube/labels/label_construction.h"
#include "polycube/layout/given_polycube.h"
#include "polycube/layout/scattered_map.h"

namespace orbicube::polycube {

// A corner of the polycube and the point of the surface that is to be mapped to it.
struct CornerPlace {
  Index corner;
  Vector3 point;            // the nearest point of the surface counts, unless
  Index vertex = no_index;  // this vertex is meant
};

struct DrawingOptions {
  std::span<const CornerPlace> places = {};  // of some corners, or none
  // Where corners were on a surface that the polycube is known from: one a corner; may be empty.
  std::span<const Vector3> pose = {};
  // A certified map of a similar shape to this very polycube, to be followed, or null.
  const SurfaceMap* model = nullptr;
  // From the space of the model to that of the surface, or null: its box to the surface's box.
  const ScatteredMap* from_model = nullptr;
  // Times that it is drawn again, along where the arcs of the last map have come to lie, as long as that gains.
  int redrawings = 3;
  // Maximum number of times that the map is then smoothed across edges (map_improvement.h). Corners with places stay
  // there.
  int smoothing_rounds = 3;
};

// Of a closed, connected, oriented surface that is outward-oriented. Positions of the result are on the very polycube
// of the target. Throws Error "wrong-genus" when the surface has another genus than the polycube, "invalid-argument"
// for places that do not exist or are given twice, "no-valid-result" with what stood in the way, "not-closed",
// "cancelled".
Construction construct_on(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                          const PatchGraph& target, std::int64_t target_genus, const DrawingOptions& options,
                          const base::Host& host);

}  // namespace orbicube::polycube
