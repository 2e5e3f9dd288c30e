// The map of a solid to a polycube: tetrahedra whose boundary is that of a polycube map of their surface. Vertices of
// the boundary slide within the patches of the polycube, nothing is inverted.
#pragma once

#include <functional>
#include <string>

#include "polycube/surface/surface_map.h"
#include "untangle/tetrahedra/newton.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

struct SolidMap {
  explicit SolidMap(std::pmr::memory_resource* memory) : source(memory), image(memory), tetrahedra(memory) {}

  Array<Vector3> source;  // those given first, then those added by splits
  Array<Vector3> image;
  Array<Tetrahedron> tetrahedra;
  double scale = 1;  // from lengths in space to lengths in the image
  std::size_t added = 0, inverted_at_start = 0, steps = 0;
  int holds = 0;  // how often part of the boundary had to be fixed to the surface map
};

// Changes a start, in which inner vertices have harmonic coordinates: the map so far has the tetrahedra in space and
// the scale; vertices that are `held` (an entry a vertex) stay.
using ChangeStart =
    std::function<void(const SolidMap& map, std::span<const std::uint8_t> held, std::span<Vector3> image)>;

struct SolidMapOptions {
  int steps = 300;                          // of Newton's method in each attempt
  int polish_steps = 60;                    // for less distortion
  untangle::BlockEngine* engine = nullptr;  // of the linear systems; none: this library's own
  ChangeStart start = {};                   // called in each attempt; may be empty
};

// `surface` is a certified map (its labels are used), `target` where its vertices are to be on the polycube: `polycube`
// itself, or the same with its planes moved in order. The boundary of the tetrahedra is the surface's triangles; its
// vertices come first among `positions`. Tetrahedra must be positive.
// Certified: every tetrahedron is positive by exact signs, and the boundary of the image is a polycube that covers
// itself once (polycube/map/certificate.h); then the map is one to one. Throws Error "no-valid-result" with what stood
// in the way, "invalid-argument" when the boundary is another, "cancelled".
SolidMap map_solid(const polycube::SurfaceMap& surface, std::span<const Vector3> target,
                   std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                   const SolidMapOptions& options, const base::Host& host);

}  // namespace orbicube::volume_map
