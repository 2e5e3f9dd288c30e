#include "solids/closed_surface.h"

#include <utility>

#include "mesh/topology/cells.h"
#include "mesh/topology/orient.h"
#include "mesh/topology/topology.h"

namespace orbicube::cli {

ClosedSurface read_closed_surface(const std::string& path, bool weld, Session& session, Keep keep) {
  InputMesh input = read_input(path, weld, session, keep);
  Json figures = {{"format", input.report.format}, {"seconds_read", input.seconds}};
  mesh::Mesh& mesh = input.mesh;
  about(path, Role::input, [&] {
    if (!mesh.tetrahedra.empty() || !mesh.hexahedra.empty()) {
      mesh::require_valid_cells(mesh, session.host());
      throw base::Error("unsupported", "a solid of cells; the sphere map takes surfaces");
    }
    mesh::Topology facts = mesh::topology(mesh.positions, mesh.triangles, session.host());
    const bool turn = facts.orientable && (facts.inconsistent_edges > 0 || facts.volume < 0);
    // The other requirements first: their refusals say more than what turning would meet.
    facts.inconsistent_edges = facts.orientable ? 0 : facts.inconsistent_edges;
    mesh::require_closed_genus_zero(facts);
    if (!turn) return;
    const mesh::OrientReport turned = mesh::orient(mesh.positions, mesh.triangles, session.host());
    if (turned.triangles_turned > 0)
      session.note(std::to_string(turned.triangles_turned) + " triangles were turned to agree with their neighbors");
    if (turned.turned_outward) session.note("the surface looked inward; all triangles were turned");
    figures["triangles_turned"] = turned.triangles_turned;
    figures["turned_outward"] = turned.turned_outward;
  });
  return {std::move(mesh), std::move(figures), std::move(input.kept)};
}

}  // namespace orbicube::cli
