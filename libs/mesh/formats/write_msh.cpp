#include <limits>

#include "base/error.h"
#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {

void write_msh(OutputFile& file, const Mesh& mesh, const WriteOptions& /*options*/, const base::Host& host) {
  const std::uint64_t cells = mesh.triangles.size() + mesh.tetrahedra.size() + mesh.hexahedra.size();
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (mesh.positions.size() > most || cells > most)
    throw base::Error("unsupported", "more vertices or cells than the 32 bits of Gmsh's version 2.2 can count");
  TextWriter out(file, mesh.positions.size() + cells, host);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << std::uint64_t{mesh.positions.size()} << '\n';
  std::uint64_t number = 0;
  for (const Vector3& p : mesh.positions) {
    out << ++number << ' ' << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    out.end_item();
  }
  out << "$EndNodes\n$Elements\n" << cells << '\n';
  number = 0;
  // Two tags: no physical group, and one geometric entity of each dimension.
  const auto put = [&](const auto& items, const char* type_and_tags) {
    for (const auto& item : items) {
      out << ++number << type_and_tags;
      for (const Index v : item)
        out << ' ' << v + 1;
      out << '\n';
      out.end_item();
    }
  };
  put(mesh.triangles, " 2 2 0 1");
  put(mesh.tetrahedra, " 4 2 0 1");
  put(mesh.hexahedra, " 5 2 0 1");
  out << "$EndElements\n";
  out.flush();
}

}  // namespace orbicube::mesh
