// What distortion a region of a map has when its corner lies elsewhere on the surface (the dissertation's section 4.4,
// where each corner moves in a local patch and only what is beside it is solved again).
//
// The point of the surface that goes to the corner becomes a vertex; then everything within the region moves to the
// minimum of the distortion, unfolded around the corner (corner_region.h), while its boundary stays. Edges of the
// polycube are no obstacle, they are drawn again afterwards (corner_cut.h). At the minimum the energy changes with the
// place of that vertex alone, so its gradient is that of the few triangles around it.
#pragma once

#include <limits>

#include "polycube/corners/corner_region.h"
#include "untangle/triangles/planar_triangles.h"

namespace orbicube::polycube {

struct CornerMoveOptions {
  double area_weight = 1;
  double min_area = 0;  // that a triangle counts with, at the scale of the polycube
  int untangling_steps = 30;
  int steps = 15;          // maximum number of Gauss-Newton steps
  double min_gain = 1e-6;  // of the region's energy in a step
};

class CornerMove {
 public:
  // Keeps references. `whole_area` is that of the polycube.
  CornerMove(const CornerRegion& region, double whole_area, const CornerMoveOptions& options, const base::Host& host);

  // Where the corner may go, in `flat`: a circle about where it is.
  static constexpr double reach = 0.7;

  // The energy of the region as it is, and with the corner at a point of `flat`: infinite where no positive map was
  // found. Where the point is beside a vertex or an edge of the surface, the corner comes to lie there. `gradient`, by
  // the coordinates of the point, unless NULL.
  double energy_now() const { return energy_now_; }
  double evaluate(const Vector2d& at, Vector2d* gradient);

  // For a region around a point on an edge of the polycube: everything within at the minimum of the distortion, that
  // point like the others. Returns the energy; what then lies on the edge is found as the corner's place is.
  double relax();

  // Of the last evaluation that was finite: vertices are those of the region and, when a triangle or an edge was split,
  // one more, the last.
  struct Place {
    Index face = no_index;          // of the region, with the point
    std::array<double, 3> weights;  // of its corners
  };
  const Place& place() const { return place_; }
  Index apex() const { return apex_; }
  bool added() const { return apex_ == region_.vertices.size(); }
  Vector2d position(Index v) const { return {value_[2 * slot_[v]], value_[2 * slot_[v] + 1]}; }
  // By how many quarters corner k is rotated about the apex to be beside the others.
  int turn(std::size_t triangle, std::size_t k) const { return turns_[triangle][k]; }
  const Array<Triangle>& triangles() const { return triangles_; }
  const CornerRegion& region() const { return region_; }

 private:
  bool locate(std::span<const Vector2d> points, const Vector2d& at, double least);
  bool split();
  void start(const Vector2d& from);
  bool wind();
  void number(Index apex);
  void fill();
  Vector2d slope() const;

  const CornerRegion& region_;
  double whole_area_;
  CornerMoveOptions options_;
  const base::Host& host_;
  double energy_now_ = std::numeric_limits<double>::infinity();
  Place place_;
  Index apex_ = 0;
  Vector2d apex_flat_;
  Array<Triangle> triangles_;
  Array<std::array<int, 3>> turns_;
  Array<Vector3> space_;
  Array<double> angle_;  // in flat
  Array<Index> slot_;
  Array<double> value_;
  Array<Vector2d> relaxed_;
  untangle::PlanarTriangles planar_;
};

}  // namespace orbicube::polycube
