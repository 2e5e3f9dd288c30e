// A surface filled with tetrahedra for a map of the solid: made coarser where it is fine, and fine enough inside.
#pragma once

#include <functional>
#include <span>

#include "mesh/mesh.h"
#include "volume_map/input/coarse_surface.h"

namespace orbicube::volume_map {

// Fills a closed surface with tetrahedra of no more than a volume: the vertices of the surface, to the bit and in their
// order, then further ones, and the tetrahedra. The surface stays as it is. Throws Error where that cannot be done.
using FillSurface =
    std::function<mesh::Mesh(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                             double max_volume, const base::Host& host)>;

struct FilledSolid {
  explicit FilledSolid(std::pmr::memory_resource* memory) : solid(memory), surface(memory) {}

  mesh::Mesh solid;                     // the vertices of the surface first
  base::Array<mesh::Triangle> surface;  // its boundary
};

// Of a closed surface. If it has more than twice `triangles` triangles (0: never), the surface of the solid has about
// that many, or more where that few would meet themselves; fewer where all of them do. Throws what `fill` does with all
// of them, and Error "unsupported" where there is no such function.
FilledSolid filled_solid(const mesh::Mesh& surface, std::size_t triangles, const FillSurface& fill,
                         const base::Host& host);

}  // namespace orbicube::volume_map
