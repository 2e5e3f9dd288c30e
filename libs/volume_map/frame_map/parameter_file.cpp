#include "volume_map/frame_map/parameter_file.h"

#include "mesh/files/file.h"
#include "mesh/files/text_writer.h"
#include "mesh/search/predicates.h"

namespace orbicube::volume_map {
namespace {

std::uint64_t number(std::size_t n) {
  return n;
}

// A field of `components` numbers a tetrahedron; write(t) writes them.
template <class Write>
void write_field(mesh::TextWriter& out, const char* name, std::size_t components, std::size_t tetrahedra,
                 const char* type, const Write& write) {
  out << name << ' ' << number(components) << ' ' << number(tetrahedra) << ' ' << type << '\n';
  for (std::size_t t = 0; t < tetrahedra; ++t) {
    write(t);
    out << '\n';
    out.end_item();
  }
}

void write_points(mesh::TextWriter& out, std::span<const Vector3> positions) {
  for (const Vector3& p : positions) {
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    out.end_item();
  }
}

}  // namespace

void write_parameter_vtk(const std::filesystem::path& path, std::span<const Vector3> positions,
                         std::span<const Tetrahedron> tetrahedra, const Parameterization& map, const base::Host& host) {
  const std::size_t count = tetrahedra.size();
  mesh::OutputFile file(path);
  mesh::TextWriter out(file, positions.size() + 8 * count, host);
  out << "# vtk DataFile Version 3.0\nparameterization\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  out << "POINTS " << number(positions.size()) << " double\n";
  write_points(out, positions);
  out << "CELLS " << number(count) << ' ' << number(5 * count) << '\n';
  for (const Tetrahedron& t : tetrahedra) {
    out << "4 " << t[0] << ' ' << t[1] << ' ' << t[2] << ' ' << t[3] << '\n';
    out.end_item();
  }
  out << "CELL_TYPES " << number(count) << '\n';
  for (std::size_t t = 0; t < count; ++t) {
    out << "10\n";
    out.end_item();
  }
  out << "CELL_DATA " << number(count) << "\nFIELD parameterization 5\n";
  const auto vectors = [&](const auto& of) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3& v = of(k);
      out << (k > 0 ? " " : "") << v[0] << ' ' << v[1] << ' ' << v[2];
    }
  };
  const auto flags = [&](std::size_t t, const Array<std::uint8_t>& of) {
    for (std::size_t k = 0; k < 4; ++k)
      out << (k > 0 ? " " : "") << static_cast<Index>(of[4 * t + k]);
  };
  write_field(out, "parameters", 12, count, "double",
              [&](std::size_t t) { vectors([&](std::size_t k) -> const Vector3& { return map.corners[t][k]; }); });
  write_field(out, "cut", 4, count, "int", [&](std::size_t t) { flags(t, map.cut); });
  write_field(out, "rotation", 4, count, "int", [&](std::size_t t) { flags(t, map.rotation); });
  write_field(out, "gap", 12, count, "double",
              [&](std::size_t t) { vectors([&](std::size_t k) -> const Vector3& { return map.gap[4 * t + k]; }); });
  write_field(out, "inverted", 1, count, "int", [&](std::size_t t) {
    const auto& c = map.corners[t];
    out << static_cast<Index>(mesh::orientation_3d(c[0], c[1], c[2], c[3]) <= 0 ? 1 : 0);
  });
  out.flush();
  file.commit();
}

void write_hexex(const std::filesystem::path& path, std::span<const Vector3> positions,
                 std::span<const Tetrahedron> tetrahedra, const Parameterization& map, const base::Host& host) {
  mesh::OutputFile file(path);
  mesh::TextWriter out(file, positions.size() + tetrahedra.size(), host);
  out << number(positions.size()) << '\n';
  write_points(out, positions);
  out << number(tetrahedra.size()) << '\n';
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    for (std::size_t k = 0; k < 4; ++k)
      out << tetrahedra[t][k] << ' ';
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3& v = map.corners[t][k];
      out << v[0] << ' ' << v[1] << ' ' << v[2] << (k < 3 ? " " : "\n");
    }
    out.end_item();
  }
  out.flush();
  file.commit();
}

}  // namespace orbicube::volume_map
