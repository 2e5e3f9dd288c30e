#include "hexmesh/quality/corner_elements.h"

namespace orbicube::hexmesh {

std::array<double, 3> own_lengths(const HexMesh& mesh, Index hexahedron, const std::array<double, 3>& given) {
  constexpr double shortest = 0.15, longest = 3;  // over the given ones
  const Hexahedron& h = mesh.hexahedra[hexahedron];
  std::array<double, 3> length{};
  for (std::size_t d = 0; d < 3; ++d) {
    for (const auto& e : edges_along[d])
      length[d] += 0.25 * (mesh.positions[h[e[1]]] - mesh.positions[h[e[0]]]).norm();
    length[d] = std::clamp(length[d], shortest * given[d], longest * given[d]);
  }
  return length;
}

Array<Element> corner_elements(const HexMesh& mesh, std::span<const Index> chosen, const BoxSizes& sizes,
                               const base::Host& host) {
  Array<Element> elements(corner_tetrahedra * chosen.size(), host.memory);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const HexTetrahedron& corner = hex_tetrahedra[i % corner_tetrahedra];
    const Index of = chosen[i / corner_tetrahedra];
    elements[i] = corner.element(mesh.hexahedra[of]);
    corner.set_shape(sizes[of], elements[i]);
  }
  return elements;
}

void weigh_corners(std::span<const Vector3> positions, double most, Array<Element>& corners) {
  constexpr double good = 0.5, least = 0.02;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double s = hex_tetrahedra[i % corner_tetrahedra].scaled_jacobian(positions, corners[i]);
    const double part = good / std::max(s, least);
    corners[i].weight = std::clamp(part * part, 1.0, most);
  }
}

double searched_quality(std::span<const Vector3> positions, const Hexahedron& hexahedron) {
  constexpr double certain = 0.75;
  constexpr double flat = 0.01, worse = 1;  // than whatever is between good corners
  const double corners = scaled_jacobian(positions, hexahedron);
  if (corners > certain) return corners;
  if (corners <= flat) return corners - worse;
  return std::min(corners, 3 * min_bezier(positions, hexahedron));
}

double worst_searched_quality(const HexMesh& mesh, std::span<const Index> chosen) {
  double worst = 1;
  for (const Index i : chosen)
    worst = std::min(worst, searched_quality(mesh.positions, mesh.hexahedra[i]));
  return worst;
}

Array<Index> vertices_of_worst(std::span<const Hexahedron> hexahedra, Array<std::pair<double, Index>> rated,
                               std::size_t most) {
  std::sort(rated.begin(), rated.end());
  if (rated.size() > most) rated.resize(most);
  Array<Index> vertices(rated.get_allocator().resource());
  for (const auto& [quality, i] : rated)
    vertices.insert(vertices.end(), hexahedra[i].begin(), hexahedra[i].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace orbicube::hexmesh
