// The volumetric parameterization of the dissertation's chapter 5 (CubeCover of Nieser, Reitebuch and Polthier 2011):
// each tetrahedron is a chart, and coordinates f minimize
//   E = sum of volume |grad f - X|^2                      (eq. 5.3)
// for the frames X, subject to the transitions f_j = M_ij f_i + g_ij across faces (eqs. 5.7 to 5.10) and to what
// follows from them around singular edges (eq. 5.11). One coordinate is constant on each part of the boundary.
#pragma once

#include "volume_map/frames/framed_solid.h"

namespace orbicube::volume_map {

struct ParameterizationOptions {
  double cell_length = 0;  // in space, of a step of 1 of the coordinates; 0: that of some 10000 cells
  bool integer = false;    // whether gaps, planes of the boundary and singular edges become integers
};

struct Parameterization {
  explicit Parameterization(std::pmr::memory_resource* memory)
      : frames(memory),
        corners(memory),
        rotation(memory),
        gap(memory),
        cut(memory),
        label(memory),
        patch(memory),
        singular_edges(memory) {}

  Array<Quaternion> frames;               // of each tetrahedron, named alike where faces are not cut
  Array<std::array<Vector3, 4>> corners;  // of each tetrahedron: coordinates of its corners in its chart
  Array<std::uint8_t> rotation;           // of each face 4 t + k: number of the rotation M from chart t to the next one
  Array<Vector3> gap;                     // of each face: g
  Array<std::uint8_t> cut;                // of each face: 1 where M or g may differ from the identity
  Array<std::uint8_t> label;              // of each face of the boundary: 2 axis + (1 where outward-oriented)
  Array<Index> patch;                     // of each face of the boundary: its part; no_index for other faces
  Array<std::array<Index, 2>> singular_edges;
  double cell_length = 0;
  double energy = 0;         // eq. 5.3 of cell_length f, over the volume of the solid
  double residual = 0;       // maximum violation of eqs. 5.8 to 5.11 and of the planes of the boundary, in steps
  double integer_cost = 0;   // what rounding added to the energy
  std::size_t inverted = 0;  // tetrahedra that are not positive, by exact signs
  std::size_t integers = 0, patches = 0, cut_faces = 0, solves = 0;
  bool integers_optimal = false;
};

// Returns the map of the solid as it is: nothing is split and nothing untangled, so that tetrahedra may be inverted.
// frames/frame_map.h makes maps without. The same for any number of threads. Throws Error "no-valid-result" with the
// place for fields that no map follows, "invalid-argument", "degenerate-geometry", "cancelled", and what
// mesh::TetrahedralConnectivity does.
Parameterization parameterize(const FramedSolid& solid, const ParameterizationOptions& options, const base::Host& host);

// Returns the maximum violation of the constraints above, from the corners alone.
double constraint_residual(const FramedSolid& solid, const Parameterization& map, const base::Host& host);

}  // namespace orbicube::volume_map
