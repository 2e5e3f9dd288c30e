#include "hexmesh/strategies/machined_shape.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "mesh/topology/connectivity.h"

namespace orbicube::hexmesh {

bool is_machined(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                 const base::Host& host) {
  constexpr double degree = std::numbers::pi / 180, round = 10 * degree, sharp = 40 * degree, part = 0.5;
  const mesh::Connectivity connectivity(positions.size(), triangles, host);
  const auto normal = [&](mesh::Index half_edge) -> mesh::Vector3 {
    const mesh::Triangle& t = triangles[half_edge / 3];
    return (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
  };
  double length_sharp = 0, length_round = 0;
  for (mesh::Index h = 0; h < 3 * triangles.size(); ++h) {
    const mesh::Index other = connectivity.opposite(h);
    if (other == mesh::no_index || other < h) continue;
    const mesh::Vector3 m = normal(h), n = normal(other);
    const double angle = std::atan2(m.cross(n).norm(), m.dot(n));
    const double length = (positions[connectivity.end(h)] - positions[connectivity.start(h)]).norm();
    if (angle >= sharp) {
      length_sharp += length;
    } else if (angle >= round) {
      length_round += length;
    }
  }
  return length_sharp > 0 && length_sharp >= part * length_round;
}

}  // namespace orbicube::hexmesh
