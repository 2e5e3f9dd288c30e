#include "frame_field/graph/features.h"

#include <Eigen/Geometry>
#include <cmath>

namespace orbicube::frame_field {
namespace {

Vector3 normal_of(std::span<const Vector3> positions, const mesh::Triangle& t) {
  return (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).stableNormalized();
}

}  // namespace

void follow_features(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                     double angle, const base::Host& host, Array<GivenFrame>& frames, Array<GivenAxis>& axes) {
  const mesh::EdgeRings rings(connectivity, host);
  Array<std::uint8_t> taken(connectivity.tetrahedra().size(), 0, host.memory);
  for (const GivenFrame& g : frames)
    taken[g.tetrahedron] = 1;
  for (const GivenAxis& g : axes)
    taken[g.tetrahedron] = 1;

  // visit(edge direction, ring, first boundary face, last boundary face)
  const auto for_each_feature = [&](const auto& visit) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      if (r % 16384 == 0) host.report("features", r, rings.size());
      if (!rings.on_boundary(r)) continue;
      const auto faces = rings.faces(r);
      const mesh::Edge edge = rings.vertices(r);
      // The boundary face behind the first tetrahedron is opposite the vertex ahead.
      const Index first = mesh::TetrahedralConnectivity::tetrahedron_of(faces[0]);
      Index ahead = no_index;
      for (const Index v : connectivity.vertices(faces[0]))
        ahead = v != edge[0] && v != edge[1] ? v : ahead;
      const Index behind = 4 * first + connectivity.corner_of(first, ahead);
      const Vector3 a = normal_of(positions, connectivity.vertices(behind));
      const Vector3 b = normal_of(positions, connectivity.vertices(faces.back()));
      const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
      const Vector3 along = (positions[edge[1]] - positions[edge[0]]).stableNormalized();
      if (!(turn > angle) || !(along.norm() > 0.5)) continue;
      visit(along, faces, behind, a, b);
    }
  };
  // Tetrahedra on the boundary first, so that no axis takes the place of a frame.
  for_each_feature(
      [&](const Vector3& along, std::span<const Index> faces, Index behind, const Vector3& a, const Vector3& b) {
        const auto hold = [&](Index face, const Vector3& normal) {
          const Index t = mesh::TetrahedralConnectivity::tetrahedron_of(face);
          if (taken[t] != 0 || !(normal.norm() > 0.5)) return;
          taken[t] = 1;
          Eigen::Matrix3d axes_in_space;
          axes_in_space << along, normal, along.cross(normal);
          const Eigen::Quaterniond q(axes_in_space);
          frames.push_back({t, quaternion::normalized({q.w(), q.x(), q.y(), q.z()})});
        };
        hold(behind, a);
        hold(faces.back(), b);
      });
  for_each_feature([&](const Vector3& along, std::span<const Index> faces, Index, const Vector3&, const Vector3&) {
    for (const Index face : faces) {
      const Index t = mesh::TetrahedralConnectivity::tetrahedron_of(face);
      // A tetrahedron that has a boundary face elsewhere stays aligned with that.
      bool inner = taken[t] == 0;
      for (Index k = 0; k < 4; ++k)
        inner = inner && !connectivity.on_boundary(4 * t + k);
      if (!inner) continue;
      taken[t] = 1;
      axes.push_back({t, {along[0], along[1], along[2]}});
    }
  });
}

}  // namespace orbicube::frame_field
