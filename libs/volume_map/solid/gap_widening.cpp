#include "volume_map/solid/gap_widening.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/threads/pieces.h"
#include "mesh/search/bounding_volume_tree.h"
#include "mesh/search/nearest.h"

namespace orbicube::volume_map {
namespace {

using mesh::Triangle;

constexpr const char* gap_widening_phase = "gaps";

class Gaps {
 public:
  Gaps(std::span<const Vector3> positions, std::span<const Triangle> triangles, double width, const base::Host& host)
      : positions_(positions),
        triangles_(triangles),
        width_(width),
        host_(host),
        normals_(triangles.size(), Vector3::Zero(), host.memory),
        tree_(mesh::boxes_of(positions, triangles, host), host) {
    for (std::size_t i = 0; i < triangles.size(); ++i)
      normals_[i] = (at(i, 1) - at(i, 0)).cross(at(i, 2) - at(i, 0));
  }

  Array<Vector3> widened() const {
    constexpr std::size_t piece = 64;
    constexpr double part = 1.0 / 3;  // of the thickness
    Array<double> back(triangles_.size(), 0, host_.memory);
    base::parallel_pieces(host_, gap_widening_phase, triangles_.size(), piece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const double gap = clearance(static_cast<Index>(i), 1, width_);
        if (gap >= width_) continue;
        const double move = 0.5 * (width_ - gap);
        back[i] = std::min(move, part * clearance(static_cast<Index>(i), -1, move / part));
      }
    });
    host_.report(gap_widening_phase, 0, 0);
    Array<Vector3> normal(positions_.size(), Vector3::Zero(), host_.memory);
    Array<double> most(positions_.size(), 0, host_.memory);
    bool any = false;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      if (back[i] <= 0) continue;
      any = true;
      for (const Index v : triangles_[i]) {
        normal[v] += normals_[i];
        most[v] = std::max(most[v], back[i]);
      }
    }
    Array<Vector3> result(host_.memory);
    if (!any) return result;
    result.assign(positions_.begin(), positions_.end());
    for (std::size_t v = 0; v < result.size(); ++v) {
      if (normal[v].norm() > 0) result[v] -= most[v] * normal[v].normalized();
    }
    return result;
  }

 private:
  const Vector3& at(std::size_t triangle, std::size_t corner) const { return positions_[triangles_[triangle][corner]]; }

  // How far the surface is before a triangle (side 1) or behind it (-1), at its center and near its corners, at most
  // `far`.
  double clearance(Index triangle, double side, double far) const {
    constexpr double inside = 0.8;
    const Vector3 n = normals_[triangle];
    if (!(n.norm() > 0)) return far;
    const Vector3 center = (at(triangle, 0) + at(triangle, 1) + at(triangle, 2)) / 3;
    double least = far;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3 from = k == 3 ? center : Vector3(inside * at(triangle, k) + (1 - inside) * center);
      least = std::min(least, ray(triangle, from, side * n.normalized(), least));
    }
    return least;
  }

  // Where a ray first meets a triangle that looks against the one that it comes from and is not beside it.
  double ray(Index from, const Vector3& origin, const Vector3& direction, double far) const {
    mesh::Box box;
    box.add(origin);
    box.add(origin + far * direction);
    double least = far;
    tree_.for_each_near(box, [&](Index i) {
      const Vector3& n = normals_[i];
      if (n.dot(normals_[from]) >= 0 || beside(i, from)) return;
      const double t = (at(i, 0) - origin).dot(n) / direction.dot(n);
      if (!(t >= 0 && t < least)) return;
      const Vector3 p = origin + t * direction;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3 &a = at(i, k), &b = at(i, (k + 1) % 3);
        if ((b - a).cross(p - a).dot(n) < 0) return;
      }
      least = t;
    });
    return least;
  }

  bool beside(Index a, Index b) const {
    const Triangle& t = triangles_[b];
    return std::any_of(triangles_[a].begin(), triangles_[a].end(),
                       [&](Index v) { return std::find(t.begin(), t.end(), v) != t.end(); });
  }

  std::span<const Vector3> positions_;
  std::span<const Triangle> triangles_;
  double width_;
  const base::Host& host_;
  Array<Vector3> normals_;  // twice the areas long
  mesh::BoundingVolumeTree tree_;
};

}  // namespace

Array<Vector3> widened_gaps(std::span<const Vector3> positions, std::span<const Triangle> triangles, double width,
                            const base::Host& host) {
  return Gaps(positions, triangles, width, host).widened();
}

}  // namespace orbicube::volume_map
