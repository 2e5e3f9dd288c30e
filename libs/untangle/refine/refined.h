// Meshes untangled with splits where the mesh as it is has no solution, or none is found: a triangle with all of its
// vertices on one straight side of a fixed boundary is never positive, nor is an edge inside of a star-shaped polygon
// that joins two boundary vertices which do not see each other.
#pragma once

#include "untangle/refine/split_mesh.h"
#include "untangle/tetrahedra/untangle_tetrahedra.h"
#include "untangle/triangles/untangle_triangles.h"

namespace orbicube::untangle {

template <std::size_t corners, class Vector>
struct Refined : UntanglingFigures {
  explicit Refined(std::pmr::memory_resource* memory)
      : elements(memory), parents(memory), origins(memory), positions(memory) {}

  Array<std::array<Index, corners>> elements;
  Array<Index> parents;            // of each element: the one that it is part of
  Array<Origin<corners>> origins;  // of each vertex; those of the mesh come first, in their order
  Array<Vector> positions;
  std::size_t rounds = 0;    // of splits that led to this mesh
  bool constructed = false;  // by star_disk.h
};

using RefinedTriangles = Refined<3, Vector2d>;
using RefinedTetrahedra = Refined<4, Vector3>;

// Untangles as untangle_triangles and untangle_tetrahedra do. Where elements stay inverted, or are positive by rounding
// alone, it splits all edges, faces and elements that join fixed vertices inside, and then, at most eight times, the
// edges of elements that stay inverted. New vertices are free, also on edges between fixed ones; edges of the boundary
// are not split. A disk of triangles whose boundary is fixed to a star-shaped polygon, all else being free, is
// untangled in any case within the precision of coordinates (star_disk.h). Returns the mesh with the fewest inverted
// elements, the coarsest of these. Figures count its elements, but for inverted_before. Throws the same errors.
RefinedTriangles untangle_refined(const TriangleProblem& mesh, const UntangleOptions& options, const base::Host& host);
RefinedTetrahedra untangle_refined(const UntangleProblem& mesh, const UntangleOptions& options, const base::Host& host);

}  // namespace orbicube::untangle
