#include "files/quad_file.h"

#include "mesh/files/file.h"
#include "mesh/files/text_writer.h"
#include "mesh/files/write.h"

namespace orbicube::cli {

void write_quads(const std::filesystem::path& path, std::span<const mesh::Vector3> positions,
                 std::span<const std::array<mesh::Index, 4>> quads, const base::Host& host) {
  const auto format = mesh::format_of_path(path);
  if (format != mesh::Format::obj && format != mesh::Format::off) {
    mesh::Mesh m(host.memory);
    m.positions.assign(positions.begin(), positions.end());
    for (const auto& [a, b, c, d] : quads) {
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
    return mesh::write_mesh(path, m, {}, host);
  }
  mesh::OutputFile file(path);
  mesh::TextWriter out(file, positions.size() + quads.size(), host);
  const bool obj = format == mesh::Format::obj;
  if (!obj) out << "OFF\n" << std::uint64_t{positions.size()} << ' ' << std::uint64_t{quads.size()} << " 0\n";
  for (const mesh::Vector3& p : positions) {
    out << (obj ? "v " : "") << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    out.end_item();
  }
  const mesh::Index first = obj ? 1 : 0;
  for (const auto& q : quads) {
    out << (obj ? 'f' : '4');
    for (const mesh::Index v : q)
      out << ' ' << v + first;
    out << '\n';
    out.end_item();
  }
  out.flush();
  file.commit();
}

}  // namespace orbicube::cli
