// A polycube that the user has for a solid: its own map where it has the triangles of the surface, drawn otherwise.
#pragma once

#include <span>

#include "polycube/layout/given_polycube.h"
#include "polycube/map/construction.h"
#include "volume_map/input/working_space.h"

namespace orbicube::volume_map {

struct GivenPolycube {
  const polycube::TargetPolycube* target = nullptr;  // null: there is none
  std::span<const mesh::Vector3> pose = {};          // of each corner, where it is on the surface; or empty
};

// Returns a certified map of a closed, connected, outward-oriented surface to the polycube, scaled by the power of two
// that brings its area nearest to that of the surface. Where the triangles of the polycube are those of the surface, in
// one order, their vertices correspond, and `is_own` is set; otherwise the polycube is drawn on the surface
// (polycube/layout/drawn_construction.h). `space` is what the pose goes through. Throws what construct_on does.
polycube::Construction construct_given(std::span<const mesh::Vector3> positions,
                                       std::span<const mesh::Triangle> triangles, const GivenPolycube& given,
                                       const WorkingSpace& space, bool& is_own, const base::Host& host);

}  // namespace orbicube::volume_map
