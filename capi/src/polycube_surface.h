// What a surface must be to have a polycube.
#pragma once

#include "capi/src/surface_view.h"
#include "mesh/surface_check.h"
#include "mesh/topology.h"

namespace orbicube::capi {

// Closed, connected, consistently oriented, looking outward.
inline void require_one_surface(const SurfaceView& s, const base::Host& host) {
  mesh::require_valid_surface(s.positions, s.triangles, host);
  const mesh::Topology facts = mesh::topology(s.positions, s.triangles, host);
  mesh::require_closed_manifold(facts);
  if (facts.components != 1) throw base::Error("not-connected", "the surface has more than one component");
  if (facts.inconsistent_edges > 0)
    throw base::Error("inconsistent-orientation", "neighbouring triangles are oriented differently");
  if (!(facts.volume > 0)) throw base::Error("degenerate-geometry", "the surface encloses no volume or looks inward");
}

}  // namespace orbicube::capi
