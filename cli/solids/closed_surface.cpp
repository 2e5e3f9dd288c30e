#include "solids/closed_surface.h"

#include <utility>

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
    if (turned.reversed_triangles == 0 && !turned.inward_oriented) return;
    for (const std::string& note : turned.notes())
      session.note(note);
    figures["reversed_triangles"] = turned.reversed_triangles;
    figures["inward_oriented"] = turned.inward_oriented;
  });
  return {std::move(mesh), std::move(figures), std::move(input.kept), std::move(given)};
}

}  // namespace orbicube::cli
