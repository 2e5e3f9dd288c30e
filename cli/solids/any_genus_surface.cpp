#include "solids/any_genus_surface.h"

#include <utility>

#include "mesh/topology/orient.h"
#include "mesh/topology/topology.h"

namespace orbicube::cli {

AnyGenusSurface read_any_genus_surface(const std::string& path, bool weld, Session& session, Keep keep) {
  InputMesh input = read_input(path, weld, session, keep);
  mesh::Mesh& m = input.mesh;
  Json figures;
  about(path, Role::input, [&] {
    if (!m.tetrahedra.empty() || !m.hexahedra.empty())
      throw base::Error("unsupported", "a solid of cells; polycube takes surfaces");
    const mesh::Topology facts = mesh::topology(m.positions, m.triangles, session.host());
    mesh::require_closed_manifold(facts);
    if (facts.components > 1) throw base::Error("not-connected", std::to_string(facts.components) + " components");
    if (!facts.orientable) throw base::Error("non-orientable", "no orientation of the triangles is consistent");
    const mesh::OrientReport turned = mesh::orient(m.positions, m.triangles, session.host());
    if (turned.triangles_turned > 0)
      session.note(std::to_string(turned.triangles_turned) + " triangles were turned to agree with their neighbors");
    if (turned.turned_outward) session.note("the surface looked inward; all triangles were turned");
    figures = {{"format", input.report.format},
               {"vertices", m.positions.size()},
               {"triangles", m.triangles.size()},
               {"genus", facts.genus.value_or(0)}};
  });
  return {std::move(m), std::move(figures), std::move(input.kept)};
}

}  // namespace orbicube::cli
