#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {

void write_medit(OutputFile& file, const Mesh& mesh, const WriteOptions& /*options*/, const base::Host& host) {
  TextWriter out(file, mesh.positions.size() + mesh.triangles.size() + mesh.tetrahedra.size() + mesh.hexahedra.size(),
                 host);
  out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << std::uint64_t{mesh.positions.size()} << '\n';
  for (const Vector3& p : mesh.positions) {
    out << p.x() << ' ' << p.y() << ' ' << p.z() << " 0\n";
    out.end_item();
  }
  const auto section = [&](const char* name, const auto& cells) {
    if (cells.empty()) return;
    out << name << '\n' << std::uint64_t{cells.size()} << '\n';
    for (const auto& cell : cells) {
      for (const Index v : cell)
        out << v + 1 << ' ';
      out << "0\n";
      out.end_item();
    }
  };
  section("Triangles", mesh.triangles);
  section("Tetrahedra", mesh.tetrahedra);
  section("Hexahedra", mesh.hexahedra);
  out << "End\n";
  out.flush();
}

}  // namespace orbicube::mesh
