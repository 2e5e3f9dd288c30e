#include "mesh/topology/conforming_tetrahedra.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/topology/place_text.h"

namespace orbicube::mesh {

Array<SortedFace> sorted_faces(std::span<const Tetrahedron> tetrahedra, std::size_t vertices, const base::Host& host) {
  constexpr std::array<std::array<std::size_t, 3>, 4> outward = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  Array<SortedFace> faces(host.memory);
  faces.reserve(4 * tetrahedra.size());
  for (Index i = 0; i < tetrahedra.size(); ++i) {
    if (i % 65536 == 0) host.report("check", i, tetrahedra.size());
    const Tetrahedron& t = tetrahedra[i];
    for (const Index v : t) {
      if (v < vertices) continue;
      throw base::Error("index-range", "tetrahedron " + std::to_string(i) + " has vertex " + std::to_string(v) +
                                           ", there are " + std::to_string(vertices));
    }
    for (const auto& corners : outward) {
      SortedFace face{{t[corners[0]], t[corners[1]], t[corners[2]]}, i, false};
      for (const auto& [k, l] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {0, 1}}) {
        if (face.corners[k] <= face.corners[l]) continue;
        std::swap(face.corners[k], face.corners[l]);
        face.odd = !face.odd;
      }
      faces.push_back(face);
    }
  }
  host.report("check", 0, 0);
  std::sort(faces.begin(), faces.end(), [](const SortedFace& p, const SortedFace& q) {
    return std::pair(p.corners, p.tetrahedron) < std::pair(q.corners, q.tetrahedron);
  });
  host.report("check", 0, 0);
  return faces;
}

void require_conforming(std::span<const Tetrahedron> tetrahedra, std::span<const Vector3> positions,
                        const base::Host& host) {
  const Array<SortedFace> faces = sorted_faces(tetrahedra, positions.size(), host);
  const auto text = [&](const SortedFace& face) {
    return "face " + std::to_string(face.corners[0]) + "-" + std::to_string(face.corners[1]) + "-" +
           std::to_string(face.corners[2]) + ", at " + place_text(positions[face.corners[0]]);
  };
  for (std::size_t i = 1; i < faces.size(); ++i) {
    const SortedFace &a = faces[i - 1], &b = faces[i];
    if (a.corners != b.corners) continue;
    if (i + 1 < faces.size() && faces[i + 1].corners == a.corners) {
      throw base::Error("non-manifold-face", "more than two tetrahedra, among them " + std::to_string(a.tetrahedron) +
                                                 ", " + std::to_string(b.tetrahedron) + " and " +
                                                 std::to_string(faces[i + 1].tetrahedron) + ", have the " + text(a));
    }
    if (a.odd == b.odd) {
      throw base::Error("inconsistent-orientation",
                        "tetrahedra " + std::to_string(a.tetrahedron) + " and " + std::to_string(b.tetrahedron) +
                            " can never both be positive side by side: the order of their vertices at their " +
                            text(a));
    }
  }
}

Array<std::uint8_t> boundary_vertices(std::span<const Tetrahedron> tetrahedra, std::size_t vertices,
                                      const base::Host& host) {
  const Array<SortedFace> faces = sorted_faces(tetrahedra, vertices, host);
  Array<std::uint8_t> result(vertices, 0, host.memory);
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t end = i + 1;
    while (end < faces.size() && faces[end].corners == faces[i].corners)
      ++end;
    for (const Index v : faces[i].corners)
      result[v] |= static_cast<std::uint8_t>(end == i + 1);
    i = end;
  }
  return result;
}

}  // namespace orbicube::mesh
