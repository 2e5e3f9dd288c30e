// Cells of a graded grid with the feature graph embedded in the edges of their boundary, and a ring of hexahedra along
// the border of each patch.
#pragma once

#include <optional>

#include "hexmesh/features/embedding.h"
#include "hexmesh/features/feature_fitting.h"
#include "hexmesh/features/grading/axis_grading.h"
#include "hexmesh/features/grading/split_surface.h"

namespace orbicube::hexmesh {

// The surface with its graph in numbers of cells.
struct GradedSurface {
  GradedSurface(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                const mesh::FeatureGraph& graph, const AxisGrading& grading, const base::Host& host);

  const AxisGrading& grading;
  SplitSurface in_space;  // its edges split where they bend in cells
  Array<Vector3> cells;   // of the vertices
  double volume = 0;      // in cells
};

// Where the graph is embedded, the mesh is in numbers of cells times a scale until move_to_space().
class GradedCells {
 public:
  // Keeps a reference to the surface. Throws Error "no-valid-result" as voxel_hexahedra() does.
  GradedCells(const GradedSurface& surface, const base::Host& host);

  // Returns what is in the way; nothing: the graph is embedded.
  Array<FeatureObstacle> embed();
  // After embed(), once: moves the mesh to space. Lengths there are multiplied by unit().
  void move_to_space();
  // After move_to_space().
  double unit() const { return unit_; }
  HexMesh& mesh() { return mesh_; }
  const HexMesh& mesh() const { return mesh_; }
  const FeatureShape& shape() const { return *in_space_; }
  const BoxSizes& sizes() const { return sizes_; }
  FeatureTargets& targets() { return *targets_; }

 private:
  std::optional<FeatureObstacle> add_rings(const BoundaryQuads& quads);

  const base::Host& host_;
  const GradedSurface& surface_;
  HexMesh mesh_;
  double scale_ = 1, unit_ = 1;
  std::optional<FeatureShape> in_cells_, in_space_;
  Embedding embedding_;
  BoxSizes sizes_;
  std::optional<FeatureTargets> targets_;
};

}  // namespace orbicube::hexmesh
