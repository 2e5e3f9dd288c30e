#include "mesh/write.h"

#include <string>

#include "base/error.h"
#include "mesh/file.h"
#include "mesh/text_scanner.h"
#include "mesh/writers.h"

namespace orbicube::mesh {
namespace {

void check(Format format, const Mesh& mesh) {
  const bool has_cells = !mesh.tetrahedra.empty() || !mesh.hexahedra.empty();
  if (has_cells && format != Format::medit && format != Format::vtk) {
    throw base::Error("unsupported", std::string(format_name(format)) +
                                         " files hold surfaces only; .mesh and .vtk hold tetrahedra and hexahedra");
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!mesh.positions[v].allFinite()) {
      throw base::Error("non-finite", "the position of vertex " + std::to_string(v) + " is not finite");
    }
  }
  const auto check_indices = [&](const auto& cells) {
    for (const auto& cell : cells) {
      for (const Index v : cell) {
        if (v >= mesh.positions.size()) {
          throw base::Error("invalid-argument",
                            "a cell has vertex " + std::to_string(v) + " of " + std::to_string(mesh.positions.size()));
        }
      }
    }
  };
  check_indices(mesh.triangles);
  check_indices(mesh.tetrahedra);
  check_indices(mesh.hexahedra);
}

}  // namespace

void write_mesh(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options,
                const base::Host& host) {
  const auto format = format_of_path(path);
  if (!format) {
    throw base::Error("unsupported-format", "the ending " + in_quotes(path.extension().string()) +
                                                " is none of .obj .off .ply .stl .mesh .vtk");
  }
  check(*format, mesh);
  OutputFile file(path);
  switch (*format) {
    case Format::obj:
      write_obj(file, mesh, host);
      break;
    case Format::off:
      write_off(file, mesh, host);
      break;
    case Format::ply:
      write_ply(file, mesh, options.binary, host);
      break;
    case Format::stl:
      write_stl(file, mesh, options.binary, host);
      break;
    case Format::medit:
      write_medit(file, mesh, host);
      break;
    case Format::vtk:
      write_vtk(file, mesh, options.binary, host);
      break;
  }
  file.commit();
}

}  // namespace orbicube::mesh
