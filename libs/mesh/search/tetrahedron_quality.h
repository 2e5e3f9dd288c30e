// How well shaped tetrahedra are: dihedral angles, ratios of radii, volumes with exact signs, and histograms.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// Of one tetrahedron, whichever way it is turned; lengths and volume as large as its coordinates make them. What a flat
// tetrahedron has none of is 0, but for radius_edge, which is infinite.
struct TetrahedronShape {
  double volume = 0;        // not negative
  double radius_ratio = 0;  // 3 * inradius / circumradius: 1 for a regular one
  double radius_edge = 0;   // circumradius / shortest edge: sqrt(6) / 4 for a regular one
  double min_edge_length = 0, max_edge_length = 0;
  std::array<double, 6> dihedral_angles{};  // at its edges, in degrees: arccos(1/3) = 70.5 for a regular one
};
TetrahedronShape shape_of(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

struct TetrahedronQuality {
  std::size_t tetrahedra = 0;
  std::size_t positive = 0, flat = 0, inverted = 0;    // by exact arithmetic
  double volume = 0;                                   // of all, those of inverted ones negative
  double min_volume = 0, max_volume = 0;               // those of inverted ones negative
  double min_dihedral = 0, max_dihedral = 0;           // degrees
  double mean_min_dihedral = 0;                        // the mean of each one's smallest
  double min_radius_ratio = 0, mean_radius_ratio = 0;  // those of inverted ones negative, of flat ones 0
  double max_radius_edge = 0, mean_radius_edge = 0;    // the mean of those that are not flat
  double min_edge_length = 0, max_edge_length = 0;
  Index worst = no_index;                                // the first one with the smallest radius ratio
  std::array<std::size_t, 18> dihedral_histogram{};      // six angles each: [0, 10), [10, 20), ... degrees
  std::array<std::size_t, 20> radius_ratio_histogram{};  // [0, 0.05), [0.05, 0.1), ...; below 0 in the first
};

// All is 0 without tetrahedra. Volumes beyond the range of double are infinite. Throws Error "index-range" for a vertex
// that does not exist, "cancelled". O(n), about 0.3 us each.
TetrahedronQuality tetrahedron_quality(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                                       const base::Host& host);

}  // namespace orbicube::mesh
