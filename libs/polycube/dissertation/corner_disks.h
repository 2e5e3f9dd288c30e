// Disks around corner points, in which they move (the dissertation's section 4.4): the 20 rings of triangles around a
// vertex, mapped to the unit disk.
//
// The dissertation does not say how; here the rings' outline goes to the circle by arc length and every vertex inside
// to the mean of its neighbors, which is bijective (Tutte 1963). Where 20 rings are no disk, fewer are taken.
#pragma once

#include <Eigen/Core>

#include "polycube/surface/editable_surface.h"

namespace orbicube::polycube::dissertation {

inline constexpr int disk_rings = 20;

struct CornerDisk {
  explicit CornerDisk(std::pmr::memory_resource* memory) : vertices(memory), places(memory) {}

  // The vertex nearest to a point of the disk.
  Index nearest(const Eigen::Vector2d& point) const;

  Array<Index> vertices;          // the corner point first
  Array<Eigen::Vector2d> places;  // of each, in the unit disk
  int rings = 0;
};

// Around a vertex. Throws Error "cancelled", and "degenerate" where even one ring is no disk.
CornerDisk make_disk(const EditableSurface& surface, Index center, int rings, const base::Host& host);

}  // namespace orbicube::polycube::dissertation
