#include <limits>
#include <map>
#include <span>

#include "base/error.h"
#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

// Numbers the regions of all faces, or of all cells, from 1; 0 is among them where some have none.
std::map<std::int32_t, std::uint64_t> numbered(std::span<const std::int32_t> regions,
                                               std::span<const std::int32_t> others) {
  std::map<std::int32_t, std::uint64_t> result;
  for (const std::int32_t region : regions)
    result.try_emplace(region, 0);
  for (const std::int32_t region : others)
    result.try_emplace(region, 0);
  if (regions.empty() || others.empty()) result.try_emplace(0, 0);
  std::uint64_t count = 0;
  for (auto& [region, number] : result)
    number = ++count;
  return result;
}

}  // namespace

void write_msh(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  const std::uint64_t cells =
      mesh.triangles.size() + options.quads.size() + mesh.tetrahedra.size() + mesh.hexahedra.size();
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
  // Two tags: the physical group, which is the region, and a geometric entity, of which each region has its own, since
  // Gmsh gives groups to entities.
  const auto put = [&](const auto& items, const char* type_and_count, std::span<const std::int32_t> regions,
                       const std::map<std::int32_t, std::uint64_t>& entities) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const std::int32_t region = regions.empty() ? 0 : regions[i];
      out << ++number << type_and_count << region << ' ' << entities.at(region);
      for (const Index v : items[i])
        out << ' ' << v + 1;
      out << '\n';
      out.end_item();
    }
  };
  const auto face_entities = numbered(mesh.regions.triangles, options.quad_regions);
  put(mesh.triangles, " 2 2 ", mesh.regions.triangles, face_entities);
  put(options.quads, " 3 2 ", options.quad_regions, face_entities);
  const auto cell_entities = numbered(mesh.regions.tetrahedra, mesh.regions.hexahedra);
  put(mesh.tetrahedra, " 4 2 ", mesh.regions.tetrahedra, cell_entities);
  put(mesh.hexahedra, " 5 2 ", mesh.regions.hexahedra, cell_entities);
  out << "$EndElements\n";
  out.flush();
}

}  // namespace orbicube::mesh
