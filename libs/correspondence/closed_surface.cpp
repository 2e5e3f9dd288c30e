#include "correspondence/closed_surface.h"

#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/topology/topology.h"

namespace orbicube::correspondence {

mesh::OrientReport orient_genus_zero(mesh::Mesh& surface, const base::Host& host) {
  mesh::Topology facts = mesh::topology(surface.positions, surface.triangles, host);
  const bool turn = facts.orientable && (facts.inconsistent_edges > 0 || facts.volume < 0);
  // The other requirements first: their refusals say more than what turning would meet.
  facts.inconsistent_edges = facts.orientable ? 0 : facts.inconsistent_edges;
  mesh::require_closed_genus_zero(facts);
  return turn ? mesh::orient(surface.positions, surface.triangles, host) : mesh::OrientReport{};
}

mesh::OrientReport orient_any_genus(mesh::Mesh& surface, std::int64_t& genus, const base::Host& host) {
  const mesh::Topology facts = mesh::topology(surface.positions, surface.triangles, host);
  mesh::require_closed_manifold(facts);
  if (facts.components > 1) throw base::Error("not-connected", base::counted(facts.components, "component"));
  if (!facts.orientable) throw base::Error("non-orientable", "no orientation of the triangles is consistent");
  genus = facts.genus.value_or(0);
  return mesh::orient(surface.positions, surface.triangles, host);
}

}  // namespace orbicube::correspondence
