// The singular structure of a field (Nieser, Reitebuch, Polthier 2011, "CubeCover"): how the frames on both sides of a
// face match, what their composition around an edge is, and the curves and nodes that edges with another one than
// identity form.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/host.h"
#include "frame_field/graph/dual_graph.h"
#include "quaternion/cube_group.h"

namespace orbicube::frame_field {

// By face number 4 t + k: the rotation g of the cube for which the frame of t, turned by g in its own axes, is nearest
// to that of the neighbor; 0 on the boundary. Both sides of a face hold inverse rotations. O(n).
Array<std::uint8_t> matchings(const mesh::TetrahedralConnectivity& connectivity, std::span<const Quaternion> field,
                              const base::Host& host);

// The cosine between the axis about which frames turn around an edge, by the composed matchings of the edge's ring, and
// the edge's direction: positive where cells meet in threes. The mean over the ring's `count` tetrahedra, so that no
// one of them has to come first. `rotation` is composed from the first on; frame(k) and matching(k) are those of
// tetrahedron k and of the face that leads on from it.
template <class Frame, class Matching>
double turn_along(std::size_t count, std::uint8_t rotation, const Vector3& along, const Frame& frame,
                  const Matching& matching) {
  using quaternion::cube_group;
  Vector3 sum = Vector3::Zero();
  std::uint8_t passed = 0;
  for (std::size_t k = 0; k < count; ++k) {
    // Going round the edge right-handed, the frame that is carried along turns by the inverse of the composed
    // matchings: about the edge's direction by the index of the singularity, so right-handed where cells meet in
    // threes.
    const std::uint8_t from_here = cube_group.product[cube_group.product[cube_group.inverse[passed]][rotation]][passed];
    const quaternion::Quaternion& carried = cube_group.element[cube_group.inverse[from_here]];
    const double sign = carried.w < 0 ? -1 : 1;
    const Vector axis = quaternion::rotate(frame(k), {sign * carried.x, sign * carried.y, sign * carried.z});
    sum += Vector3(axis.x, axis.y, axis.z);
    passed = cube_group.product[passed][matching(k)];
  }
  const quaternion::Quaternion& element = cube_group.element[rotation];
  const double length = std::sqrt(element.x * element.x + element.y * element.y + element.z * element.z);
  const double scale = length * along.norm() * static_cast<double>(count);
  return scale > 0 ? sum.dot(along) / scale : 0;
}

struct SingularEdge {
  mesh::Edge vertices;
  Index tetrahedron;      // the first of the ring
  std::uint8_t rotation;  // of the ring's matchings composed, in the frame of that tetrahedron
  std::int8_t turn;       // of a rotation about one axis, along the edge as seen from vertices[0]: +1 where cells meet
                          // in threes (index 1/4), -1 in fives, 2 for half turns; 0 for other rotations
  double length;
  quaternion::CubeClass kind() const { return quaternion::cube_group.conjugacy_class[rotation]; }
};

struct SingularGraph {
  explicit SingularGraph(std::pmr::memory_resource* memory)
      : edges(memory),
        curve_edges(memory),
        curve_begin(memory),
        curve_closed(memory),
        nodes(memory),
        dead_ends(memory) {}

  std::size_t curves() const { return curve_closed.size(); }
  std::span<const Index> curve(std::size_t c) const {
    return {curve_edges.data() + curve_begin[c], curve_begin[c + 1] - curve_begin[c]};
  }

  Array<SingularEdge> edges;
  std::array<std::size_t, 5> by_class{};  // numbers of edges, by CubeClass; none are of the class identity
  // Curves are the longest chains of edges through inner vertices with exactly two singular edges; in order from end to
  // end, or all the way round.
  Array<Index> curve_edges;
  Array<std::size_t> curve_begin;
  Array<std::uint8_t> curve_closed;
  Array<Index> nodes;             // inner vertices with three singular edges or more, ascending
  Array<Index> dead_ends;         // inner vertices with one; no field has any, so one shows a mesh that is no solid
  std::size_t boundary_ends = 0;  // boundary vertices with singular edges
  std::size_t inner_edges = 0;    // of the mesh
  double inner_length = 0, singular_length = 0;
};

// O(n), about 60 bytes a tetrahedron. Throws Error "cancelled".
SingularGraph singular_graph(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                             std::span<const Quaternion> field, std::span<const std::uint8_t> matchings,
                             const base::Host& host);
// The same with the rings of edges at hand.
SingularGraph singular_graph(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                             const mesh::EdgeRings& rings, std::span<const Quaternion> field,
                             std::span<const std::uint8_t> matchings, const base::Host& host);

}  // namespace orbicube::frame_field
