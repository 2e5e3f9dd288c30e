// A voxel polycube of a closed surface, of any genus, whose topology is certified: its surface is a manifold, it has
// one inside and one outside component, and the genus of the input (the dissertation's 4.2.1, which leaves the topology
// to chance).
//
// Grids from coarse to fine and thresholds on how much of a cell is inside are tried until one is right, and near
// enough: thin protrusions must not be lost.
#pragma once

#include <cstdint>
#include <optional>

#include "polycube/voxels/occupancy.h"
#include "polycube/voxels/voxel_solid.h"

namespace orbicube::polycube {

// Cells along the longest axis of the grid by which cell fractions are counted.
inline constexpr int occupancy_resolution = 240;

struct Voxelisation {
  Voxelisation(VoxelSolid made, std::pmr::memory_resource* memory) : solid(std::move(made)), fraction(memory) {}

  VoxelSolid solid;
  Array<float> fraction;  // how much of each cell is inside the surface
  int cells = 0;          // along the longest axis
  double threshold = 0;
  double farthest = 0;  // distance of the farthest vertex of the input from the solid, in parts of the longest axis
};

struct VoxelisationOptions {
  int min_cells = 40;   // along the longest axis; coarser grids are only tried when no finer one is right
  int max_cells = 140;  // likewise
  double far = 0.05;    // the farthest vertex that is near enough
};

// By one grid, of the given number of cells along the longest axis: the first of several thresholds that gives the
// topology of the surface and has no vertex of it farther than `far`, or that with the nearest; nothing when none has
// the topology. The surface may have cavities: parts that are inward-oriented; `genus` then is that of all parts
// together.
std::optional<Voxelisation> voxelise_by_grid(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                             std::int64_t genus, std::size_t cavities, const Occupancy& occupancy,
                                             int cells, double far, const base::Host& host);

// The surface must be closed, connected and outward-oriented; `genus` is its genus. Throws Error "no-valid-result" when
// no grid gives the right topology, "cancelled".
Voxelisation voxelise(std::span<const Vector3> positions, std::span<const Triangle> triangles, std::int64_t genus,
                      const Occupancy& occupancy, const VoxelisationOptions& options, const base::Host& host);

}  // namespace orbicube::polycube
