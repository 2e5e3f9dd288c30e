// Grid-based hexahedra that keep the feature graph of a surface: cells of a grid with a layer around, the graph
// embedded in the edges of their boundary, a ring of hexahedra along the border of each patch, and a deformation that
// brings corners, arcs and patches to those of the surface without folding.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "hexmesh/captured/feature_figures.h"
#include "hexmesh/strategies/hex_draft.h"
#include "mesh/features/feature_graph.h"

namespace orbicube::hexmesh {

struct FeatureHexOptions {
  std::size_t cells = 10000;        // about
  std::size_t max_cells = 100'000;  // where short arcs and gaps need more
  double distance = 1;              // as in HexOptions
  int rounds = 40;                  // of fitting
  double bound = 1;                 // of scaled Jacobians, by the features (feature_bound.h)
  bool once = false;                // no other cells where a fit fails or lacks arcs, only where it is too far away
  // Of a mesh; while it has less than 99 percent of the length, the missing arcs get smaller cells.
  std::function<FeatureFigures(const HexMesh&)> measure;
  // The time is proportional to these: hexahedra of all fits, and cells of all grids, those outside of the solid too.
  std::size_t max_fitted = SIZE_MAX, max_visited = SIZE_MAX;
};

// A certified mesh whose quads have the patches of the graph, or none, with what was in the way and where.
struct FeatureHexes {
  explicit FeatureHexes(std::pmr::memory_resource* memory) : result(memory), arcs_in_the_way(memory) {}

  HexResult result;
  bool found = false;
  std::size_t fitted = 0, visited = 0;  // as in the options
  std::string obstacle;
  Array<Index> arcs_in_the_way;  // of the graph; those at corners in the way are some of them
};

// Makes a mesh of the closed surface of one solid, outward-oriented, of a size near 1, with a graph that has arcs. The
// same for any number of threads. Throws Error "cancelled".
FeatureHexes feature_hexahedra(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                               const mesh::FeatureGraph& graph, const FeatureHexOptions& options,
                               const base::Host& host);

}  // namespace orbicube::hexmesh
