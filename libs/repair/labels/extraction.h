// The surface between an object of voxels and its background.
#pragma once

#include "base/host.h"
#include "repair/labels/crossings.h"
#include "repair/labels/voxels.h"
#include "repair/types.h"

namespace orbicube::repair {

// Vertices are on edges between voxel centers or centroids of a loop of these.
struct VoxelSurface {
  explicit VoxelSurface(std::pmr::memory_resource* memory)
      : edge_voxel(memory),
        edge_axis(memory),
        crossing(memory),
        loop_start(1, 0, memory),
        loop(memory),
        triangles(memory) {}

  std::size_t vertex_count() const { return crossing.size(); }

  // Of each vertex: the edge's first voxel, its axis and where the vertex is on it; axis 3 for the centroid of the loop
  // with the number edge_voxel.
  Array<VoxelIndex> edge_voxel;
  Array<std::uint8_t> edge_axis;
  Array<double> crossing;
  Array<std::size_t> loop_start;
  Array<Index> loop;
  Array<Triangle> triangles;  // outward-oriented
};

// Extracts a closed, oriented, manifold surface with the topology of the object's boundary: object connected through
// faces, background through corners. O(voxels). Throws Error "unsupported" for more vertices than an index can tell,
// "cancelled".
VoxelSurface extract_surface(const Voxels& voxels, const SmoothedVoxels& smoothed, double max_slide,
                             const base::Host& host);

// Returns the position of a vertex in voxels: the center of voxel (x, y, z) is at these coordinates.
Vector3 place_of(const VoxelSurface& surface, const Voxels& voxels, Index vertex);

}  // namespace orbicube::repair
