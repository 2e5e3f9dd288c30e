// The triangles around one vertex of an unfolded map, seen in the vertex's plane, and where the vertex should go.
#pragma once

#include "polycube/surface/triangle_rest.h"
#include "polycube/unfolded/unfolded_map.h"
#include "untangle/triangles/barrier.h"

namespace orbicube::polycube {

// What triangles count for: half of the weights are areas, half the same for each triangle.
struct TriangleWeights {
  // Of the map as it is.
  explicit TriangleWeights(const UnfoldedMap& map);

  RestTriangle rest(const EditableSurface& surface, Index p, Index q, Index r) const {
    return rest_triangle(scale * (surface.position[q] - surface.position[p]),
                         scale * (surface.position[r] - surface.position[p]));
  }
  double weight(const RestTriangle& t) const { return 0.5 * t.area / area + each; }

  double scale = 1;  // of lengths in space, for equal areas
  double area = 1;   // of the polycube
  double each = 0;
};

class UnfoldedStar {
 public:
  struct Corner {
    RestTriangle rest;
    Vector2d a, b;  // the other two corners, counter-clockwise after the vertex
    double weight;
  };

  explicit UnfoldedStar(std::pmr::memory_resource* memory) : triangles(memory) {}

  // In the order of EditableSurface::for_each_outgoing, with what ties the vertex. Not for corners of the polycube.
  void gather(const UnfoldedMap& map, const TriangleWeights& weights, Index vertex);
  // With the vertex there; infinite unless all are positive.
  double energy(const Vector2d& place) const;
  bool positive(const Vector2d& place) const;
  // One safeguarded step of Newton's method from a place where all are positive, and stay so. Sets `gain` to what the
  // energy, which was `before`, falls by.
  Vector2d improved(const Vector2d& place, double& before, double& gain) const;

  Array<Corner> triangles;
  std::uint8_t held = 0;  // coordinates that stay in a step
  const PlaneTie* tie = nullptr;
};

}  // namespace orbicube::polycube
