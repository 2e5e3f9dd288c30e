#include "hexmesh/certificate/hex_figures.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "base/sums.h"
#include "hexmesh/certificate/hausdorff_distance.h"
#include "mesh/search/bounding_volume_tree.h"
#include "mesh/topology/cells.h"

namespace orbicube::hexmesh {
namespace {

// The boundary in triangles, each quad cut at its first vertex.
Array<mesh::Triangle> boundary_of(const mesh::Mesh& cells, const base::Host& host) {
  Array<mesh::Triangle> result(host.memory);
  for (const auto& q : mesh::boundary_quads(cells, host)) {
    result.push_back({q[0], q[1], q[2]});
    result.push_back({q[0], q[2], q[3]});
  }
  return result;
}

Array<Vector3> placed(std::span<const Vector3> positions, const Vector3& center, int exponent, const base::Host& host) {
  Array<Vector3> result(host.memory);
  result.reserve(positions.size());
  // In two steps, since 2^-exponent itself may be out of range.
  const double half = std::ldexp(1.0, -exponent / 2), rest = std::ldexp(1.0, -exponent - (-exponent / 2));
  for (const Vector3& p : positions)
    result.push_back((p * half - center * half) * rest);
  return result;
}

}  // namespace

HexFigures figures_of(std::span<const Vector3> positions, std::span<const Hexahedron> hexahedra,
                      std::span<const Vector3> surface_positions, std::span<const mesh::Triangle> surface_triangles,
                      const base::Host& host) {
  mesh::Box box;
  for (const mesh::Triangle& t : surface_triangles) {
    for (const Index v : t)
      box.add(surface_positions[v]);
  }
  const Vector3 center = 0.5 * box.low + 0.5 * box.high;
  int exponent = 0;
  std::frexp((0.5 * box.high - 0.5 * box.low).maxCoeff(), &exponent);
  mesh::Mesh cells(host.memory);
  cells.positions = placed(positions, center, exponent, host);
  cells.hexahedra.assign(hexahedra.begin(), hexahedra.end());
  const Array<Vector3> surface = placed(surface_positions, center, exponent, host);

  base::CompensatedSum solid_volume, surface_volume;
  for (std::size_t i = 0; i < hexahedra.size(); ++i) {
    if (i % base::items_between_reports == 0) host.report("measurement", i, hexahedra.size());
    const std::array<double, 27> coefficients = bezier_coefficients(cells.positions, hexahedra[i]);
    solid_volume.add(std::accumulate(coefficients.begin(), coefficients.end(), 0.0) / 27);
  }
  mesh::Box small;
  for (const mesh::Triangle& t : surface_triangles) {
    for (const Index v : t)
      small.add(surface[v]);
    surface_volume.add(surface[t[0]].dot(surface[t[1]].cross(surface[t[2]])) / 6);
  }
  HexFigures result;
  result.volume = std::ldexp(solid_volume.value(), 3 * exponent);
  result.volume_error = 100 * std::abs(solid_volume.value() / std::abs(surface_volume.value()) - 1);
  constexpr double tolerance = 0.005;
  result.distance =
      100 / (small.high - small.low).norm() *
      hausdorff_distance(cells.positions, boundary_of(cells, host), surface, surface_triangles, tolerance, host);
  return result;
}

}  // namespace orbicube::hexmesh
