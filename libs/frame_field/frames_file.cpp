#include "frame_field/frames_file.h"

#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/file.h"
#include "mesh/files/text_scanner.h"
#include "mesh/files/text_writer.h"

namespace orbicube::frame_field {

void write_frames(const std::filesystem::path& path, std::span<const Quaternion> field, const base::Host& host) {
  mesh::OutputFile file(path);
  mesh::TextWriter out(file, field.size(), host);
  for (const Quaternion& q : field) {
    out << q.w << ' ' << q.x << ' ' << q.y << ' ' << q.z << '\n';
    out.end_item();
  }
  out.flush();
  file.commit();
}

Field read_frames(const std::filesystem::path& path, std::size_t count, const base::Host& host) {
  const auto bytes = mesh::read_file(path, host);
  mesh::TextScanner in(bytes, '#', host);
  in.require_room(count, 8, "frames");
  Field field(host.memory);
  field.reserve(count);
  for (; !in.at_end_of_file(); in.next_line()) {
    if (in.at_end_of_line()) continue;
    if (field.size() == count)
      in.fail("trailing-data", "more frames than the " + base::counted(count, "tetrahedron", "tetrahedra"));
    Quaternion q{in.coordinate("w"), in.coordinate("x"), in.coordinate("y"), in.coordinate("z")};
    if (!in.at_end_of_line()) in.fail("parse", "more than four numbers");
    q = quaternion::normalized(q);
    if (!(quaternion::dot(q, q) > 0.5)) in.fail("degenerate-geometry", "a frame of length 0");
    field.push_back(q);
    in.progress();
  }
  if (field.size() < count) {
    in.fail("truncated", base::counted(field.size(), "frame") + ", where there are " +
                             base::counted(count, "tetrahedron", "tetrahedra"));
  }
  return field;
}

void write_vtk(const std::filesystem::path& path, std::span<const Vector3> positions,
               std::span<const Tetrahedron> tetrahedra, std::span<const Quaternion> field, const base::Host& host) {
  const auto number = [](std::size_t n) { return static_cast<std::uint64_t>(n); };
  mesh::OutputFile file(path);
  mesh::TextWriter out(file, positions.size() + 5 * tetrahedra.size(), host);
  out << "# vtk DataFile Version 3.0\nframe field\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  out << "POINTS " << number(positions.size()) << " double\n";
  for (const Vector3& p : positions) {
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    out.end_item();
  }
  out << "CELLS " << number(tetrahedra.size()) << ' ' << number(5 * tetrahedra.size()) << '\n';
  for (const Tetrahedron& t : tetrahedra) {
    out << "4 " << t[0] << ' ' << t[1] << ' ' << t[2] << ' ' << t[3] << '\n';
    out.end_item();
  }
  out << "CELL_TYPES " << number(tetrahedra.size()) << '\n';
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    out << "10\n";
    out.end_item();
  }
  out << "CELL_DATA " << number(tetrahedra.size()) << '\n';
  const std::array<Vector, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t k = 0; k < 3; ++k) {
    out << "VECTORS axis_" << number(k + 1) << " double\n";
    for (const Quaternion& q : field) {
      const Vector v = quaternion::rotate(q, axes[k]);
      out << v.x << ' ' << v.y << ' ' << v.z << '\n';
      out.end_item();
    }
  }
  out.flush();
  file.commit();
}

}  // namespace orbicube::frame_field
