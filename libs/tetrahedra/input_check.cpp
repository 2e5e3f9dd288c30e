#include "tetrahedra/input_check.h"

#include <string>

#include "base/error.h"
#include "mesh/search/intersections.h"
#include "mesh/topology/surface_check.h"
#include "mesh/topology/topology.h"

namespace orbicube::tetrahedra {

using mesh::Array;

Array<FacePair> self_intersections(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                                   const base::Host& host) {
  mesh::require_valid_surface(positions, triangles, host);
  const mesh::Topology facts = mesh::topology(positions, triangles, host);
  mesh::require_closed_manifold(facts);
  if (!facts.orientable) throw base::Error("non-orientable", "the surface has one side only, like a Klein bottle");
  if (facts.zero_area_faces > 0) {
    throw base::Error("degenerate-face", "faces without area: " + std::to_string(facts.zero_area_faces) +
                                             "; first face " + std::to_string(facts.first_zero_area_face));
  }
  return mesh::intersecting_triangles(positions, triangles, host);
}

void require_none(std::span<const FacePair> pairs) {
  if (pairs.empty()) return;
  throw base::Error("self-intersection",
                    "pairs of faces that meet where they should not: " + std::to_string(pairs.size()) +
                        "; first faces " + std::to_string(pairs[0][0]) + " and " + std::to_string(pairs[0][1]));
}

void require_fillable(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                      const base::Host& host) {
  require_none(self_intersections(positions, triangles, host));
}

}  // namespace orbicube::tetrahedra
