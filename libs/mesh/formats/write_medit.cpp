#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {

void write_medit(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  TextWriter out(file,
                 mesh.positions.size() + mesh.triangles.size() + options.quads.size() + mesh.tetrahedra.size() +
                     mesh.hexahedra.size(),
                 host);
  out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << std::uint64_t{mesh.positions.size()} << '\n';
  for (const Vector3& p : mesh.positions) {
    out << p.x() << ' ' << p.y() << ' ' << p.z() << " 0\n";
    out.end_item();
  }
  const auto section = [&](const char* name, const auto& cells, std::span<const std::int32_t> regions) {
    if (cells.empty()) return;
    out << name << '\n' << std::uint64_t{cells.size()} << '\n';
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (const Index v : cells[i])
        out << v + 1 << ' ';
      out << (regions.empty() ? 0 : regions[i]) << '\n';
      out.end_item();
    }
  };
  section("Triangles", mesh.triangles, mesh.regions.triangles);
  section("Quadrilaterals", options.quads, options.quad_regions);
  section("Tetrahedra", mesh.tetrahedra, mesh.regions.tetrahedra);
  section("Hexahedra", mesh.hexahedra, mesh.regions.hexahedra);
  out << "End\n";
  out.flush();
}

}  // namespace orbicube::mesh
