// The map of a whole surface from the map of a coarse one made of some of its triangles (label_trials.h): labels go
// back with the vertices, and the map is made again where the surface is coarse and brought to all vertices.
#pragma once

#include "polycube/labels/label_trials.h"

namespace orbicube::polycube {

struct WholeSurface {
  std::span<const Vector3> positions;  // in space
  std::span<const Triangle> triangles;
  const Frame& frame;
  const Surface& fine;  // in the frame
  const SearchSurface& search;
};

// Fills in the map, its certificate and its distortion; takes the candidate's map where the coarse surface is the whole
// one. Returns why there is none, or nothing. Throws Error "no-valid-result", "cancelled".
std::string map_whole_surface(const WholeSurface& surface, LabelCandidate& candidate, std::uint64_t seed,
                              Construction& result, const base::Host& host);

}  // namespace orbicube::polycube
