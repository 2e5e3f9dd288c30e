#include "files/exact_file.h"

#include <filesystem>

#include "files/surface_file.h"
#include "mesh/files/file.h"
#include "mesh/files/write.h"

namespace orbicube::cli {

void require_exact_output(const std::string& path) {
  require_writable(path);
  if (mesh::holds(path, mesh::Holds::polygons)) return;
  throw Failure(Exit::wrong_input, path, "unsupported-format",
                "this format rounds coordinates or welds vertices; these keep every bit: " +
                    mesh::format_endings(mesh::Holds::polygons));
}

void write_exactly(const std::string& path, const base::Array<mesh::Vector3>& positions,
                   const base::Array<mesh::Triangle>& triangles, bool text, Session& session) {
  about(path, Role::output, [&] {
    mesh::Mesh m(session.host().memory);
    m.positions = positions;
    m.triangles = triangles;
    const std::filesystem::path file = session.stage(path);
    mesh::write_mesh(file, m, {.binary = !text}, session.host());
    const mesh::Mesh again = mesh::read_mesh(file, {}, session.host());
    if (again.positions != positions || again.triangles != triangles)
      throw base::Error("no-valid-result", "verification failed: the written file reads back differently");
  });
}

}  // namespace orbicube::cli
