#include "mesh/search/tetrahedron_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/error.h"
#include "base/sums.h"
#include "mesh/search/predicates.h"

namespace orbicube::mesh {
namespace {

constexpr const char* tetrahedron_quality_phase = "measuring tetrahedra";

template <std::size_t bins>
void count(std::array<std::size_t, bins>& histogram, double value, double width) {
  ++histogram[std::min(static_cast<std::size_t>(value / width), bins - 1)];
}

}  // namespace

TetrahedronShape shape_of(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  TetrahedronShape result;
  // Scaled to about 1 by a power of two, which rounds nothing, so that products stay in range. Halves first:
  // differences of huge coordinates overflow.
  Vector3 u = b / 2 - a / 2, v = c / 2 - a / 2, w = d / 2 - a / 2;
  const double size = std::max({u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff(), w.cwiseAbs().maxCoeff()});
  if (!(size > 0)) {
    result.radius_edge = std::numeric_limits<double>::infinity();
    return result;
  }
  const int exponent = std::ilogb(size) + 1;
  const auto scale = [&](Vector3& edge) { edge = edge.unaryExpr([&](double x) { return std::ldexp(x, -exponent); }); };
  scale(u);
  scale(v);
  scale(w);
  const std::array<double, 6> lengths = {u.norm(), v.norm(), w.norm(), (v - u).norm(), (w - u).norm(), (w - v).norm()};
  const auto [shortest, longest] = std::ranges::minmax(lengths);
  result.min_edge_length = std::ldexp(shortest, exponent + 1);
  result.max_edge_length = std::ldexp(longest, exponent + 1);

  // Outward normals of the faces opposite to a, b, c, d, twice the area long.
  const Vector3 vw = v.cross(w), wu = w.cross(u), uv = u.cross(v);
  const double six_volumes = u.dot(vw);
  const std::array<Vector3, 4> normals = {(v - u).cross(w - u), -vw, -wu, -uv};
  std::size_t i = 0;
  for (std::size_t p = 0; p < 4; ++p) {
    for (std::size_t q = p + 1; q < 4; ++q) {
      result.dihedral_angles[i++] =
          std::atan2(normals[p].cross(normals[q]).norm(), -normals[p].dot(normals[q])) * 180 / std::numbers::pi;
    }
  }
  const double volume = std::abs(six_volumes) / 6;
  result.volume = std::ldexp(volume, 3 * (exponent + 1));
  // Inradius 3 V / S; circumradius |n| / 12 V (the circumcentre solves 2 u.x = u.u, 2 v.x = v.v, 2 w.x = w.w).
  const double doubled_surface = normals[0].norm() + normals[1].norm() + normals[2].norm() + normals[3].norm();
  const double n = (u.squaredNorm() * vw + v.squaredNorm() * wu + w.squaredNorm() * uv).norm();
  result.radius_ratio = volume > 0 ? std::min(1.0, 216 * volume * volume / (doubled_surface * n)) : 0;
  result.radius_edge = volume > 0 ? n / (12 * volume) / shortest : std::numeric_limits<double>::infinity();
  return result;
}

TetrahedronQuality tetrahedron_quality(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                                       const base::Host& host) {
  TetrahedronQuality result;
  result.tetrahedra = tetrahedra.size();
  if (tetrahedra.empty()) return result;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  result.min_volume = result.min_dihedral = result.min_edge_length = infinity;
  result.min_radius_ratio = infinity;
  result.max_volume = -infinity;
  base::CompensatedSum volumes, min_angles, ratios, radius_edges;
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    if (i % base::items_between_reports == 0) host.report(tetrahedron_quality_phase, i, tetrahedra.size());
    const Tetrahedron& t = tetrahedra[i];
    if (std::ranges::max(t) >= positions.size()) {
      throw base::Error("index-range", "tetrahedron " + std::to_string(i) + " has vertex " +
                                           std::to_string(std::ranges::max(t)) + ", where there are " +
                                           std::to_string(positions.size()));
    }
    const Vector3 &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]], &d = positions[t[3]];
    const TetrahedronShape shape = shape_of(a, b, c, d);
    const int sign = orientation_3d(a, b, c, d);
    ++(sign > 0 ? result.positive : sign == 0 ? result.flat : result.inverted);
    const double volume = sign < 0 ? -shape.volume : shape.volume;
    volumes.add(volume);
    result.min_volume = std::min(result.min_volume, volume);
    result.max_volume = std::max(result.max_volume, volume);
    const auto [low, high] = std::ranges::minmax(shape.dihedral_angles);
    result.min_dihedral = std::min(result.min_dihedral, low);
    result.max_dihedral = std::max(result.max_dihedral, high);
    min_angles.add(low);
    for (const double angle : shape.dihedral_angles)
      count(result.dihedral_histogram, angle, 10);
    const double ratio = sign > 0 ? shape.radius_ratio : sign == 0 ? 0 : -shape.radius_ratio;
    if (ratio < result.min_radius_ratio) {
      result.min_radius_ratio = ratio;
      result.worst = static_cast<Index>(i);
    }
    ratios.add(ratio);
    count(result.radius_ratio_histogram, std::max(ratio, 0.0), 0.05);
    if (sign != 0) radius_edges.add(shape.radius_edge);
    result.max_radius_edge = std::max(result.max_radius_edge, shape.radius_edge);
    result.min_edge_length = std::min(result.min_edge_length, shape.min_edge_length);
    result.max_edge_length = std::max(result.max_edge_length, shape.max_edge_length);
  }
  const auto n = static_cast<double>(tetrahedra.size());
  result.volume = volumes.value();
  result.mean_min_dihedral = min_angles.value() / n;
  result.mean_radius_ratio = ratios.value() / n;
  if (result.flat < result.tetrahedra)
    result.mean_radius_edge = radius_edges.value() / static_cast<double>(result.tetrahedra - result.flat);
  return result;
}

}  // namespace orbicube::mesh
