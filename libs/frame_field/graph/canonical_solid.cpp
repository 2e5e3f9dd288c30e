#include "frame_field/graph/canonical_solid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>

#include "mesh/search/hilbert_curve.h"
#include "quaternion/rotation.h"

namespace orbicube::frame_field {
namespace {

// Axes of the solid that are off the given ones by less (radians) are taken to be these: a box that stands straight
// keeps its coordinates to the bit.
constexpr double straight = 1e-9;
constexpr double rounding = 1e-15;  // of the entries of a rotation that are 0 or 1

// A boundary face by the places of its vertices in an order that does not depend on their numbers, the first one first.
std::array<Index, 3> ranked(const mesh::Triangle& v, std::span<const Index> rank) {
  std::array<Index, 3> face = {rank[v[0]], rank[v[1]], rank[v[2]]};
  std::rotate(face.begin(), std::ranges::min_element(face), face.end());
  return face;
}

struct Moments {
  Harmonic normals{};  // area times the harmonics of the normal
  Vector3 centre = Vector3::Zero();
  double area = 0;
};

struct Face {
  Vector3 centre;
  Vector3 normal;  // as long as twice the area
};

Face face_at(const std::array<Index, 3>& face, std::span<const Vector3> ordered) {
  const Vector3 &a = ordered[face[0]], &b = ordered[face[1]], &c = ordered[face[2]];
  return {((a + b) + c) / 3, (b - a).cross(c - a)};
}

// Of a direction e: the mean square of the boundary's extent along it, and its skewness.
std::pair<double, double> extent_along(const Vector3& e, std::span<const std::array<Index, 3>> faces,
                                       std::span<const Vector3> ordered, const Moments& moments) {
  double square = 0, cube = 0;
  for (const auto& f : faces) {
    const Face face = face_at(f, ordered);
    const double along = (face.centre - moments.centre).dot(e), area = face.normal.norm();
    square += area * along * along;
    cube += area * along * along * along;
  }
  return {square, cube};
}

// Turns the solid's axes to the given ones.
Quaternion axes_of(std::span<const std::array<Index, 3>> faces, std::span<const Vector3> ordered) {
  Moments moments;
  for (const auto& f : faces) {
    const Face face = face_at(f, ordered);
    const double area = face.normal.norm();
    if (!(area > 0) || !std::isfinite(area)) continue;
    const Vector3 n = face.normal / area;
    const Harmonic h = harmonics_at({n[0], n[1], n[2]});
    for (std::size_t k = 0; k < h.size(); ++k)
      moments.normals[k] += area * h[k];
    moments.centre += area * face.centre;
    moments.area += area;
  }
  const Quaternion given{1, 0, 0, 0};
  const double length = std::sqrt(dot(moments.normals, moments.normals));
  if (!(length > 0) || !(moments.area > 0) || !std::isfinite(length)) return given;
  for (double& entry : moments.normals)
    entry /= length;
  moments.centre /= moments.area;
  Quaternion frame = nearest_frame(moments.normals);
  if (quaternion::symmetric_distance(frame, given) < straight) frame = given;

  struct Axis {
    double square, cube;
    Vector3 direction;
  };
  std::array<Axis, 3> axes;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector unit{k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
    const Vector e = quaternion::rotate(frame, unit);
    axes[k].direction = Vector3(e.x, e.y, e.z);
    const auto [square, cube] = extent_along(axes[k].direction, faces, ordered, moments);
    axes[k].square = square;
    axes[k].cube = cube;
  }
  std::ranges::stable_sort(axes, [](const Axis& a, const Axis& b) { return a.square > b.square; });
  for (Axis& axis : axes) {
    if (axis.cube < 0) axis.direction = -axis.direction;
  }
  Eigen::Matrix3d matrix;
  matrix << axes[0].direction, axes[1].direction, axes[0].direction.cross(axes[1].direction);
  // The element of the group that brings the frame there, which keeps the frame's digits.
  const Eigen::Quaterniond q(matrix);
  const Quaternion target{q.w(), q.x(), q.y(), q.z()};
  Quaternion best = frame;
  double nearest = -1;
  for (const Quaternion& g : quaternion::cube_group.element) {
    const Quaternion turned = quaternion::multiply(frame, g);
    const double cosine = std::abs(quaternion::dot(turned, target));
    if (cosine > nearest) {
      nearest = cosine;
      best = turned;
    }
  }
  return best;
}

// Corners in ascending order, the last two exchanged where that keeps the volume's sign.
Tetrahedron in_order(Tetrahedron t) {
  bool odd = false;
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t k = i; k > 0 && t[k] < t[k - 1]; --k) {
      std::swap(t[k], t[k - 1]);
      odd = !odd;
    }
  }
  if (odd) std::swap(t[2], t[3]);
  return t;
}

// Vertices in no cell, which change nothing, go to where the first cell is.
Array<Vector3> without_unused(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                              const base::Host& host) {
  Array<Vector3> result(positions.begin(), positions.end(), host.memory);
  if (tetrahedra.empty()) return result;
  Array<std::uint8_t> used(positions.size(), 0, host.memory);
  for (const Tetrahedron& t : tetrahedra) {
    for (const Index v : t)
      used[v] = 1;
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) result[v] = positions[tetrahedra[0][0]];
  }
  return result;
}

}  // namespace

namespace {

// Axes and vertices.
void order_vertices(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                    CanonicalSolid& solid, const base::Host& host) {
  const Array<Vector3> places = without_unused(positions, connectivity.tetrahedra(), host);
  const Array<Index> order = mesh::hilbert_order(places, host);
  Array<Index> rank(positions.size(), host.memory);
  Array<Vector3> ordered(host.memory);
  ordered.reserve(positions.size());
  for (Index i = 0; i < order.size(); ++i) {
    rank[order[i]] = i;
    ordered.push_back(places[order[i]]);
  }
  Array<std::array<Index, 3>> faces(host.memory);
  faces.reserve(connectivity.boundary_face_count());
  for (Index f = 0; f < connectivity.face_count(); ++f) {
    if (f % base::items_between_reports == 0) host.report("boundary", f, connectivity.face_count());
    if (connectivity.on_boundary(f)) faces.push_back(ranked(connectivity.vertices(f), rank));
  }
  std::ranges::sort(faces);
  solid.axes = axes_of(faces, ordered);
  solid.matrix = quaternion::to_matrix(quaternion::conjugate(solid.axes));
  for (double& entry : solid.matrix) {
    if (std::abs(entry - std::round(entry)) < rounding) entry = std::round(entry);
  }
  for (Vector3& p : ordered) {
    const Vector turned = solid.turned(Vector{p[0], p[1], p[2]});
    p = Vector3(turned.x, turned.y, turned.z);
  }
  // Along a curve in the solid's axes; of equal places the first is that which is first in the given axes.
  const Array<Index> again = mesh::hilbert_order(ordered, host);
  solid.vertex.reserve(positions.size());
  solid.positions.reserve(positions.size());
  for (const Index i : again) {
    solid.vertex.push_back(order[i]);
    solid.positions.push_back(ordered[i]);
  }
}

// Along the order of the vertices, which come first.
void order_tetrahedra(std::span<const Tetrahedron> tetrahedra, CanonicalSolid& solid, const base::Host& host) {
  Array<Index> number(solid.vertex.size(), host.memory);
  for (Index i = 0; i < solid.vertex.size(); ++i)
    number[solid.vertex[i]] = i;
  struct Numbered {
    Tetrahedron corners;
    Index given;
    bool operator<(const Numbered& o) const { return corners != o.corners ? corners < o.corners : given < o.given; }
  };
  Array<Numbered> sorted(tetrahedra.size(), host.memory);
  for (Index t = 0; t < sorted.size(); ++t) {
    if (t % base::items_between_reports == 0) host.report("ordering tetrahedra", t, sorted.size());
    Tetrahedron corners{};
    for (std::size_t k = 0; k < 4; ++k)
      corners[k] = number[tetrahedra[t][k]];
    sorted[t] = {in_order(corners), t};
  }
  std::ranges::sort(sorted, std::less<>());
  Array<Tetrahedron> corners(host.memory);
  corners.reserve(sorted.size());
  for (const Numbered& n : sorted)
    corners.push_back(n.corners);
  const Array<Index> order = tetrahedral_order(solid.positions, corners, host);
  solid.tetrahedra.reserve(sorted.size());
  solid.tetrahedron.reserve(sorted.size());
  for (const Index i : order) {
    solid.tetrahedra.push_back(sorted[i].corners);
    solid.tetrahedron.push_back(sorted[i].given);
  }
}

}  // namespace

CanonicalSolid make_canonical(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                              const base::Host& host) {
  CanonicalSolid solid(host.memory);
  order_vertices(positions, connectivity, solid, host);
  order_tetrahedra(connectivity.tetrahedra(), solid, host);
  return solid;
}

Vector CanonicalSolid::turned(const Vector& v) const {
  const auto row = [&](std::size_t k) { return (matrix[k] * v.x + matrix[k + 1] * v.y) + matrix[k + 2] * v.z; };
  return {row(0), row(3), row(6)};
}

Quaternion CanonicalSolid::turned(const Quaternion& frame) const {
  return quaternion::normalized(quaternion::multiply(quaternion::conjugate(axes), frame));
}

Quaternion CanonicalSolid::turned_back(const Quaternion& frame) const {
  return quaternion::normalized(quaternion::multiply(axes, frame));
}

void CanonicalSolid::turn(Constraints& constraints) const {
  const auto turn_one = [&](auto& entry, bool whole) {
    if (whole) {
      entry.frame = turned(entry.frame);
    } else {
      entry.direction = turned(entry.direction);
      entry.frame = aligned({1, 0, 0, 0}, entry.direction);
    }
  };
  for (Constraint& c : constraints.list)
    turn_one(c, c.fixed);
  for (Pull& pull : constraints.pulls)
    turn_one(pull, pull.whole);
  for (Constraints::Alternative& alternative : constraints.alternatives)
    alternative.direction = turned(alternative.direction);
}

}  // namespace orbicube::frame_field
