#include "solids/any_genus_surface.h"

#include <utility>

#include "correspondence/closed_surface.h"

namespace orbicube::cli {

AnyGenusSurface read_any_genus_surface(const std::string& path, const Mending& mending, Session& session, Keep keep) {
  InputMesh input = read_mended(path, mending, session, keep);
  mesh::Mesh& m = input.mesh;
  Json figures;
  base::Array<mesh::Triangle> given(m.triangles, session.host().memory);
  about(path, Role::input, [&] {
    if (!m.tetrahedra.empty() || !m.hexahedra.empty())
      throw base::Error("unsupported", "a solid of cells; polycube takes surfaces");
    std::int64_t genus = 0;
    const mesh::OrientReport turned = correspondence::orient_any_genus(m, genus, session.host());
    for (const std::string& note : turned.notes())
      session.note(note);
    figures = {{"format", input.report.format},
               {"vertices", m.positions.size()},
               {"triangles", m.triangles.size()},
               {"genus", genus}};
  });
  return {std::move(m), std::move(figures), std::move(input.kept), std::move(given)};
}

}  // namespace orbicube::cli
