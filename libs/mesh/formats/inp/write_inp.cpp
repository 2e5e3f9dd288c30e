#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {

void write_inp(OutputFile& file, const Mesh& mesh, const WriteOptions& /*options*/, const base::Host& host) {
  TextWriter out(file, mesh.positions.size() + mesh.triangles.size() + mesh.tetrahedra.size() + mesh.hexahedra.size(),
                 host);
  out << "*NODE\n";
  std::uint64_t number = 0;
  for (const Vector3& p : mesh.positions) {
    out << ++number << ", " << p.x() << ", " << p.y() << ", " << p.z() << '\n';
    out.end_item();
  }
  number = 0;
  const auto section = [&](const char* type_and_set, const auto& cells) {
    if (cells.empty()) return;
    out << "*ELEMENT, " << type_and_set << '\n';
    for (const auto& cell : cells) {
      out << ++number;
      for (const Index v : cell)
        out << ", " << std::uint64_t{v} + 1;
      out << '\n';
      out.end_item();
    }
  };
  section("TYPE=S3, ELSET=TRIANGLES", mesh.triangles);
  section("TYPE=C3D4, ELSET=TETRAHEDRA", mesh.tetrahedra);
  section("TYPE=C3D8, ELSET=HEXAHEDRA", mesh.hexahedra);
  out.flush();
}

}  // namespace orbicube::mesh
