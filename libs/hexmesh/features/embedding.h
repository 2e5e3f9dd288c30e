// The feature graph among the edges of the boundary of a mesh: corners at vertices, arcs along edges, patches as
// regions of quads. Each step says what stops it.
#pragma once

#include <optional>
#include <string>

#include "hexmesh/features/boundary_quads.h"
#include "hexmesh/features/feature_shape.h"

namespace orbicube::hexmesh {

// Cells: corners that a shorter arc joins may be closer to each other than others.
inline constexpr double short_arc = 3.5;

struct Embedding {
  explicit Embedding(std::pmr::memory_resource* memory)
      : corner_vertices(memory), arc_ends(memory), fixed(memory), paths(memory), quad_patches(memory) {}

  Array<Index> corner_vertices;          // of each corner
  Array<std::array<Index, 2>> arc_ends;  // of each arc, the vertex next to each of its corners
  Array<Array<Index>> fixed;             // of each arc, the path that it must have; empty: any
  Array<Array<Index>> paths;             // of each arc, its vertices, those of its corners included
  Array<Index> quad_patches;             // of each quad
};

// A corner or an arc that the mesh cannot have, and why.
struct FeatureObstacle {
  Index corner = no_index, arc = no_index;
  std::string why;
};

// Corners to vertices, those with most arcs first: near, with an edge for each arc, in the directions of the arcs, and
// two rings apart unless a short arc joins them.
std::optional<FeatureObstacle> place_corners(const HexMesh& mesh, const BoundaryQuads& quads, const FeatureShape& shape,
                                             Embedding& embedding, const base::Host& host);

// Chooses the first edge of each arc at its corners, in the cyclic order of the arcs, with fixed paths as they are.
// Vertices with too few edges gain some by hexahedra that are pillowed: mesh and quads change.
std::optional<FeatureObstacle> choose_arc_ends(HexMesh& mesh, BoundaryQuads& quads, const FeatureShape& shape,
                                               Embedding& embedding, const base::Host& host);

// What stopped the paths of arcs: nothing, or arcs that have none.
struct Routing {
  explicit Routing(std::pmr::memory_resource* memory) : obstacles(memory) {}

  Array<FeatureObstacle> obstacles;
  bool choose_again = false;  // arcs that first edges of others shut in have fixed paths now: choose the ends again
};

// Paths along edges, disjoint but for corners, by shortest paths with negotiated congestion (McMurchie and Ebeling
// 1995, "PathFinder"): vertices may be shared at a price that rises until no path shares one. `price` is what the
// square of the distance to the arc, in cells, costs besides lengths.
Routing route_arcs(const HexMesh& mesh, const BoundaryQuads& quads, const FeatureShape& shape, double price,
                   Embedding& embedding, const base::Host& host);

// Fills the regions between the paths and sets the patches of the quads. There must be one region for each patch, with
// the same arcs on the same sides and the same Euler characteristic.
std::optional<FeatureObstacle> match_patches(const HexMesh& mesh, const BoundaryQuads& quads, const FeatureShape& shape,
                                             Embedding& embedding, const base::Host& host);

}  // namespace orbicube::hexmesh
