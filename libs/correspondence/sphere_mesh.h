// One triangulation of the common sphere for shapes whose spheres are in line, and what it is on each shape.
#pragma once

#include <deque>
#include <vector>

#include "correspondence/sphere_alignment.h"
#include "sphere_map/correspondence/correspondence.h"
#include "sphere_map/sampling/grids.h"

namespace orbicube::correspondence {

// The triangulation of the common sphere that all shapes get, without vertices in no triangle.
struct CommonMesh {
  explicit CommonMesh(std::pmr::memory_resource* memory) : directions(memory), triangles(memory) {}

  base::Array<mesh::Vector3> directions;
  base::Array<mesh::Triangle> triangles;
  std::vector<base::Array<mesh::Index>> own_vertex;  // one a shape: its vertex at each one, no_index for none
  std::size_t edges_of_others = 0;                   // of an overlay: edges of the further shapes,
  std::size_t edges_kept = 0;                        // and how many of these are edges of the result
};

// A pointer to each shape; the first one is what the others are compared with.
using SphereShapes = std::vector<const SphereShape*>;

// Returns the vertices of all shapes, on the triangles of the first. Edges along which a further shape deviates by more
// than `tolerance`, in parts of its diagonal, are halved, up to three times the number of vertices; 0: none is.
CommonMesh overlay_of(const SphereShapes& shapes, double tolerance, const base::Host& host);

// Returns the triangles of the first shape.
CommonMesh mesh_of_first(const SphereShapes& shapes, const base::Host& host);

// Returns a grid of the sphere.
CommonMesh mesh_of_grid(const SphereShapes& shapes, sphere_map::GridKind kind, std::size_t resolution,
                        const base::Host& host);

// Returns the common mesh on shape number i.
sphere_map::CarriedShape carry_to_shape(const SphereShape& shape, const CommonMesh& common, std::size_t i,
                                        const base::Host& host);

// Returns how much areas change from one state to another, both scaled to the same whole: the root mean square of the
// logarithm of the ratio, by the area of the first.
double area_distortion(std::span<const mesh::Triangle> triangles, std::span<const mesh::Vector3> from,
                       std::span<const mesh::Vector3> to);

}  // namespace orbicube::correspondence
