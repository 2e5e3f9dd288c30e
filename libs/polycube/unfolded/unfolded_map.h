// A map to a polycube as the polycube's surface itself sees it: flat everywhere but at the corners, so that edges of
// the polycube do not matter. A vertex may cross them like any other line, and the map can be smoothed across them and
// across faces ("flattened neighborhoods" of the dissertation's 4.2.2) with corners as the only points that stay.
//
// Each triangle and each vertex has a plane of its own in which it is seen. From a vertex's plane to that of a triangle
// at it leads a turn by quarters and a shift, for the polycube's angles are all right ones. These never change while
// vertices move; so as long as every triangle stays positive on the way, the triangles together go on being the surface
// of the same polycube, without its edges being anywhere on the triangles. polycube_edges.h finds them again.
#pragma once

#include "polycube/surface/editable_surface.h"
#include "polycube/surface/quarter_turns.h"

namespace orbicube::polycube {

// A turn by quarters counter-clockwise, and then a shift.
struct PlaneMotion {
  Vector2d operator()(const Vector2d& p) const { return turned_by(p, quarters) + shift; }
  PlaneMotion inverse() const { return {(4 - quarters) % 4, -turned_by(shift, -quarters)}; }
  // First `other`, then this one.
  PlaneMotion after(const PlaneMotion& other) const {
    return {(quarters + other.quarters) % 4, turned_by(other.shift, quarters) + shift};
  }

  int quarters = 0;
  Vector2d shift = Vector2d::Zero();
};

// A patch of the polycube: its plane, and how points of space are seen in it from outside.
struct UnfoldedPatch {
  Vector2d flat(const Vector3& p) const {
    return {p[(axis_of(label) + 1) % 3], sign_of(label) * p[(axis_of(label) + 2) % 3]};
  }
  Vector3 in_space(const Vector2d& p) const {
    Vector3 result;
    result[axis_of(label)] = plane;
    result[(axis_of(label) + 1) % 3] = p.x();
    result[(axis_of(label) + 2) % 3] = sign_of(label) * p.y();
    return result;
  }

  AxisLabel label = 0;
  double plane = 0;  // along the axis of the label
};

// An edge of the polycube that leaves a corner.
struct UnfoldedDart {
  Index corner, target;  // numbers of corners
  int quarters;          // its angle at the corner, counter-clockwise from the corner's first dart
  Index facet;           // on its left
  Vector3 direction;     // along it in space, a unit vector
};

struct UnfoldedCorner {
  Index vertex;
  Vector3 place;               // on the polycube
  int quarters;                // all around
  Index dart_begin, dart_end;  // counter-clockwise
  // The edge of a triangle by which angles around the corner are counted: its other end, its angle from the first dart,
  // and the direction that it had in the plane of the triangle on its left when that was last looked at.
  Index end;
  double angle;
  Vector2d direction;
  bool held = false;  // stays at its vertex
};

// What draws a vertex to a place in its plane: weight times the squared distance, along one of the coordinates or both.
struct PlaneTie {
  Vector2d place;
  std::array<double, 2> weight;

  double energy(const Vector2d& at) const {
    const Vector2d d = at - place;
    return weight[0] * d.x() * d.x() + weight[1] * d.y() * d.y();
  }
};

class UnfoldedMap {
 public:
  // Of a certified map, whose labels and patches are set.
  UnfoldedMap(const SurfaceMap& map, const base::Host& host);

  // Where the half-edge starts, in the plane of its triangle.
  Vector2d at(Index h) const { return motion[h](image[surface.start(h)]); }
  bool is_corner(Index v) const { return corner_at[v] != no_index; }
  bool is_free(Index v) const { return held[v] == 0 && tie_at[v] == no_index; }
  // From the plane of the half-edge's triangle to that of the triangle beyond it.
  PlaneMotion across(Index h) const;

  // Of the half-edge's triangle at its start.
  double angle_at(Index h) const;

  // EditableSurface::collapse and split_edge, with planes; a new vertex is put where the edge is.
  void collapse(Index h);
  Index split_edge(Index h, double part);

  // Notes how far edges have turned around corners, which must be called before any has turned by half a turn.
  void follow_corners();
  void follow(UnfoldedCorner& corner) const;

  EditableSurface surface;
  Array<PlaneMotion> motion;  // of each half-edge: from the plane of its start to that of its triangle
  Array<Vector2d> image;      // of each vertex, in its plane
  Array<Index> corner_at;     // of each vertex: the number of the corner, or no_index
  // Of each vertex: the coordinates in its plane that stay, 1 for the first and 2 for the second, and its tie, or
  // no_index. Vertices with either are not taken out and do not become corners.
  Array<std::uint8_t> held;
  Array<Index> tie_at;
  Array<PlaneTie> ties;
  Array<UnfoldedPatch> facets;
  Array<UnfoldedCorner> corners;
  Array<UnfoldedDart> darts;

 private:
  void find_corners(const SurfaceMap& map);
  void add_darts(const SurfaceMap& map, UnfoldedCorner& corner);
  void leave(Index corner, Index vertex, Index first_face, Index second_face);
};

}  // namespace orbicube::polycube
