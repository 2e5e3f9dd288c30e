// The figures of a field: energy and angles over inner faces, with the cube's symmetry counted and without, and how far
// boundary frames are from the normals.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/host.h"
#include "frame_field/graph/dual_graph.h"

namespace orbicube::frame_field {

// Angles in degrees.
struct AngleStatistics {
  double mean = 0, deviation = 0, median = 0, p99 = 0, largest = 0;  // p99: at index floor(0.99 n) in ascending order
};

struct Measurement {
  double energy = 0;          // sum 1 - s0^2 over inner faces, each counted once
  AngleStatistics symmetric;  // up to the 24 rotations: at most 62.80
  AngleStatistics plain;      // of the quaternions as they stand, up to sign: at most 180
  std::size_t inner_faces = 0, boundary_faces = 0;
  std::size_t above_30 = 0;                 // inner faces with a greater symmetric angle
  std::array<std::size_t, 64> histogram{};  // inner faces by symmetric angle, a degree each

  // Angle between the boundary normal and the axis nearest to it.
  std::size_t one_face_tetrahedra = 0, several_face_tetrahedra = 0;
  double one_face_max = 0, one_face_mean = 0;
  double several_best_max = 0;   // largest over tetrahedra of the minimum over their faces
  double several_worst_max = 0;  // largest over tetrahedra of the largest over their faces
  double norm_error = 0;         // largest | |q| - 1 |
};

// Field by tetrahedron. O(n), 16 bytes a tetrahedron. Throws Error "cancelled".
Measurement measure(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                    std::span<const Quaternion> field, const base::Host& host);

}  // namespace orbicube::frame_field
