#include "solids/closed_surface.h"

#include <utility>

#include "base/counted.h"
#include "correspondence/closed_surface.h"
#include "mesh/topology/cells.h"

namespace orbicube::cli {

ClosedSurface read_closed_surface(const std::string& path, const Mending& mending, Session& session, Keep keep) {
  InputMesh input = read_mended(path, mending, session, keep);
  Json figures = {{"format", input.report.format}, {"seconds_read", input.seconds}};
  mesh::Mesh& mesh = input.mesh;
  base::Array<mesh::Triangle> given(mesh.triangles, session.host().memory);
  about(path, Role::input, [&] {
    if (!mesh.tetrahedra.empty() || !mesh.hexahedra.empty()) {
      mesh::require_valid_cells(mesh, session.host());
      throw base::Error("unsupported", "a solid of cells; the sphere map takes surfaces");
    }
    const mesh::OrientReport turned = correspondence::orient_genus_zero(mesh, session.host());
    if (turned.triangles_turned == 0 && !turned.turned_outward) return;
    if (turned.triangles_turned > 0)
      session.note(base::counted(turned.triangles_turned, "triangle was", "triangles were") +
                   " turned to agree with their neighbors");
    if (turned.turned_outward) session.note("the surface looked inward; all triangles were turned");
    figures["triangles_turned"] = turned.triangles_turned;
    figures["turned_outward"] = turned.turned_outward;
  });
  return {std::move(mesh), std::move(figures), std::move(input.kept), std::move(given)};
}

}  // namespace orbicube::cli
