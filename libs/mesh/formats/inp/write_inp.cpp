#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/inp/inp_sets.h"

namespace orbicube::mesh {
namespace {

// A set of each region but 0, of elements that are numbered from `first` on.
void write_sets(std::string_view name, std::span<const std::int32_t> regions, std::uint64_t first, TextWriter& out) {
  constexpr int numbers_in_a_line = 16;  // the most that Abaqus reads
  std::map<std::int32_t, std::vector<std::uint64_t>> elements;
  for (std::size_t i = 0; i < regions.size(); ++i)
    if (regions[i] != 0) elements[regions[i]].push_back(first + i);
  for (const auto& [region, numbers] : elements) {
    out << "*ELSET, ELSET=" << name << region << '\n';
    int in_line = 0;
    for (const std::uint64_t number : numbers) {
      out << number << (++in_line % numbers_in_a_line == 0 ? ",\n" : ", ");
      out.end_item();
    }
    if (in_line % numbers_in_a_line != 0) out << '\n';
  }
}

}  // namespace

void write_inp(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  const std::size_t faces = mesh.triangles.size() + options.quads.size();
  TextWriter out(file, mesh.positions.size() + faces + mesh.tetrahedra.size() + mesh.hexahedra.size(), host);
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
  section("TYPE=S4, ELSET=QUADRILATERALS", options.quads);
  section("TYPE=C3D4, ELSET=TETRAHEDRA", mesh.tetrahedra);
  section("TYPE=C3D8, ELSET=HEXAHEDRA", mesh.hexahedra);
  write_sets(inp_triangle_set, mesh.regions.triangles, 1, out);
  write_sets(inp_quadrilateral_set, options.quad_regions, 1 + mesh.triangles.size(), out);
  write_sets(inp_tetrahedron_set, mesh.regions.tetrahedra, 1 + faces, out);
  write_sets(inp_hexahedron_set, mesh.regions.hexahedra, 1 + faces + mesh.tetrahedra.size(), out);
  out.flush();
}

}  // namespace orbicube::mesh
