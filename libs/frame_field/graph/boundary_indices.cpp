#include "frame_field/graph/boundary_indices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "frame_field/graph/constraints.h"

namespace orbicube::frame_field {
namespace {

constexpr double pi = std::numbers::pi;

// A boundary face with its normal and one direction of the cross in its plane.
struct CrossFace {
  mesh::Triangle vertices;
  Vector3 normal, direction;
};

double angle_from(const Vector3& a, const Vector3& b, const Vector3& normal) {
  return std::atan2(normal.dot(a.cross(b)), a.dot(b));
}

CrossFace cross_face(std::span<const Vector3> positions, const mesh::Triangle& v, const Quaternion& frame) {
  CrossFace face{v, Vector3::UnitZ(), Vector3::UnitX()};
  const Vector3 along = (positions[v[1]] - positions[v[0]]).stableNormalized();
  const Vector3 normal = along.cross((positions[v[2]] - positions[v[0]]).stableNormalized()).stableNormalized();
  if (!(normal.norm() > 0.5)) return face;
  face.normal = normal;
  face.direction = along;
  const Quaternion q = aligned(quaternion::normalized(frame), {normal[0], normal[1], normal[2]});
  for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
    const Vector d = quaternion::rotate(q, axis);
    const Vector3 direction(d.x, d.y, d.z);
    if (std::abs(direction.dot(normal)) < 0.5) {
      face.direction = (direction - direction.dot(normal) * normal).normalized();
      break;
    }
  }
  return face;
}

}  // namespace

BoundaryIndices boundary_indices(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                                 std::span<const Quaternion> field, const base::Host& host) {
  BoundaryIndices result(host.memory);
  result.quarters.assign(positions.size(), 0);
  // 2 pi index = 2 pi - sum of the corners' angles + what the cross turns by against the faces on the way round, all
  // counted per vertex.
  Array<double> turn(positions.size(), 0.0, host.memory);
  Array<Index> corners(positions.size(), 0, host.memory);
  std::int64_t faces = 0, edge_count = 0, fans = 0;

  const auto add_corners = [&](const mesh::Triangle& v) {
    ++faces;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 a = positions[v[(k + 1) % 3]] - positions[v[k]], b = positions[v[(k + 2) % 3]] - positions[v[k]];
      turn[v[k]] -= std::atan2(a.cross(b).norm(), a.dot(b));
      ++corners[v[k]];
    }
  };
  for (Index f = 0; f < connectivity.face_count(); ++f) {
    if (f % 65536 == 0) host.report("boundary indices", f, connectivity.face_count());
    if (connectivity.on_boundary(f)) add_corners(connectivity.vertices(f));
  }
  const mesh::EdgeRings rings(connectivity, host);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (r % 16384 == 0) host.report("boundary indices", r, rings.size());
    if (!rings.on_boundary(r)) continue;
    const auto ring = rings.faces(r);
    const mesh::Edge edge = rings.vertices(r);
    const Index first = mesh::TetrahedralConnectivity::tetrahedron_of(ring.front());
    Index ahead = no_index;
    for (const Index v : connectivity.vertices(ring.front()))
      ahead = v != edge[0] && v != edge[1] ? v : ahead;
    const Index behind = 4 * first + connectivity.corner_of(first, ahead);
    const CrossFace a = cross_face(positions, connectivity.vertices(behind), field[first]);
    const CrossFace b = cross_face(positions, connectivity.vertices(ring.back()),
                                   field[mesh::TetrahedralConnectivity::tetrahedron_of(ring.back())]);
    ++edge_count;
    // From a to b through the edge, by the angles that the cross makes with the edge in both planes, to the nearest of
    // its four directions.
    const Vector3 along = (positions[edge[1]] - positions[edge[0]]).stableNormalized();
    double step = angle_from(along, b.direction, b.normal) - angle_from(along, a.direction, a.normal);
    step -= std::round(step / (pi / 2)) * (pi / 2);
    // The ring goes right-handed about the edge from inside of a to inside of b, so on the surface the way from b to a
    // passes the edge's start counter-clockwise.
    turn[edge[0]] += step;
    turn[edge[1]] -= step;
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (corners[v] == 0) continue;
    const double quarters = (2 * pi + turn[v]) / (pi / 2);
    result.quarters[v] = static_cast<std::int32_t>(std::lround(quarters));
    result.sum_of_quarters += result.quarters[v];
    result.singular_vertices += result.quarters[v] != 0 ? 1 : 0;
    ++fans;
  }
  result.euler_characteristic = fans - edge_count + faces;
  return result;
}

}  // namespace orbicube::frame_field
