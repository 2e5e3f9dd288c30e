#include "correspondence/refined_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace orbicube::correspondence {
namespace {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

double doubled_area(const Vector3& a, const Vector3& b, const Vector3& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The weights of a point in a triangle, all of them as weights of one larger triangle.
Vector3 weights_between(const std::array<Vector3, 3>& corner, const Vector3& point) {
  Vector3 result;
  for (std::size_t k = 0; k < 3; ++k)
    result[static_cast<Eigen::Index>(k)] = doubled_area(corner[(k + 1) % 3], corner[(k + 2) % 3], point);
  const double whole = doubled_area(corner[0], corner[1], corner[2]);
  return whole == 0 ? Vector3(-1, -1, -1) : Vector3(result / whole);
}

void require_point(const TrianglePoint& point, std::size_t triangles) {
  constexpr double tolerance = 1e-6;
  base::require(point.triangle < triangles, "a point names no triangle of the surface");
  base::require(
      point.weights.allFinite() && point.weights.minCoeff() >= 0 && std::abs(point.weights.sum() - 1) <= tolerance,
      "weights of a point must be nonnegative with sum 1");
}

}  // namespace

RefinedSurface::RefinedSurface(std::span<const Triangle> given, std::span<const Triangle> pieces,
                               std::span<const Index> piece_sources,
                               std::span<const polycube::VertexSource> vertex_sources, const base::Host& host)
    : given_(given.begin(), given.end(), host.memory),
      pieces_(pieces.begin(), pieces.end(), host.memory),
      piece_sources_(piece_sources.begin(), piece_sources.end(), host.memory),
      vertex_sources_(vertex_sources.begin(), vertex_sources.end(), host.memory),
      pieces_of_(
          given.size(),
          [&](const auto& visit) {
            for (Index piece = 0; piece < piece_sources.size(); ++piece)
              visit(piece_sources[piece], piece);
          },
          host.memory) {}

Vector3 RefinedSurface::weights_in(Index given, Index vertex) const {
  const polycube::VertexSource& source = vertex_sources_[vertex];
  Vector3 result = Vector3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t c = 0; c < 3; ++c)
      if (source.corner[c] == given_[given][k]) result[static_cast<Eigen::Index>(k)] += source.weight[c];
  }
  return result;
}

TrianglePoint RefinedSurface::piece_of(const TrianglePoint& point) const {
  require_point(point, given_.size());
  TrianglePoint best;
  double inside = -std::numeric_limits<double>::infinity();
  for (const Index piece : pieces_of_[point.triangle]) {
    std::array<Vector3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = weights_in(point.triangle, pieces_[piece][k]);
      // A vertex keeps its weight to the bit.
      if (corner[k] == point.weights) return {piece, Vector3::Unit(static_cast<Eigen::Index>(k))};
    }
    const Vector3 weights = weights_between(corner, point.weights);
    if (!(weights.minCoeff() > inside)) continue;
    inside = weights.minCoeff();
    best = {piece, weights};
  }
  if (best.triangle == mesh::no_index) throw base::Error("internal", "a triangle of the surface has no piece");
  best.weights = best.weights.cwiseMax(0.0);
  best.weights /= best.weights.sum();
  return best;
}

TrianglePoint RefinedSurface::given_of(const TrianglePoint& point) const {
  const Index given = piece_sources_[point.triangle];
  Vector3 weights = Vector3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    if (const double weight = point.weights[static_cast<Eigen::Index>(k)]; weight != 0)
      weights += weight * weights_in(given, pieces_[point.triangle][k]);
  return {given, weights / weights.sum()};
}

}  // namespace orbicube::correspondence
