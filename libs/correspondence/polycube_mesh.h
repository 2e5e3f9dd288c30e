// One triangulation of a common polycube, and what it is on each shape.
#pragma once

#include <span>

#include "polycube/domain/common_polycube.h"
#include "polycube/outputs/inverse_map.h"
#include "polycube/outputs/quad_mesh.h"

namespace orbicube::correspondence {

// The triangulation of the polycube that all shapes get.
struct PolycubeMesh {
  explicit PolycubeMesh(std::pmr::memory_resource* memory)
      : polycube(memory), triangles(memory), labels(memory), quads(memory) {}

  base::Array<mesh::Vector3> polycube;
  base::Array<mesh::Triangle> triangles;
  base::Array<polycube::AxisLabel> labels;
  base::Array<polycube::Quad> quads;  // of the grid, two triangles each; none for the triangles of a map
};

// Returns the number of quads of the polycube's grid for shapes of which the largest has this many triangles.
std::size_t cells_for(std::size_t max_triangles);

// Returns halves of about `cells` quads of the polycube's grid; for 0 cells, the triangles of the first shape's map.
// Throws Error "cancelled", "no-valid-result" when a triangle is flipped on the polycube: each map is certified, so
// what is positive on the polycube is covered once on every shape.
PolycubeMesh triangles_on(const polycube::CommonPolycube& common, std::size_t cells, const base::Host& host);

// Returns the positions of the mesh on a shape. Throws Error "internal", "cancelled".
base::Array<mesh::Vector3> positions_on(const polycube::SurfaceMap& map, const PolycubeMesh& common,
                                        const base::Host& host);

// Returns the polycube itself at the size and place of a shape: of its area, and with its center of area.
base::Array<mesh::Vector3> polycube_beside(const PolycubeMesh& common, std::span<const mesh::Vector3> shape,
                                           const base::Host& host);

// Returns a point of a shape within each triangle, whose vertices are at `positions` there.
base::Array<mesh::Vector3> middles_on(const polycube::SurfaceMap& map, const PolycubeMesh& common,
                                      std::span<const mesh::Vector3> positions, const base::Host& host);

}  // namespace orbicube::correspondence
