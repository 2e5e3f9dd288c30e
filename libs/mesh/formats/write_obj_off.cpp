#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {

void write_obj(OutputFile& file, const Mesh& mesh, const WriteOptions& /*options*/, const base::Host& host) {
  TextWriter out(file, mesh.positions.size() + mesh.triangles.size(), host);
  for (const Vector3& p : mesh.positions) {
    out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    out.end_item();
  }
  for (const Triangle& t : mesh.triangles) {
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    out.end_item();
  }
  out.flush();
}

void write_off(OutputFile& file, const Mesh& mesh, const WriteOptions& /*options*/, const base::Host& host) {
  TextWriter out(file, mesh.positions.size() + mesh.triangles.size(), host);
  out << "OFF\n" << std::uint64_t{mesh.positions.size()} << ' ' << std::uint64_t{mesh.triangles.size()} << " 0\n";
  write_positions_and_triangles(mesh, out);
}

}  // namespace orbicube::mesh
