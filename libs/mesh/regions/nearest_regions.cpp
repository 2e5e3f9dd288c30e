#include "mesh/regions/nearest_regions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/regions/region_numbers.h"
#include "mesh/search/bounding_volume_tree.h"
#include "mesh/search/nearest.h"
#include "mesh/topology/cells.h"

namespace orbicube::mesh {
namespace {

constexpr const char* nearest_regions_phase = "regions";
constexpr std::size_t searches_between_reports = 1024;
constexpr double min_cosine = 0.5;  // between normals
// Of the distance to the nearest triangle of all, and of the width of the face: how much farther another one may be.
constexpr double farther = 2, farther_by_width = 0.25;

Vector3 normal_of(const Mesh& from, Index t) {
  const Triangle& c = from.triangles[t];
  const Vector3& a = from.positions[c[0]];
  return (from.positions[c[1]] - a).cross(from.positions[c[2]] - a);
}

// Tetrahedra and hexahedra, the latter behind the former.
class CellSearch {
 public:
  CellSearch(const Mesh& from, const base::Host& host) : from_(from), tree_(boxes(from, host), host) {}

  Index nearest(const Vector3& p) const {
    return tree_.nearest(p, [&](Index cell) { return squared_distance(cell, p); }).item;
  }

 private:
  static Array<Box> boxes(const Mesh& from, const base::Host& host) {
    Array<Box> result(from.tetrahedra.size() + from.hexahedra.size(), host.memory);
    std::size_t at = 0;
    const auto add = [&](const auto& cells) {
      for (const auto& cell : cells) {
        for (const Index v : cell)
          result[at].add(from.positions[v]);
        ++at;
      }
    };
    add(from.tetrahedra);
    add(from.hexahedra);
    return result;
  }

  // 0 inside: behind all triangles of the cell's faces.
  double squared_distance(Index cell, const Vector3& p) const {
    double least = std::numeric_limits<double>::infinity();
    bool inside = true;
    const auto triangle = [&](Index i, Index j, Index k) {
      const Vector3 &a = from_.positions[i], &b = from_.positions[j], &c = from_.positions[k];
      inside = inside && (b - a).cross(c - a).dot(p - a) <= 0;
      least = std::min(least, (nearest_on_triangle(p, a, b, c).position - p).squaredNorm());
    };
    if (cell < from_.tetrahedra.size()) {
      const Tetrahedron& t = from_.tetrahedra[cell];
      for (const auto& [i, j, k] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
        triangle(t[static_cast<std::size_t>(i)], t[static_cast<std::size_t>(j)], t[static_cast<std::size_t>(k)]);
    } else {
      const Hexahedron& h = from_.hexahedra[cell - from_.tetrahedra.size()];
      for (const auto& f : hexahedron_faces) {
        triangle(h[f[0]], h[f[1]], h[f[2]]);
        triangle(h[f[0]], h[f[2]], h[f[3]]);
      }
    }
    return inside ? 0 : least;
  }

  const Mesh& from_;
  BoundingVolumeTree tree_;
};

}  // namespace

FacePlace face_place(std::span<const Vector3> positions, std::span<const Index> corners) {
  FacePlace place{Vector3::Zero(), Vector3::Zero()};
  const Vector3& first = positions[corners[0]];
  for (const Index v : corners)
    place.center += positions[v] / static_cast<double>(corners.size());
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    place.area += 0.5 * (positions[corners[i]] - first).cross(positions[corners[i + 1]] - first);
  return place;
}

Array<std::int32_t> nearest_face_regions(const Mesh& from, std::span<const FacePlace> faces, const base::Host& host) {
  Array<std::int32_t> result(host.memory);
  if (from.regions.triangles.empty()) return result;
  const SurfaceSearch search(from.positions, from.triangles, host);
  result.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (i % searches_between_reports == 0) host.report(nearest_regions_phase, i, faces.size());
    const Vector3 &center = faces[i].center, &area = faces[i].area;
    SurfacePoint found = search.nearest(center);
    const auto agrees = [&](Index t) {
      const Vector3 normal = normal_of(from, t);
      return normal.dot(area) >= min_cosine * normal.norm() * area.norm();
    };
    if (found.triangle != no_index && !agrees(found.triangle)) {
      const SurfacePoint other = search.nearest_of(center, agrees);
      const double limit = std::max(farther * found.distance, farther_by_width * std::sqrt(area.norm()));
      if (other.distance <= limit) found = other;
    }
    result.push_back(found.triangle == no_index ? 0 : from.regions.triangles[found.triangle]);
  }
  clear_if_zero(result);
  return result;
}

Array<std::int32_t> nearest_cell_regions(const Mesh& from, std::span<const Vector3> points, const base::Host& host) {
  Array<std::int32_t> result(host.memory);
  if (from.regions.tetrahedra.empty() && from.regions.hexahedra.empty()) return result;
  const CellSearch search(from, host);
  result.reserve(points.size());
  const auto region_of = [&](Index cell) {
    const std::size_t tetrahedra = from.tetrahedra.size();
    const bool first = cell < tetrahedra;
    const Array<std::int32_t>& regions = first ? from.regions.tetrahedra : from.regions.hexahedra;
    return regions.empty() ? 0 : regions[first ? cell : cell - tetrahedra];
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % searches_between_reports == 0) host.report(nearest_regions_phase, i, points.size());
    const Index cell = search.nearest(points[i]);
    result.push_back(cell == no_index ? 0 : region_of(cell));
  }
  clear_if_zero(result);
  return result;
}

}  // namespace orbicube::mesh
