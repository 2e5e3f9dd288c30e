#include <cstdint>
#include <limits>

#include "base/error.h"
#include "mesh/files/binary_writer.h"
#include "mesh/files/float_positions.h"
#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {

void write_freesurfer(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (mesh.positions.size() > most || mesh.triangles.size() > most)
    throw base::Error("unsupported", "more vertices or triangles than FreeSurfer's 32 bits can count");
  const std::uint64_t total = mesh.positions.size() + mesh.triangles.size();
  if (options.binary) {
    require_float_resolution(mesh, "FreeSurfer", "PLY and OBJ hold them");
    BinaryWriter out(file, std::endian::big, total, host);
    out.put_text("\xFF\xFF\xFE");
    out.put_text("created by orbicube\n\n");
    out.put(static_cast<std::int32_t>(mesh.positions.size()));
    out.put(static_cast<std::int32_t>(mesh.triangles.size()));
    for (const Vector3& p : mesh.positions) {
      for (const double x : p)
        out.put(to_float(x, "FreeSurfer"));
      out.end_item();
    }
    for (const Triangle& t : mesh.triangles) {
      for (const Index v : t)
        out.put(static_cast<std::int32_t>(v));
      out.end_item();
    }
    out.flush();
    return;
  }
  TextWriter out(file, total, host);
  out << "#!ascii version of surface\n"
      << std::uint64_t{mesh.positions.size()} << ' ' << std::uint64_t{mesh.triangles.size()} << '\n';
  for (const Vector3& p : mesh.positions) {
    out << p.x() << ' ' << p.y() << ' ' << p.z() << " 0\n";
    out.end_item();
  }
  for (const Triangle& t : mesh.triangles) {
    out << t[0] << ' ' << t[1] << ' ' << t[2] << " 0\n";
    out.end_item();
  }
  out.flush();
}

}  // namespace orbicube::mesh
