#include "solids/refined_solid.h"

#include <algorithm>
#include <string>

#include "base/counted.h"
#include "mesh/topology/conforming_tetrahedra.h"

namespace orbicube::cli {
namespace {

std::size_t leave_out_split_faces(mesh::Mesh& solid, std::size_t vertices, const base::Host& host) {
  const auto faces = mesh::sorted_faces(solid.tetrahedra, vertices, host);
  const bool with_regions = !solid.regions.triangles.empty();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
    mesh::Triangle face = solid.triangles[i];
    std::sort(face.begin(), face.end());
    const auto found = std::lower_bound(faces.begin(), faces.end(), face,
                                        [](const auto& a, const mesh::Triangle& b) { return a.corners < b; });
    if (found == faces.end() || found->corners != face) continue;
    solid.triangles[kept] = solid.triangles[i];
    if (with_regions) solid.regions.triangles[kept] = solid.regions.triangles[i];
    ++kept;
  }
  const std::size_t left_out = solid.triangles.size() - kept;
  solid.triangles.resize(kept);
  if (with_regions) solid.regions.triangles.resize(kept);
  return left_out;
}

// Of a mesh that had `vertices`; the number of its elements is that of the parents, each of which has a part.
template <class Refined>
void report(const Refined& refined, std::size_t vertices, const std::string& elements, Session& session) {
  base::Array<std::size_t> parts(session.host().memory);
  for (const mesh::Index parent : refined.parents) {
    parts.resize(std::max<std::size_t>(parts.size(), parent + std::size_t{1}));
    ++parts[parent];
  }
  const std::size_t splits = refined.positions.size() - vertices;
  const auto split =
      static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), [](std::size_t count) { return count > 1; }));
  session.figures()["splits"] = splits;
  session.figures()["split_elements"] = split;
  if (splits == 0) return;
  session.note(base::counted(splits, "vertex", "vertices") +
               " added after those of the input: " + std::to_string(split) + " of " + std::to_string(parts.size()) +
               " " + elements + " were split into " + std::to_string(split + refined.elements.size() - parts.size()));
}

}  // namespace

std::size_t split_cells(const untangle::RefinedTetrahedra& refined, mesh::Mesh& solid, const base::Host& host) {
  solid.tetrahedra = refined.elements;
  if (!solid.regions.tetrahedra.empty()) {
    const base::Array<std::int32_t> before(solid.regions.tetrahedra, host.memory);
    solid.regions.tetrahedra.clear();
    for (const mesh::Index parent : refined.parents)
      solid.regions.tetrahedra.push_back(before[parent]);
  }
  return leave_out_split_faces(solid, refined.positions.size(), host);
}

void report_splits(const untangle::RefinedTriangles& refined, std::size_t vertices, Session& session) {
  report(refined, vertices, "triangles", session);
}

void report_splits(const untangle::RefinedTetrahedra& refined, std::size_t vertices, Session& session) {
  report(refined, vertices, "tetrahedra", session);
}

}  // namespace orbicube::cli
