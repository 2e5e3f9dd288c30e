#include "mesh/files/polygons.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "mesh/search/predicates.h"

namespace orbicube::mesh {
namespace {

using Eigen::Vector2d;

// One face at a time; its scratch space is kept.
class PolygonCutter {
 public:
  // `faces` are going to be cut, for progress.
  PolygonCutter(std::span<const Vector3> positions, std::size_t faces, const base::Host& host)
      : host_(host), positions_(positions), flat_(host.memory), ring_(host.memory), faces_(faces) {}

  void cut(std::span<const Index> face, Array<Triangle>& triangles) {
    if (face_number_++ % 1024 == 0) report();
    if (face.size() == 3) {
      triangles.push_back({face[0], face[1], face[2]});
      return;
    }
    const Vector3 normal = newell_normal(face);
    if (fan_agrees(face, normal)) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i)
        triangles.push_back({face[0], face[i], face[i + 1]});
    } else {
      clip_ears(face, normal, triangles);
    }
  }

 private:
  // Twice the vector area, relative to a corner and to the face's size, so that nothing overflows.
  Vector3 newell_normal(std::span<const Index> face) const {
    const Vector3 origin = positions_[face[0]];
    double size = 0;
    for (const Index v : face)
      size = std::max(size, (0.5 * positions_[v] - 0.5 * origin).cwiseAbs().maxCoeff());
    Vector3 normal = Vector3::Zero();
    if (!(size > 0)) return normal;
    const auto unit = [&](Index v) -> Vector3 { return (0.5 * positions_[v] - 0.5 * origin) / size; };
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      normal += unit(face[i]).cross(unit(face[i + 1]));
    return normal;
  }

  // The coordinates of the face seen along the largest component of its normal, counter-clockwise.
  Vector2d seen_along(Index v, const Vector3& normal, int axis) const {
    const Vector2d x(positions_[v][(axis + 1) % 3], positions_[v][(axis + 2) % 3]);
    return normal[axis] < 0 ? Vector2d(x.y(), x.x()) : x;
  }

  bool fan_agrees(std::span<const Index> face, const Vector3& normal) const {
    int axis = 0;
    if (!(normal.cwiseAbs().maxCoeff(&axis) > 0)) return true;  // no way of cutting is better than another
    const Vector2d a = seen_along(face[0], normal, axis);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      if (orientation_2d(a, seen_along(face[i], normal, axis), seen_along(face[i + 1], normal, axis)) <= 0)
        return false;
    }
    return true;
  }

  // Only the corners beside an ear that is cut off can become or cease to be ears (Meisters 1975), so that each corner
  // is tried a few times: O(k^2) for k corners.
  void clip_ears(std::span<const Index> face, const Vector3& normal, Array<Triangle>& triangles) {
    make_ring(face, normal);
    Index at = 0;
    std::size_t refused = 0;
    for (std::size_t left = face.size(); left > 3;) {
      const Corner corner = ring_[at];
      // After a whole round without an ear (a face that crosses itself), any corner will do.
      if (!corner.ear && refused < left) {
        at = corner.next;
        ++refused;
        continue;
      }
      triangles.push_back({face[corner.previous], face[at], face[corner.next]});
      ring_[corner.previous].next = corner.next;
      ring_[corner.next].previous = corner.previous;
      for (const Index beside : {corner.previous, corner.next})
        ring_[beside].convex = is_convex(beside);
      for (const Index beside : {corner.previous, corner.next})
        ring_[beside].ear = is_ear(beside);
      at = corner.next;
      refused = 0;
      if (--left % 16 == 0) report();
    }
    triangles.push_back({face[ring_[at].previous], face[at], face[ring_[at].next]});
  }

  void make_ring(std::span<const Index> face, const Vector3& normal) {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const auto size = static_cast<Index>(face.size());
    flat_.clear();
    ring_.clear();
    for (Index i = 0; i < size; ++i) {
      flat_.push_back(seen_along(face[i], normal, axis));
      ring_.push_back({i == 0 ? size - 1 : i - 1, i + 1 == size ? 0 : i + 1, false, false});
    }
    for (Index i = 0; i < size; ++i)
      ring_[i].convex = is_convex(i);
    for (Index i = 0; i < size; ++i) {
      ring_[i].ear = is_ear(i);
      if (i % 16 == 0) report();
    }
  }

  bool is_convex(Index b) const { return orientation_2d(flat_[ring_[b].previous], flat_[b], flat_[ring_[b].next]) > 0; }

  // Convex, and no other corner inside or on its triangle but where it is a corner of the triangle itself. Convex
  // corners need no test: where any is inside, one that is not convex is.
  bool is_ear(Index b) const {
    if (!ring_[b].convex) return false;
    const Index last = ring_[b].previous;
    const Vector2d &p = flat_[last], &q = flat_[b], &r = flat_[ring_[b].next];
    const Vector2d low = p.cwiseMin(q).cwiseMin(r);
    const Vector2d high = p.cwiseMax(q).cwiseMax(r);
    for (Index i = ring_[ring_[b].next].next; i != last; i = ring_[i].next) {
      const Vector2d& x = flat_[i];
      if (ring_[i].convex || (x.array() < low.array()).any() || (x.array() > high.array()).any()) continue;
      if (x == p || x == q || x == r) continue;
      if (orientation_2d(p, q, x) >= 0 && orientation_2d(q, r, x) >= 0 && orientation_2d(r, p, x) >= 0) return false;
    }
    return true;
  }

  void report() const { host_.report("cutting polygons", face_number_, faces_); }

  struct Corner {
    Index previous, next;
    bool convex, ear;
  };

  const base::Host& host_;
  std::span<const Vector3> positions_;
  Array<Vector2d> flat_;
  Array<Corner> ring_;  // of the corners that are left
  std::size_t faces_;
  std::size_t face_number_ = 0;
};

}  // namespace

std::optional<Index> Polygons::repeated_corner(std::span<const Index> corners) {
  if (corners.size() == 3) return {};
  sorted_.assign(corners.begin(), corners.end());
  std::sort(sorted_.begin(), sorted_.end());
  const auto repeated = std::adjacent_find(sorted_.begin(), sorted_.end());
  if (repeated == sorted_.end()) return {};
  return *repeated;
}

void Polygons::append(std::span<const Index> corners) {
  if (corners.size() != 3 && sizes_.empty()) sizes_.assign(corners_.size() / 3, 3);
  larger_ += corners.size() > 3;
  const bool with_sizes = corners.size() != 3 || !sizes_.empty();
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  if (with_sizes) sizes_.push_back(static_cast<Index>(corners.size()));
}

void Polygons::to_triangles(std::span<const Vector3> positions, Array<Triangle>& triangles,
                            const base::Host& host) const {
  if (larger_ == 0) {
    triangles.reserve(triangles.size() + corners_.size() / 3);
    for (std::size_t i = 0; i < corners_.size(); i += 3) {
      if (i % 196608 == 0) host.report("reading faces", i, corners_.size());
      triangles.push_back({corners_[i], corners_[i + 1], corners_[i + 2]});
    }
    return;
  }
  triangles.reserve(triangles.size() + corners_.size() - 2 * sizes_.size());
  PolygonCutter cutter(positions, sizes_.size(), host);
  std::size_t begin = 0;
  for (const Index size : sizes_) {
    cutter.cut({corners_.data() + begin, size}, triangles);
    begin += size;
  }
}

}  // namespace orbicube::mesh
