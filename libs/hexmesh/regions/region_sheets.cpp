#include "hexmesh/regions/region_sheets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "hexmesh/features/pillowing.h"

namespace orbicube::hexmesh {
namespace {

// Whether three regions share a vertex.
bool three_meet(const HexMesh& mesh, const Array<Index>& labels, const base::Host& host) {
  Array<std::array<Index, 2>> met(mesh.positions.size(), {no_index, no_index}, host.memory);
  for (std::size_t i = 0; i < mesh.hexahedra.size(); ++i) {
    for (const Index v : mesh.hexahedra[i]) {
      auto& [a, b] = met[v];
      if (a == no_index || a == labels[i])
        a = labels[i];
      else if (b == no_index || b == labels[i])
        b = labels[i];
      else
        return true;
    }
  }
  return false;
}

// Labels with 0 for regions that no sheet is for: none of their hexahedra has two faces towards the same other region,
// which would be one plane then.
Array<Index> with_bent_faces(const HexMesh& mesh, const Array<Index>& labels, const base::Host& host) {
  Array<std::pair<Index, Index>> sides(host.memory);  // of hexahedra and labels beyond
  for (const HexFace& face : faces_of(mesh.hexahedra, mesh.positions.size(), {}, host)) {
    if (face.second == no_index || labels[face.first] == labels[face.second]) continue;
    sides.emplace_back(face.first, labels[face.second]);
    sides.emplace_back(face.second, labels[face.first]);
  }
  std::sort(sides.begin(), sides.end());
  Array<std::uint8_t> bent(1 + std::size_t{*std::max_element(labels.begin(), labels.end())}, 0, host.memory);
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i] == sides[i - 1]) bent[labels[sides[i].first]] = 1;
  Array<Index> result(labels, host.memory);
  for (Index& label : result)
    if (bent[label] == 0) label = 0;
  return result;
}

// Patches of the boundary that a region goes on along with an angle near 180 degrees beyond the curve where another one
// begins, of which one hexahedron has both faces: a sheet has to cover both. Pairs of label and patch.
std::set<std::pair<Index, Index>> flat_patches(const HexMesh& mesh, const Array<Index>& labels,
                                               const BoundaryLines& lines, RegionInterfaces& interfaces,
                                               const base::Host& host) {
  constexpr double flat = 0.5;  // cosine of the angle between normals
  std::set<std::pair<Index, Index>> patches;
  Array<HexFace> faces = faces_of(mesh.hexahedra, mesh.positions.size(), {}, host);
  std::map<Index, std::vector<std::pair<Quad, Index>>> between;  // of hexahedra: faces, and labels beyond
  for (const HexFace& face : faces) {
    if (face.second == no_index || labels[face.first] == labels[face.second]) continue;
    between[face.first].push_back({face.quad, labels[face.second]});
    between[face.second].push_back({face.quad, labels[face.first]});
  }
  for (const HexFace& face : faces) {
    if (face.second != no_index || !between.contains(face.first)) continue;
    const Index label = labels[face.first];
    for (const auto& [quad, other] : between[face.first]) {
      Vector3 middle = Vector3::Zero();
      int shared = 0;
      for (const Index v : quad) {
        if (std::find(face.quad.begin(), face.quad.end(), v) == face.quad.end()) continue;
        middle += mesh.positions[v];
        ++shared;
      }
      if (shared != 2) continue;  // no edge of both
      middle /= 2;
      const LabelSet both = label < other ? LabelSet{label, other} : LabelSet{other, label};
      const Vector3 inner = interfaces.nearest(both, middle, Vector3::Zero()).direction * (label < other ? -1 : 1);
      const Vector3 outer = (mesh.positions[face.quad[2]] - mesh.positions[face.quad[0]])
                                .cross(mesh.positions[face.quad[3]] - mesh.positions[face.quad[1]])
                                .normalized();
      if (inner.dot(outer) > flat) patches.insert({label, lines.patch_of(face.quad)});
    }
  }
  return patches;
}

// Rings around the sheets of each label towards each other one.
void add_rings(HexMesh& mesh, Array<Index>& labels, const Sheets& sheets, const base::Host& host) {
  std::map<std::pair<Index, Index>, Index> number;  // of the label and that beyond
  Array<Index> groups(mesh.hexahedra.size(), 0, host.memory), label_of_group(1, 0, host.memory);
  const auto put = [&](Index hexahedron, Index beyond) {
    const auto [at, added] =
        number.try_emplace({labels[hexahedron], labels[beyond]}, static_cast<Index>(label_of_group.size()));
    if (added) label_of_group.push_back(labels[hexahedron]);
    groups[hexahedron] = at->second;
  };
  for (const HexFace& face : faces_of(mesh.hexahedra, mesh.positions.size(), {}, host)) {
    if (face.second == no_index || labels[face.first] == labels[face.second]) continue;
    if (face.first >= sheets.first) put(face.first, face.second);
    if (face.second >= sheets.first) put(face.second, face.first);
  }
  pillow(mesh, groups, host);
  for (std::size_t i = sheets.second; i < groups.size(); ++i)
    labels.push_back(label_of_group[groups[i]]);
}

}  // namespace

Sheets add_sheets(HexMesh& mesh, Array<Index>& labels, const BoundaryLines& lines, RegionInterfaces& interfaces,
                  const base::Host& host) {
  Sheets sheets;
  sheets.first = mesh.hexahedra.size();
  const auto flat = flat_patches(mesh, labels, lines, interfaces, host);
  Array<Index> sides = with_bent_faces(mesh, labels, host);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (std::any_of(flat.begin(), flat.end(), [&](const auto& pair) { return pair.first == labels[i]; }))
      sides[i] = labels[i];
  }
  const IsCovered is_covered = [&](Index hexahedron, const Quad& quad) {
    return flat.contains({labels[hexahedron], lines.patch_of(quad)});
  };
  pillow(mesh, sides, is_covered, host);
  labels.insert(labels.end(), sides.begin() + static_cast<std::ptrdiff_t>(sheets.first), sides.end());
  sheets.second = mesh.hexahedra.size();
  if (three_meet(mesh, labels, host)) add_rings(mesh, labels, sheets, host);
  return sheets;
}

}  // namespace orbicube::hexmesh
