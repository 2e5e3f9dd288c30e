// The coarsest graded grid that the feature graph embeds in. Embedding takes a small part of the time that fitting
// does, so cells are made smaller only where an attempt failed, in many attempts.
#pragma once

#include <memory>

#include "hexmesh/features/grading/feature_demands.h"
#include "hexmesh/features/grading/graded_cells.h"
#include "mesh/search/measures.h"

namespace orbicube::hexmesh {

struct EmbeddedCells {
  // Kept for each other.
  std::unique_ptr<AxisGrading> grading;
  std::unique_ptr<GradedSurface> surface;
  std::unique_ptr<GradedCells> cells;
};

class GradedSearch {
 public:
  // Of about `cells` hexahedra, and up to `max_cells` where the graph requires more. All grids together have at most
  // `max_visited` cells, those outside of the solid included. Keeps views of the surface.
  GradedSearch(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
               const mesh::FeatureGraph& graph, double cells, double max_cells, double max_visited,
               const base::Host& host);

  // The next grid with the graph embedded, or none, with what was in the way of the last attempt in obstacles().
  std::optional<EmbeddedCells> next();
  std::span<const FeatureObstacle> obstacles() const { return obstacles_; }
  double cells() const { return hexahedra_; }  // about, of the last attempt
  double visited() const { return visited_; }  // cells of all grids

  // Requests smaller cells: at what was in the way of a mesh, or of all sizes.
  void refine_at(std::span<const FeatureObstacle> obstacles, double factor);
  void refine_everywhere(double factor);
  // Requests cells of at most `size` between two points, as AxisGrading::refine().
  void refine_between(const Vector3& from, const Vector3& to, double size) { small_.push_back({from, to, size}); }

 private:
  struct SmallCells {
    Vector3 from, to;
    double size;
  };

  void require_fewer_cells();
  void set_obstacle(std::string why);
  // Return whether they change anything.
  bool strengthen(Index arc, double factor);
  bool strengthen_at(const FeatureObstacle& obstacle, double factor);

  std::span<const Vector3> positions_;
  std::span<const mesh::Triangle> triangles_;
  const mesh::FeatureGraph& graph_;
  const base::Host& host_;
  const mesh::Measures whole_;  // of the surface
  double base_cells_, max_cells_, hexahedra_ = 0;
  const double max_visited_;
  double visited_ = 0;
  const FeatureShape shape_;
  const FeatureDemands demands_;
  Array<double> strength_;  // of each arc
  Array<SmallCells> small_;
  double wider_ = 1;  // cells along bends than they should be
  int attempts_ = 0;
  Array<FeatureObstacle> obstacles_;
};

}  // namespace orbicube::hexmesh
