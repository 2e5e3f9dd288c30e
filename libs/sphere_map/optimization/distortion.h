// The distortion energy of a spherical triangle and its derivatives.
//
// The surface triangle T enters by its cotangents and its area AT, the spherical one t = (p, q, r) by three
// polynomials:
//   D = cot_p |q-r|^2 + cot_q |r-p|^2 + cot_r |p-q|^2    (twice the Dirichlet energy of the map T -> t)
//   N = |(q-p) x (r-p)|^2                                (four times the squared area of t)
//   M = det[p q r]^2
// and by d, the distance from the origin to t. With them, eq. 3.3 and 3.4 of the dissertation read
//   E_D = d^-2 D and E_A = d^-2 N / (4 AT).
// Neither of these two grows without bound as t collapses, so the optimization adds terms that do. They are written
// with det[p q r] in place of the area of t: a large triangle can collapse onto a great-circle arc and keep its flat
// area.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/mesh.h"
#include "mesh/topology/degenerate_triangles.h"
#include "sphere_map/optimization/rounded_shape.h"

namespace orbicube::sphere_map {

using mesh::Index;
using mesh::Vector3;

// Weights of the terms, per triangle with area AT (of 4 pi in all) and uniform share AU = 4 pi / triangle count.
struct Weights {
  double angle = 0;      // d^-2 D
  double area = 0;       // d^-2 N / (4 AT)
  double isometric = 0;  // d^-2 D AT^2 / M: the symmetric Dirichlet energy's inverse part
  double quasi_conformal_1 =
      0;  // d^-2 AT m, where m = D / (2 sqrt M) = (K + 1/K) / 2 for the quasi-conformal distortion K of T -> t
  double quasi_conformal_2 = 0;  // AU m^2
  double quasi_conformal_4 = 0;  // AU m^4
};

// How the triangles of the surface count that have no shape of their own.
struct RestTriangles {
  // With it, each triangle is blended with an equilateral one of that area, so that where surfaces have no area there
  // is something to map.
  double min_area = 0;
  // Whether degenerate triangles (mesh/topology/degenerate_triangles.h) only keep from collapsing, and slivers that
  // have no part in the area of the surface. Degenerate are those below min_height, or below
  // mesh::degenerate_height_ratio times their longest side; slivers are below sliver_height_ratio times it, and below
  // sliver_area.
  bool release_degenerate = false;
  double min_height = 0;
  double sliver_area = 0;
  // Positive: areas of shapes are in this unit, the area of the surface, and shapes are rounded (rounded_shape.h).
  double unit_area = 0;
};

// Larger: thin triangles of scans count less than their shapes say; smaller: one sliver between large triangles, which
// counts as each of them in the barrier, distorts these.
inline constexpr double sliver_height_ratio = 2e-4;

// `sliver_area` over the mean area: all slivers together have less of the whole than this.
inline constexpr double sliver_area_share = 1e-3;

// Whether a triangle of a surface of diagonal 1 is released, by twice its area and the square of its longest side.
inline bool is_released(const RestTriangles& rest, double twice_area, double longest_square) {
  return twice_area <= mesh::degenerate_height_ratio * longest_square ||
         twice_area <= rest.min_height * std::sqrt(longest_square) ||
         (twice_area <= sliver_height_ratio * longest_square && twice_area <= 2 * rest.sliver_area);
}

// The energy of one level of the hierarchy.
struct Energy {
  Weights weights;
  double area_scale = 1;    // surface area times this is 4 pi in all
  double uniform_area = 1;  // 4 pi / triangle count
  RestTriangles rest;
};

// What a degenerate triangle counts for when it is released: an equilateral one with the cotangents and the area times
// this, so that the terms of the energy have factors from this to its fourth power (the barrier's). The angles that it
// has are those of rounding; it only must not collapse on the sphere. Larger: its image is opened at the cost of its
// neighbors, smaller: its image becomes a needle.
inline constexpr double released_share = 0.05;

inline TriangleShape released_shape(double squares) {
  // Also for corners at one point, on surfaces of diagonal 1.
  constexpr double min_square = 1e-12;
  const double side_square = std::max(squares / 3, min_square), cotangent = released_share / std::numbers::sqrt3;
  return {cotangent, cotangent, cotangent, released_share * 0.25 * std::numbers::sqrt3 * side_square};
}

// Very thin triangles count as a little wider.
inline TriangleShape triangle_shape(const Vector3& p, const Vector3& q, const Vector3& r,
                                    const RestTriangles& rest = {}) {
  const Vector3 pq = q - p;
  const Vector3 pr = r - p;
  const Vector3 qr = r - q;
  const double square_p = qr.squaredNorm(), square_q = pr.squaredNorm(), square_r = pq.squaredNorm();
  const double squares = square_p + square_q + square_r;
  const double floor = 1e-7 * squares + std::numeric_limits<double>::min();
  const double own_area = pq.cross(pr).norm();
  const double twice_area = std::max(own_area, floor);
  const double inverse = 1 / twice_area;
  TriangleShape shape{pq.dot(pr) * inverse, -pq.dot(qr) * inverse, pr.dot(qr) * inverse, 0.5 * twice_area};
  bool released = false;
  if (rest.release_degenerate) {
    released = is_released(rest, own_area, std::max({square_p, square_q, square_r}));
    if (released) shape = released_shape(squares);
  }
  if (rest.min_area > 0) {
    shape.area += rest.min_area;
    const double part = rest.min_area / shape.area;
    for (double* cotangent : {&shape.cot_p, &shape.cot_q, &shape.cot_r}) {
      *cotangent += part * (1 / std::numbers::sqrt3 - *cotangent);
    }
  }
  if (rest.unit_area > 0) {
    shape.area = rounded_number(shape.area / rest.unit_area);
    const bool own_angles = !released && !(rest.min_area > 0);
    if (own_angles) round_angles({square_p, square_q, square_r}, own_area, shape);
  }
  return shape;
}

// What the energy needs of a spherical triangle. Edges are named by the opposite vertex.
struct SphericalTriangle {
  Vector3 edge_p, edge_q, edge_r;  // q - r, r - p, q - p (edge_q and edge_r both start at p)
  double square_p, square_q, square_r;
  Vector3 normal;  // (q - p) x (r - p)
  double N;
  double determinant;
  double circumradius_square;  // of the smallest circle that encloses the triangle: d^2 = 1 - this
  bool acute;

  SphericalTriangle(const Vector3& p, const Vector3& q, const Vector3& r)
      : edge_p(q - r), edge_q(r - p), edge_r(q - p) {
    square_p = edge_p.squaredNorm();
    square_q = edge_q.squaredNorm();
    square_r = edge_r.squaredNorm();
    normal = edge_r.cross(edge_q);
    N = normal.squaredNorm();
    determinant = p.dot(normal);
    const double longest = std::max({square_p, square_q, square_r});
    acute = square_p + square_q + square_r > 2 * longest;
    circumradius_square = acute ? square_p * square_q * square_r / (4 * N) : 0.25 * longest;
  }

  double D(const TriangleShape& shape) const {
    return shape.cot_p * square_p + shape.cot_q * square_q + shape.cot_r * square_r;
  }
  double inverse_d_square() const { return 1 / (1 - circumradius_square); }
  // Whether the energy is defined: positive, and in front of the origin.
  bool valid() const { return determinant > 0 && circumradius_square < 1; }
};

// Value, and its partial derivatives by D, N and M. `inside_d` is what d^-2 multiplies.
struct EnergyPartials {
  double value, inside_d;
  double by_D, by_N, by_M;
  double by_DD, by_DM, by_MM;
};

inline double triangle_energy(const Energy& energy, const TriangleShape& shape, const SphericalTriangle& t) {
  if (!t.valid()) return std::numeric_limits<double>::infinity();
  const Weights& w = energy.weights;
  const double D = t.D(shape);
  const double area = shape.area * energy.area_scale;
  const double inverse_determinant = 1 / t.determinant;
  const double inverse_M = inverse_determinant * inverse_determinant;
  const double inside = w.angle * D + w.area * t.N / (4 * area) + w.isometric * D * area * area * inverse_M +
                        w.quasi_conformal_1 * area * 0.5 * D * inverse_determinant;
  const double m2 = 0.25 * D * D * inverse_M;
  return t.inverse_d_square() * inside + energy.uniform_area * (w.quasi_conformal_2 + w.quasi_conformal_4 * m2) * m2;
}

inline EnergyPartials energy_partials(const Energy& energy, const TriangleShape& shape, const SphericalTriangle& t) {
  const Weights& w = energy.weights;
  const double D = t.D(shape);
  const double area = shape.area * energy.area_scale;
  const double d2 = t.inverse_d_square();
  const double inverse_determinant = 1 / t.determinant;
  const double inverse_M = inverse_determinant * inverse_determinant;

  EnergyPartials e{};
  e.inside_d = w.angle * D + w.area * t.N / (4 * area);
  e.by_D = d2 * w.angle;
  e.by_N = d2 * w.area / (4 * area);
  if (w.isometric > 0) {
    const double c = w.isometric * area * area * inverse_M;
    e.inside_d += c * D;
    e.by_D += d2 * c;
    e.by_M -= d2 * c * D * inverse_M;
    e.by_DM -= d2 * c * inverse_M;
    e.by_MM += 2 * d2 * c * D * inverse_M * inverse_M;
  }
  if (w.quasi_conformal_1 > 0) {
    const double c = w.quasi_conformal_1 * area * 0.5 * inverse_determinant;
    e.inside_d += c * D;
    e.by_D += d2 * c;
    e.by_M -= 0.5 * d2 * c * D * inverse_M;
    e.by_DM -= 0.5 * d2 * c * inverse_M;
    e.by_MM += 0.75 * d2 * c * D * inverse_M * inverse_M;
  }
  e.value = d2 * e.inside_d;

  // The powers of m^2 = D^2 / (4 M): f(m^2) = c2 m^2 + c4 m^4 and its derivatives by the chain rule.
  const double c2 = energy.uniform_area * w.quasi_conformal_2;
  const double c4 = energy.uniform_area * w.quasi_conformal_4;
  if (c2 > 0 || c4 > 0) {
    const double m2 = 0.25 * D * D * inverse_M;
    const double m2_D = 0.5 * D * inverse_M;
    const double m2_M = -m2 * inverse_M;
    const double first = c2 + 2 * c4 * m2;
    const double second = 2 * c4;
    e.value += (c2 + c4 * m2) * m2;
    e.by_D += first * m2_D;
    e.by_M += first * m2_M;
    e.by_DD += second * m2_D * m2_D + first * 0.5 * inverse_M;
    e.by_DM += second * m2_D * m2_M - first * 0.5 * D * inverse_M * inverse_M;
    e.by_MM += second * m2_M * m2_M + 2 * first * m2 * inverse_M * inverse_M;
  }
  return e;
}

// Whether p, q, r are counter-clockwise, and stay so when each vertex moves by up to `slack`, and when each coordinate
// is changed in its last bits, as writing, reading and normalizing do. Moving each vertex by delta changes the
// determinant by at most about delta times the perimeter, which is at most twice |e| + |f|; the constant leaves room
// for the rounding of the determinant itself.
inline bool safely_positive(const Vector3& p, const Vector3& q, const Vector3& r, double slack = 0) {
  const Vector3 e = q - p;
  const Vector3 f = r - p;
  return p.dot(e.cross(f)) > (4e-15 + 2 * slack) * (e.norm() + f.norm());
}

// Two unit vectors that complete the unit vector p to an orthonormal, right-handed basis (Duff et al. 2017).
struct TangentBasis {
  Vector3 first, second;
  explicit TangentBasis(const Vector3& p) {
    const double sign = std::copysign(1.0, p.z());
    const double a = -1 / (sign + p.z());
    const double b = p.x() * p.y() * a;
    first = Vector3(1 + sign * p.x() * p.x() * a, sign * b, -sign * p.x());
    second = Vector3(b, sign + p.y() * p.y() * a, -p.y());
  }
};

}  // namespace orbicube::sphere_map
