#include "sphere_map/optimization/measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/degenerate_triangles.h"
#include "sphere_map/hierarchy/normalize.h"
#include "sphere_map/optimization/distortion.h"

namespace orbicube::sphere_map {
namespace {

constexpr double four_pi = 4 * std::numbers::pi;

// Singular values of the affine map from surface triangle to flat spherical triangle, larger first.
struct SingularValues {
  double large, small;
};

SingularValues singular_values(const Vector3& p, const Vector3& q, const Vector3& r, const Vector3& image_p,
                               const Vector3& image_q, const Vector3& image_r) {
  // Both triangles in the plane with the first edge on the x axis: the map is upper triangular, [a b; 0 c].
  const auto flatten = [](const Vector3& e, const Vector3& f) {
    const double length = e.norm();
    return std::array{length, e.dot(f) / length, e.cross(f).norm() / length};
  };
  const auto [x1, x2, y2] = flatten(q - p, r - p);
  const auto [u1, u2, v2] = flatten(image_q - image_p, image_r - image_p);
  const double a = u1 / x1;
  const double b = (u2 - a * x2) / y2;
  const double c = v2 / y2;
  const double large = std::hypot(0.5 * (a + c), 0.5 * b) + std::hypot(0.5 * (a - c), 0.5 * b);
  return {large, large > 0 ? a * c / large : 0};
}

// Which vertices are of triangles.
Array<std::uint8_t> checked_use(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                std::span<const Vector3> directions, const base::Host& host) {
  if (positions.size() != directions.size()) {
    throw base::Error("invalid-argument", base::counted(positions.size(), "position") + " but " +
                                              base::counted(directions.size(), "direction"));
  }
  Array<std::uint8_t> used(positions.size(), 0, host.memory);
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      if (v >= positions.size()) {
        throw base::Error("invalid-argument", "triangle index " + std::to_string(v) + " of " +
                                                  base::counted(positions.size(), "vertex", "vertices"));
      }
      used[v] = 1;
    }
  }
  for (std::size_t v = 0; v < directions.size(); ++v) {
    if (used[v] == 0) continue;
    if (!positions[v].allFinite()) {
      throw base::Error("invalid-argument", "the position of vertex " + std::to_string(v) + " is not finite");
    }
    if (!directions[v].allFinite() || directions[v] == Vector3::Zero()) {
      throw base::Error("invalid-argument", "the direction of vertex " + std::to_string(v) + " is zero or not finite");
    }
  }
  return used;
}

// The directions of vertices in use at length 1; `radius_error` gets the largest difference to that.
Array<Vector3> unit_directions(std::span<const Vector3> directions, std::span<const std::uint8_t> used,
                               double& radius_error, const base::Host& host) {
  Array<Vector3> unit(directions.begin(), directions.end(), host.memory);
  for (std::size_t v = 0; v < unit.size(); ++v) {
    if (used[v] == 0) continue;
    radius_error = std::max(radius_error, std::abs(unit[v].norm() - 1));
    unit[v].stableNormalize();
  }
  return unit;
}

// How the triangles of the map cover the sphere.
void measure_cover(std::span<const Triangle> triangles, std::span<const Vector3> unit, Measurement& m) {
  std::size_t positive = 0;
  std::size_t negative = 0;
  double total_angle = 0;
  for (const Triangle& t : triangles) {
    const int sign = mesh::orientation_from_origin(unit[t[0]], unit[t[1]], unit[t[2]]);
    positive += sign > 0;
    negative += sign < 0;
    total_angle += solid_angle(unit[t[0]], unit[t[1]], unit[t[2]]);
  }
  m.mirrored = negative > positive;
  m.flipped = m.mirrored ? positive : negative;
  m.degenerate = triangles.size() - positive - negative;
  m.degree = (m.mirrored ? -total_angle : total_angle) / four_pi;
  m.bijective = !triangles.empty() && m.flipped == 0 && m.degenerate == 0 && std::abs(m.degree - 1) < 1e-6;
}

// Sums over triangles, by their area on the surface.
struct DistortionSums {
  double area = 0;
  double quasi_conformal = 0;
  double stretch = 0;
  double isometric = 0;

  // With a triangle of the surface, its map's singular values, and their quotient.
  void add(double a, const SingularValues& s, double k) {
    area += a;
    quasi_conformal += a * k;
    stretch += a * 0.5 * (1 / (s.large * s.large) + 1 / (s.small * s.small));
    isometric += a * 0.25 * (s.large * s.large + s.small * s.small + 1 / (s.large * s.large) + 1 / (s.small * s.small));
  }
};

// Those of a triangle, as eq. 3.1 to 3.4 and their readings in measure.h.
void add_energies(const SphericalTriangle& image, const TriangleShape& shape, Measurement& m) {
  m.energy_angle += image.inverse_d_square() * image.D(shape);
  m.energy_area += image.inverse_d_square() * image.N / (4 * shape.area);
  const double angle_integral = image.D(shape) * 0.5 * std::sqrt(image.N);
  m.equation_3_1 += angle_integral;
  m.equation_3_2 += image.N / (4 * shape.area);
  m.equation_3_3 += image.inverse_d_square() * angle_integral;
}

double area_of(std::span<const Triangle> triangles, std::span<const Vector3> surface) {
  double area = 0;
  for (const Triangle& t : triangles)
    area += 0.5 * (surface[t[1]] - surface[t[0]]).cross(surface[t[2]] - surface[t[0]]).norm();
  return area;
}

}  // namespace

double solid_angle(const Vector3& p, const Vector3& q, const Vector3& r) {
  return 2 * std::atan2(p.dot((q - p).cross(r - p)), 1 + p.dot(q) + q.dot(r) + r.dot(p));
}

std::size_t count_not_positive(std::span<const Triangle> triangles, std::span<const Vector3> directions) {
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return mesh::orientation_from_origin(directions[t[0]], directions[t[1]], directions[t[2]]) <= 0;
  }));
}

Measurement measure(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                    std::span<const Vector3> directions, double angle_weight, double area_weight,
                    const base::Host& host, FaceDistortion* faces) {
  const Array<std::uint8_t> used = checked_use(positions, triangles, directions, host);
  const Array<Vector3> surface = normalized(positions, triangles, host.memory);
  const double rounding = mesh::rounding_unit(positions, triangles);
  Measurement m;
  const Array<Vector3> unit = unit_directions(directions, used, m.radius_error, host);
  measure_cover(triangles, unit, m);

  if (faces != nullptr) {
    faces->quasi_conformal.assign(triangles.size(), std::numeric_limits<double>::infinity());
    faces->area_ratio.assign(triangles.size(), 0);
  }
  const double length_scale = std::sqrt(four_pi / area_of(triangles, surface));
  DistortionSums sums;
  m.min_area_ratio = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    const Vector3 p = length_scale * surface[t[0]];
    const Vector3 q = length_scale * surface[t[1]];
    const Vector3 r = length_scale * surface[t[2]];
    const double twice_area = (q - p).cross(r - p).norm();
    if (!(twice_area > 0) || mesh::is_degenerate(positions[t[0]], positions[t[1]], positions[t[2]], rounding)) {
      ++m.zero_area_faces;
      continue;
    }
    const double area = 0.5 * twice_area;
    const SphericalTriangle image(unit[t[0]], unit[t[1]], unit[t[2]]);
    const TriangleShape shape{(q - p).dot(r - p) / twice_area, (p - q).dot(r - q) / twice_area,
                              (p - r).dot(q - r) / twice_area, area};
    add_energies(image, shape, m);

    const SingularValues s = singular_values(p, q, r, unit[t[0]], unit[t[1]], unit[t[2]]);
    const double k = s.small > 0 ? s.large / s.small : std::numeric_limits<double>::infinity();
    const double ratio = std::abs(solid_angle(unit[t[0]], unit[t[1]], unit[t[2]])) / area;
    m.max_quasi_conformal = std::max(m.max_quasi_conformal, k);
    m.min_area_ratio = std::min(m.min_area_ratio, ratio);
    m.max_area_ratio = std::max(m.max_area_ratio, ratio);
    sums.add(area, s, k);
    if (faces != nullptr) {
      faces->quasi_conformal[i] = k;
      faces->area_ratio[i] = ratio;
    }
    if (i % 65536 == 0) host.report("measurement", i, triangles.size());
  }
  m.energy = angle_weight * m.energy_angle + area_weight * m.energy_area;
  m.equation_3_4 = m.energy_area;
  if (!(sums.area > 0)) {
    m.min_area_ratio = 0;
    return m;
  }
  m.mean_quasi_conformal = sums.quasi_conformal / sums.area;
  m.stretch_efficiency = sums.area / sums.stretch;
  m.isometric_mean = sums.isometric / sums.area;
  return m;
}

}  // namespace orbicube::sphere_map
