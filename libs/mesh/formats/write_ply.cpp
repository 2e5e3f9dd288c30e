#include <string>

#include "mesh/files/binary_writer.h"
#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

std::string header(const Mesh& mesh, bool binary) {
  return std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") + " 1.0\nelement vertex " +
         std::to_string(mesh.positions.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(mesh.triangles.size()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
}

}  // namespace

void write_ply(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  const std::uint64_t total = mesh.positions.size() + mesh.triangles.size();
  if (options.binary) {
    BinaryWriter out(file, std::endian::little, total, host);
    out.put_text(header(mesh, true));
    for (const Vector3& p : mesh.positions) {
      for (const double x : p)
        out.put(x);
      out.end_item();
    }
    for (const Triangle& t : mesh.triangles) {
      out.put(std::uint8_t{3});
      for (const Index v : t)
        out.put(v);
      out.end_item();
    }
    out.flush();
    return;
  }
  TextWriter out(file, total, host);
  out << header(mesh, false);
  write_positions_and_triangles(mesh, out);
}

}  // namespace orbicube::mesh
