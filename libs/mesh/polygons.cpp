#include "mesh/polygons.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "base/error.h"
#include "mesh/predicates.h"

namespace orbicube::mesh {
namespace {

using Eigen::Vector2d;

// One face at a time; its scratch space is kept.
class PolygonCutter {
 public:
  PolygonCutter(std::span<const Vector3> positions, std::pmr::memory_resource* memory)
      : positions_(positions), flat_(memory), left_(memory), sorted_(memory) {}

  void cut(std::span<const Index> face, Array<Triangle>& triangles) {
    const Vector3 normal = newell_normal(face);
    if (fan_agrees(face, normal)) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i)
        triangles.push_back({face[0], face[i], face[i + 1]});
    } else {
      clip_ears(face, normal, triangles);
    }
  }

  bool has_repeated_corner(std::span<const Index> face) {
    sorted_.assign(face.begin(), face.end());
    std::sort(sorted_.begin(), sorted_.end());
    return std::adjacent_find(sorted_.begin(), sorted_.end()) != sorted_.end();
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

  // O(k^2) for most faces of k corners.
  void clip_ears(std::span<const Index> face, const Vector3& normal, Array<Triangle>& triangles) {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    flat_.clear();
    left_.clear();
    for (std::size_t i = 0; i < face.size(); ++i) {
      flat_.push_back(seen_along(face[i], normal, axis));
      left_.push_back(static_cast<Index>(i));
    }
    std::size_t at = 0;
    std::size_t refused = 0;
    while (left_.size() > 3) {
      const std::size_t count = left_.size();
      const Index a = left_[(at + count - 1) % count];
      const Index b = left_[at % count];
      const Index c = left_[(at + 1) % count];
      // After a whole round without an ear (a face that crosses itself), any corner will do.
      if (refused < count && !is_ear(a, b, c)) {
        ++at;
        ++refused;
        continue;
      }
      triangles.push_back({face[a], face[b], face[c]});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at % count));
      at = at % count;
      refused = 0;
    }
    triangles.push_back({face[left_[0]], face[left_[1]], face[left_[2]]});
  }

  // Convex, and no other corner inside or on it but where it is a corner of the triangle itself.
  bool is_ear(Index a, Index b, Index c) const {
    if (orientation_2d(flat_[a], flat_[b], flat_[c]) <= 0) return false;
    return std::none_of(left_.begin(), left_.end(), [&](Index i) {
      if (i == a || i == b || i == c) return false;
      const Vector2d& p = flat_[i];
      if (p == flat_[a] || p == flat_[b] || p == flat_[c]) return false;
      return orientation_2d(flat_[a], flat_[b], p) >= 0 && orientation_2d(flat_[b], flat_[c], p) >= 0 &&
             orientation_2d(flat_[c], flat_[a], p) >= 0;
    });
  }

  std::span<const Vector3> positions_;
  Array<Vector2d> flat_;
  Array<Index> left_;
  Array<Index> sorted_;
};

}  // namespace

void Polygons::add(std::span<const Index> corners) {
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
      triangles.push_back({corners_[i], corners_[i + 1], corners_[i + 2]});
    }
    return;
  }
  triangles.reserve(triangles.size() + corners_.size() - 2 * sizes_.size());
  PolygonCutter cutter(positions, host.memory);
  std::size_t begin = 0;
  for (std::size_t f = 0; f < sizes_.size(); ++f) {
    const std::span<const Index> face(corners_.data() + begin, sizes_[f]);
    begin += sizes_[f];
    if (f % 1024 == 0) host.report("cutting polygons", f, sizes_.size());
    if (face.size() == 3) {
      triangles.push_back({face[0], face[1], face[2]});
      continue;
    }
    if (cutter.has_repeated_corner(face)) {
      throw base::Error("degenerate-face", "face " + std::to_string(f) + " of " + std::to_string(face.size()) +
                                               " corners has a vertex twice");
    }
    cutter.cut(face, triangles);
  }
}

}  // namespace orbicube::mesh
