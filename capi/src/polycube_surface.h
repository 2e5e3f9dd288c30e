// What a surface must be to have a polycube.
#pragma once

#include "capi/src/surface_view.h"
#include "mesh/topology/surface_check.h"
#include "mesh/topology/topology.h"

namespace orbicube::capi {

// Closed and consistently oriented, in any number of pieces.
inline mesh::Topology require_closed_surfaces(const SurfaceView& s, const base::Host& host) {
  mesh::require_valid_surface(s.positions, s.triangles, host);
  const mesh::Topology facts = mesh::topology(s.positions, s.triangles, host);
  mesh::require_closed_manifold(facts);
  if (facts.inconsistent_edges > 0)
    throw base::Error("inconsistent-orientation", "neighboring triangles are oriented differently");
  return facts;
}

inline void require_outward(double volume) {
  if (!(volume > 0)) throw base::Error("degenerate-geometry", "the surface encloses no volume or is inward-oriented");
}

// Closed, connected, consistently oriented, outward-oriented.
inline void require_one_surface(const SurfaceView& s, const base::Host& host) {
  const mesh::Topology facts = require_closed_surfaces(s, host);
  if (facts.components != 1) throw base::Error("not-connected", "the surface has more than one component");
  require_outward(facts.volume);
}

}  // namespace orbicube::capi
