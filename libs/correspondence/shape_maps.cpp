#include "correspondence/shape_maps.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "polycube/outputs/inverse_map.h"

namespace orbicube::correspondence {
namespace {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;
using polycube::SurfaceMap;

constexpr const char* shape_maps_phase = "map between shapes";

// A point of a map's triangle on the polycube, exactly in the planes that the corners it lies between share.
Vector3 on_polycube(const SurfaceMap& map, const TrianglePoint& point) {
  const Triangle& t = map.triangles[point.triangle];
  Vector3 sum = Vector3::Zero(), low = map.polycube[t[0]], high = low;
  bool first = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = point.weights[static_cast<Eigen::Index>(k)];
    if (weight == 0) continue;
    const Vector3& corner = map.polycube[t[k]];
    low = first ? corner : Vector3(low.cwiseMin(corner));
    high = first ? corner : Vector3(high.cwiseMax(corner));
    first = false;
    sum += weight * corner;
  }
  return sum.cwiseMax(low).cwiseMin(high);
}

// The nearest point of the triangles in the plane of the patch that the point left by rounding.
TrianglePoint nearest_in_plane(const SurfaceMap& map, const Vector3& point, int axis) {
  TrianglePoint best;
  double least = std::numeric_limits<double>::infinity();
  const auto u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (Index t = 0; t < map.triangles.size(); ++t) {
    const auto& [a, b, c] = map.triangles[t];
    if (polycube::axis_of(map.labels[t]) != axis || map.polycube[a][axis] != point[axis]) continue;
    const std::array<const Vector3*, 3> corner = {&map.polycube[a], &map.polycube[b], &map.polycube[c]};
    Vector3 weights;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 &p = *corner[(k + 1) % 3], &q = *corner[(k + 2) % 3];
      weights[static_cast<Eigen::Index>(k)] = (q[u] - p[u]) * (point[v] - p[v]) - (q[v] - p[v]) * (point[u] - p[u]);
    }
    if (weights.sum() < 0) weights = -weights;
    weights = weights.cwiseMax(0.0);
    if (!(weights.sum() > 0)) continue;
    weights /= weights.sum();
    const double distance =
        (weights[0] * *corner[0] + weights[1] * *corner[1] + weights[2] * *corner[2] - point).norm();
    if (distance < least) {
      least = distance;
      best = {t, weights};
    }
  }
  return best;
}

template <class Sources>
base::Array<Index> numbers_or(const Sources& sources, std::size_t count, const base::Host& host) {
  base::Array<Index> result(sources.begin(), sources.end(), host.memory);
  if (!result.empty()) return result;
  result.resize(count);
  std::iota(result.begin(), result.end(), Index{0});
  return result;
}

base::Array<polycube::VertexSource> sources_of(const SphereShape& shape, const base::Host& host) {
  base::Array<polycube::VertexSource> result(shape.vertex_sources.begin(), shape.vertex_sources.end(), host.memory);
  if (result.empty()) {
    for (Index v = 0; v < shape.directions.size(); ++v)
      result.push_back({{v, mesh::no_index, mesh::no_index}, {1, 0, 0}});
  }
  return result;
}

}  // namespace

ShapeMaps::ShapeMaps(std::deque<SphereShape> spheres, std::span<const std::span<const Triangle>> given,
                     const base::Host& host)
    : spheres_(std::move(spheres)) {
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    const SphereShape& shape = spheres_[i];
    surfaces_.emplace_back(given[i], shape.mesh.triangles, numbers_or(shape.triangle_sources, given[i].size(), host),
                           sources_of(shape, host), host);
  }
}

ShapeMaps::ShapeMaps(std::vector<SurfaceMap> maps, std::span<const std::span<const Triangle>> given,
                     const base::Host& host)
    : maps_(std::move(maps)) {
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    const SurfaceMap& map = maps_[i];
    surfaces_.emplace_back(given[i], map.triangles, map.triangle_sources, map.vertex_sources, host);
  }
}

base::Array<TrianglePoint> ShapeMaps::carry(std::size_t from, std::size_t to, std::span<const TrianglePoint> points,
                                            const base::Host& host) const {
  base::require(from < size() && to < size(), "a shape is out of range");
  base::Array<TrianglePoint> pieces(host.memory);
  pieces.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 1024 == 0) host.report(shape_maps_phase, i, points.size());
    pieces.push_back(surfaces_[from].piece_of(points[i]));
  }
  base::Array<TrianglePoint> result =
      maps_.empty() ? through_sphere(from, to, pieces, host) : through_polycube(from, to, pieces, host);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 1024 == 0) host.report(shape_maps_phase, i, points.size());
    result[i] = surfaces_[to].given_of(result[i]);
  }
  return result;
}

std::size_t ShapeMaps::flipped() const {
  std::size_t result = 0;
  for (const SphereShape& shape : spheres_) {
    const auto at = [&](Index v) -> const Vector3& { return shape.directions[v]; };
    for (const auto& [a, b, c] : shape.mesh.triangles)
      result += mesh::orientation_from_origin(at(a), at(b), at(c)) <= 0 ? 1 : 0;
  }
  for (const SurfaceMap& map : maps_) {
    for (std::size_t t = 0; t < map.triangles.size(); ++t) {
      const int axis = polycube::axis_of(map.labels[t]), u = (axis + 1) % 3, v = (axis + 2) % 3;
      const auto at = [&](Index i) { return Eigen::Vector2d(map.polycube[i][u], map.polycube[i][v]); };
      const auto& [a, b, c] = map.triangles[t];
      const bool flat =
          map.polycube[a][axis] == map.polycube[b][axis] && map.polycube[a][axis] == map.polycube[c][axis];
      const int sign = mesh::orientation_2d(at(a), at(b), at(c)) * polycube::sign_of(map.labels[t]);
      result += flat && sign > 0 ? 0 : 1;
    }
  }
  return result;
}

base::Array<TrianglePoint> ShapeMaps::through_sphere(std::size_t from, std::size_t to,
                                                     std::span<const TrianglePoint> pieces,
                                                     const base::Host& host) const {
  const SphereShape& shape = spheres_[from];
  base::Array<Vector3> directions(host.memory);
  directions.reserve(pieces.size());
  for (const TrianglePoint& piece : pieces)
    directions.push_back(position_of(piece, shape.mesh.triangles, shape.directions));
  base::Array<TrianglePoint> result(pieces.size(), TrianglePoint(), host.memory);
  spheres_[to].locator->for_each_location(directions, host, [&](std::size_t i, const sphere_map::Location& at) {
    result[i] = {at.triangle, at.weights};
  });
  return result;
}

base::Array<TrianglePoint> ShapeMaps::through_polycube(std::size_t from, std::size_t to,
                                                       std::span<const TrianglePoint> pieces,
                                                       const base::Host& host) const {
  base::Array<Vector3> places(host.memory);
  places.reserve(pieces.size());
  for (const TrianglePoint& piece : pieces)
    places.push_back(on_polycube(maps_[from], piece));
  const polycube::LocatedPoints located = polycube::locate(maps_[to], places, host);
  base::Array<TrianglePoint> result(host.memory);
  result.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (located.triangles[i] != mesh::no_index) {
      result.push_back({located.triangles[i], located.weights[i]});
      continue;
    }
    host.report(shape_maps_phase, i, pieces.size());
    result.push_back(nearest_in_plane(maps_[to], places[i], polycube::axis_of(maps_[from].labels[pieces[i].triangle])));
    if (result.back().triangle == mesh::no_index)
      throw base::Error("internal", "a point is in no plane of the polycube");
  }
  return result;
}

base::Array<TrianglePoint> points_of_vertices(std::size_t vertices, std::span<const Triangle> triangles,
                                              const base::Host& host) {
  base::Array<TrianglePoint> result(vertices, TrianglePoint(), host.memory);
  for (Index t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      TrianglePoint& point = result[triangles[t][k]];
      if (point.triangle == mesh::no_index) point = {t, Vector3::Unit(static_cast<Eigen::Index>(k))};
    }
  }
  return result;
}

base::Array<TrianglePoint> carry_vertices(const ShapeMaps& maps, std::size_t from, std::size_t to, std::size_t vertices,
                                          const base::Host& host) {
  base::Array<TrianglePoint> result = points_of_vertices(vertices, maps.triangles(from), host);
  base::Array<TrianglePoint> used(host.memory);
  for (const TrianglePoint& point : result)
    if (point.triangle != mesh::no_index) used.push_back(point);
  used = maps.carry(from, to, used, host);
  std::size_t next = 0;
  for (TrianglePoint& point : result)
    if (point.triangle != mesh::no_index) point = used[next++];
  return result;
}

}  // namespace orbicube::correspondence
