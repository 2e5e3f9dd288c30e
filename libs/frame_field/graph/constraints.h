// Which frames are not free: those with a face on the boundary have an axis along its normal, others may be given.
//
// A tetrahedron with several boundary faces is aligned with one of them exactly: the one with the largest area to
// begin with, and another of them when that makes the field smoother (smoothing.h). Where two of its normals are
// neither nearly alike (5 degrees) nor nearly perpendicular, no frame has axes along both: then it may also be a
// direction between them, or the edge that they share, that the axis lies along.
//
// A constraint with a weight is soft, like a link of that weight to the nearest frame that has
// what is given. It may lie on a tetrahedron that has a constraint too.
#pragma once

#include <cmath>
#include <span>

#include "frame_field/graph/dual_graph.h"
#include "frame_field/smoothing/harmonic_frame.h"

namespace orbicube::frame_field {

struct Constraint {
  Index node;
  bool fixed;        // the whole frame is given; otherwise one axis is
  Quaternion frame;  // one that satisfies the constraint
  Vector direction;  // of the axis, a unit vector
};

// What the caller requires besides the boundary, by tetrahedron.
inline constexpr double held = HUGE_VAL;  // the weight of what is fixed
struct GivenFrame {
  Index tetrahedron;
  Quaternion frame;
  double weight = held;  // in links between tetrahedra
};
struct GivenAxis {
  Index tetrahedron;
  Vector direction;  // unit
  double weight = held;
};

// What a frame is pulled to.
struct Pull {
  Index node;
  bool whole;        // the frame; otherwise one of its axes to the direction
  Quaternion frame;  // one that satisfies the constraint
  Vector direction;
  double weight;
};

struct Constraints {
  explicit Constraints(std::pmr::memory_resource* memory)
      : list(memory), of_node(memory), alternatives(memory), pulls(memory) {}
  Constraints(const Constraints& other, std::pmr::memory_resource* memory)
      : list(other.list, memory),
        of_node(other.of_node, memory),
        alternatives(other.alternatives, memory),
        pulls(other.pulls, memory) {}
  Constraints(Constraints&&) = default;

  bool is_free(std::size_t node) const { return of_node[node] == no_index; }

  Array<Constraint> list;  // in ascending order of nodes
  Array<Index> of_node;    // no_index for a free one
  // Further directions for tetrahedra with several boundary faces, in ascending order of `constraint`.
  struct Alternative {
    Index constraint;
    Vector direction;
  };
  Array<Alternative> alternatives;
  Array<Pull> pulls;  // in ascending order of nodes

  // Those of a node.
  std::span<const Pull> pulls_at(Index node) const;
};

// Given frames come before given axes and these before the boundary. O(n). Frames and axes must be units.
Constraints make_constraints(const DualGraph& graph, std::span<const Vector3> positions,
                             const mesh::TetrahedralConnectivity& connectivity, bool align_boundary,
                             std::span<const GivenFrame> given_frames, std::span<const GivenAxis> given_axes,
                             const base::Host& host);

// `frame` turned as little as possible so that its axis next to `direction` lies along it.
Quaternion aligned(const Quaternion& frame, const Vector& direction);

// The nearest frame that has what the pull wants, and what its link to the present frame is worth: weight x sin^2 of
// half the angle between both.
Quaternion target(const Pull& pull, const Quaternion& frame);
double worth(const Pull& pull, const Quaternion& frame);

// Turns every constrained frame by as little as possible so that it satisfies its constraint to rounding.
void satisfy(const Constraints& constraints, Field& field);

}  // namespace orbicube::frame_field
