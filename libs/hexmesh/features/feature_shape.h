// The surface and its feature graph in units of a cell, with queries of meshes that keep them: points along arcs,
// nearest points of arcs and of patches.
#pragma once

#include <deque>
#include <utility>

#include "hexmesh/types.h"
#include "mesh/features/feature_graph.h"
#include "mesh/search/nearest.h"

namespace orbicube::hexmesh {

class FeatureShape {
 public:
  // Keeps views of triangles and graph. Positions are multiplied by `scale`.
  FeatureShape(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
               const mesh::FeatureGraph& graph, double scale, const base::Host& host);
  FeatureShape(const FeatureShape&) = delete;
  FeatureShape& operator=(const FeatureShape&) = delete;

  const mesh::FeatureGraph& graph() const { return graph_; }
  std::size_t arcs() const { return graph_.arcs.size(); }
  std::size_t corners() const { return graph_.corners.size(); }
  std::size_t patches() const { return graph_.euler.size(); }
  std::span<const Vector3> positions() const { return positions_; }
  // The points of each sharp line that no arc has.
  std::span<const Array<Index>> lines_left_out() const { return graph_.left_out; }

  const Vector3& corner(Index c) const { return positions_[graph_.corners[c].vertex]; }
  Index other_corner(const mesh::FeatureEnd& end) const { return graph_.arcs[end.arc].corners[1 - end.end]; }
  // The angle in radians by which the chord to the point at s + window / 2 turns from that of s - window / 2.
  double turning(Index arc, double s, double window) const;
  // The arc lengths at which the sharp line of an arc bends without a corner, ascending; with those at which it goes on
  // along weaker edges.
  std::span<const double> bends(Index arc) const { return bends_[arc]; }
  std::span<const double> bends_and_fades(Index arc) const { return bends_and_fades_[arc]; }
  double length(Index arc) const { return along_[graph_.arcs[arc].end - 1]; }
  // Whether an arc shorter than `length` joins two corners.
  bool joined(Index corner, Index other, double length) const;

  // The point at an arc length.
  Vector3 point(Index arc, double s) const;
  // The arc length in another shape of the same graph, which its vertices divide alike.
  double same_place(Index arc, double s, const FeatureShape& other) const;
  // The unit direction in which an arc leaves its corner.
  Vector3 direction(const mesh::FeatureEnd& end) const;

  struct ArcPoint {
    double s = 0;
    double distance = 0;
    Vector3 position = Vector3::Zero(), tangent = Vector3::Zero();
  };
  // The nearest point of an arc, among those at arc lengths of at most `reach` from `s`.
  ArcPoint nearest_on_arc(Index arc, const Vector3& p, double s, double reach) const;
  ArcPoint nearest_on_arc(Index arc, const Vector3& p) const;

  struct PatchPoint {
    Vector3 position, normal;
  };
  // Of triangles that do not look against `facing`, if there are some: not the other side of a hole or a thin wall.
  PatchPoint nearest_on_patch(Index patch, const Vector3& p, const Vector3& facing) const;
  // The patch of the nearest triangle.
  Index nearest_patch(const Vector3& p) const;

 private:
  // The segment of an arc at an arc length, by its second vertex in graph_.vertices, and where there.
  std::pair<Index, double> segment(Index arc, double s) const;

  const mesh::FeatureGraph& graph_;
  std::span<const mesh::Triangle> triangles_;
  Array<Vector3> positions_;
  Array<double> along_;  // arc length of each of graph_.vertices
  Array<Array<double>> bends_, bends_and_fades_;
  base::Groups<mesh::Triangle, Index> by_patch_;
  Array<Vector3> normals_;                    // of by_patch_.all()
  std::deque<mesh::SurfaceSearch> searches_;  // of each patch
  mesh::SurfaceSearch whole_;
};

}  // namespace orbicube::hexmesh
