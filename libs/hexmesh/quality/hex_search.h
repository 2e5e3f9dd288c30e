// The end of making hexahedra better: vertices of the boundary put onto the surface, then the worst hexahedra and at
// last all of them on average improved by trying places for their vertices.
#pragma once

#include "hexmesh/quality/hex_boundary.h"

namespace orbicube::hexmesh {

struct HexSearchOptions {
  int passes = 60;     // for the worst
  double part = 0.02;  // of the hexahedra, the worst ones
  int mean_passes = 12;
  double kept = 0.75;       // what no hexahedron is brought below for the sake of the mean
  double mean_reach = 0.1;  // how far from where they are vertices of the boundary may be tried for the mean
  double reach = 0;         // and for anything where they are fixed (hex_boundary.h)
  bool all = false;         // are fixed
};

// The worst hexahedra. Everything is judged by the scaled Jacobian and the Bernstein coefficients of whole hexahedra:
// no change makes the worst around a vertex worse, but for what puts it onto the surface before the search, which may
// lower it to 0.15; after it not below the worst of the mesh. Returns how many vertices of the boundary could not be
// put onto the surface. The same in every run. Throws Error "cancelled".
std::size_t search_hexahedra(HexMesh& mesh, const HexBoundary& boundary, const HexSearchOptions& options,
                             const base::Host& host);

// All hexahedra on average, once the worst are as good as they get: vertices move to where the sum of the scaled
// Jacobians around them is greater. Judged and returned as above; the worst around a vertex may become less good, but
// not less than `kept` nor than the worst of the mesh.
std::size_t raise_mean(HexMesh& mesh, const HexBoundary& boundary, const HexSearchOptions& options,
                       const base::Host& host);

}  // namespace orbicube::hexmesh
