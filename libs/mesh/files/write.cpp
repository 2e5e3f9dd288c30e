#include "mesh/files/write.h"

#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/file.h"
#include "mesh/files/text_scanner.h"

namespace orbicube::mesh {
namespace {

void check_regions(std::size_t items, std::size_t regions, const char* one, const char* many) {
  if (regions == 0 || regions == items) return;
  throw base::Error("invalid-argument",
                    base::counted(regions, "region number") + " of " + base::counted(items, one, many));
}

void check(Format format, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  const bool has_cells = !mesh.tetrahedra.empty() || !mesh.hexahedra.empty() || !options.quads.empty();
  if (has_cells && !holds(format, Holds::cells)) {
    throw base::Error("unsupported", std::string(row_of(format).name) + " files hold surfaces only; " +
                                         format_endings(Holds::cells) + " hold tetrahedra and hexahedra");
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (v % base::items_between_reports == 0) host.report("checking", v, mesh.positions.size());
    if (!mesh.positions[v].allFinite()) {
      throw base::Error("non-finite", "the position of vertex " + std::to_string(v) + " is not finite");
    }
  }
  const auto check_indices = [&](const auto& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i % base::items_between_reports == 0) host.report("checking", i, cells.size());
      for (const Index v : cells[i]) {
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
  check_indices(options.quads);
  check_regions(mesh.triangles.size(), mesh.regions.triangles.size(), "triangle", "triangles");
  check_regions(mesh.tetrahedra.size(), mesh.regions.tetrahedra.size(), "tetrahedron", "tetrahedra");
  check_regions(mesh.hexahedra.size(), mesh.regions.hexahedra.size(), "hexahedron", "hexahedra");
  check_regions(options.quads.size(), options.quad_regions.size(), "quadrilateral", "quadrilaterals");
}

}  // namespace

void write_mesh(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options,
                const base::Host& host) {
  const auto format = format_of_path(path);
  if (!format) {
    throw base::Error("unsupported-format",
                      "the ending " + in_quotes(path.extension().string()) + " is none of " + format_endings());
  }
  check(*format, mesh, options, host);
  OutputFile file(path);
  row_of(*format).write(file, mesh, options, host);
  file.commit();
}

}  // namespace orbicube::mesh
