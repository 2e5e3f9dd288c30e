// How good a map to the sphere is: validity by exact predicates, and the distortion figures of the literature.
#pragma once

#include <cstddef>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

// Figures of a map; the surface counts as scaled to the area of the unit sphere, 4 pi. Vertices in no triangle do not
// count. Energies and distortions are of the triangles that are not degenerate on the surface
// (mesh/topology/degenerate_triangles.h): the angles of the others are those of rounding.
struct Measurement {
  bool mirrored = false;    // more triangles are negative than positive: the map of a surface that is inward-oriented
  std::size_t flipped = 0;  // triangles with det[p q r] < 0, exactly (> 0 when mirrored)
  std::size_t degenerate = 0;  // triangles with det[p q r] = 0, exactly
  double degree = 0;           // sum of the signed solid angles / 4 pi: 1 for a bijection
  bool bijective = false;      // no flipped and no degenerate triangle, and degree 1
  double radius_error = 0;     // largest | |p| - 1 | of a vertex of a triangle
  double energy_angle = 0;     // E_D, eq. 3.3 with E_D(T) read as a density; at least 16 pi
  double energy_area = 0;      // E_A, eq. 3.4; at least 4 pi in the limit of fine meshes
  double energy = 0;           // angle_weight E_D + area_weight E_A, eq. 3.5
  // Eq. 3.1 to 3.4 to the letter, with E_D(T) = D (distortion.h) and E_A(T) = area(t) / area(T).
  double equation_3_1 = 0;          // sum D area(t)
  double equation_3_2 = 0;          // sum area(t)^2 / area(T)
  double equation_3_3 = 0;          // sum d^-2 D area(t)
  double equation_3_4 = 0;          // sum d^-2 area(t)^2 / area(T): E_A
  double max_quasi_conformal = 0;   // sigma_max / sigma_min
  double mean_quasi_conformal = 0;  // weighted by surface area
  double min_area_ratio = 0;        // solid angle over surface area of a triangle
  double max_area_ratio = 0;
  double stretch_efficiency = 0;    // L2, 1 / (surface-weighted mean of the squared stretch sphere -> surface)
  double isometric_mean = 0;        // surface-weighted mean of (s1^2 + s2^2 + s1^-2 + s2^-2) / 4; at least 1
  std::size_t zero_area_faces = 0;  // triangles that are degenerate on the surface
};

// Distortion of each triangle, for coloring. One entry a triangle; 1 is none.
struct FaceDistortion {
  explicit FaceDistortion(std::pmr::memory_resource* memory) : quasi_conformal(memory), area_ratio(memory) {}

  Array<double> quasi_conformal;  // sigma_max / sigma_min, infinite where the surface triangle is degenerate
  Array<double> area_ratio;       // solid angle / surface area
};

// Measures `directions` (one a vertex; normalized before use) of the surface. O(n). `faces` may be null.
// Throws Error invalid-argument on sizes, indices, or directions of vertices of triangles that are zero or not finite.
Measurement measure(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                    std::span<const Vector3> directions, double angle_weight, double area_weight,
                    const base::Host& host, FaceDistortion* faces = nullptr);

// Number of triangles that are not positive by exact predicates on the very coordinates given (not normalized), for a
// map that is not mirrored.
std::size_t count_not_positive(std::span<const Triangle> triangles, std::span<const Vector3> directions);

// Signed solid angle of the spherical triangle of three unit vectors (Van Oosterom and Strackee 1983).
double solid_angle(const Vector3& p, const Vector3& q, const Vector3& r);

}  // namespace orbicube::sphere_map
