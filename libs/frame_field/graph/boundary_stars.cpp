#include "frame_field/graph/boundary_stars.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "mesh/search/rotations.h"

namespace orbicube::frame_field {
namespace {

constexpr double one_direction = 0.7071;  // normals with a greater cosine belong together
constexpr double perpendicular = 0.5;     // with a smaller one, two directions are axes of one frame

// The directions of the boundary at a vertex: sums of normals, times twice the areas, that belong together.
struct Directions {
  std::array<Vector3, 3> sum{};
  std::size_t count = 0;
  bool too_many = false;

  void add(const Vector3& normal) {
    for (std::size_t k = 0; k < count; ++k) {
      if (normal.dot(sum[k]) <= one_direction * normal.norm() * sum[k].norm()) continue;
      sum[k] += normal;
      return;
    }
    if (count == sum.size()) {
      too_many = true;
      return;
    }
    sum[count++] = normal;
  }
};

// The frame whose axes are next to two or three directions, if these are about perpendicular.
bool frame_of(const Directions& directions, Quaternion& frame) {
  if (directions.too_many || directions.count < 2) return false;
  Eigen::Matrix3d axes;
  for (std::size_t k = 0; k < directions.count; ++k)
    axes.col(static_cast<Eigen::Index>(k)) = directions.sum[k].normalized();
  if (directions.count == 2) axes.col(2) = axes.col(0).cross(axes.col(1)).stableNormalized();
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (!(std::abs(axes.col(k).dot(axes.col((k + 1) % 3))) < perpendicular)) return false;
  }
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  const Eigen::Quaterniond q(mesh::nearest_rotation(axes));
  frame = quaternion::normalized({q.w(), q.x(), q.y(), q.z()});
  return true;
}

}  // namespace

void follow_boundary_stars(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                           const base::Host& host, Array<GivenFrame>& frames, Array<GivenAxis>& axes) {
  Array<std::uint8_t> taken(connectivity.tetrahedra().size(), 0, host.memory);
  for (const GivenFrame& g : frames)
    taken[g.tetrahedron] = 1;
  for (const GivenAxis& g : axes)
    taken[g.tetrahedron] = 1;
  Array<Directions> at(positions.size(), host.memory);
  const auto normal_of = [&](Index face) -> Vector3 {
    const auto [a, b, c] = connectivity.vertices(face);
    return (positions[b] - positions[a]).cross(positions[c] - positions[a]);
  };
  for (Index face = 0; face < connectivity.face_count(); ++face) {
    if (!connectivity.on_boundary(face)) continue;
    for (const Index v : connectivity.vertices(face))
      at[v].add(normal_of(face));
  }
  Quaternion frame{1, 0, 0, 0};
  for (Index t = 0; t < taken.size(); ++t) {
    if (t % 16384 == 0) host.report("features", t, taken.size());
    if (taken[t] != 0) continue;
    Index own_face = no_index;
    std::size_t own_faces = 0;
    for (Index face = 4 * t; face < 4 * t + 4; ++face) {
      if (!connectivity.on_boundary(face)) continue;
      own_face = face;
      ++own_faces;
    }
    Directions whole, single;
    bool all_single = true;
    for (const Index v : connectivity.tetrahedra()[t]) {
      if (at[v].count == 0) continue;
      all_single = all_single && at[v].count == 1;
      const bool is_whole = frame_of(at[v], frame);
      for (std::size_t k = 0; k < at[v].count; ++k) {
        if (is_whole) whole.add(at[v].sum[k]);
        single.add(at[v].sum[k]);
      }
    }
    const auto unit = [](const Vector3& x) -> Vector {
      const Vector3 u = x.stableNormalized();
      return {u[0], u[1], u[2]};
    };
    if (own_faces > 1) continue;
    if (frame_of(whole, frame))
      frames.push_back({t, own_faces == 1 ? aligned(frame, unit(normal_of(own_face))) : frame});
    else if (own_faces == 0 && all_single && single.count == 1 && single.sum[0].norm() > 0)
      axes.push_back({t, unit(single.sum[0])});
  }
}

}  // namespace orbicube::frame_field
