// How tetrahedra hang together, on flat arrays: what lies across each face, the boundary, and the tetrahedra around
// each edge in order. 16 bytes a tetrahedron for the faces, about 40 more where the rings of edges are kept
// (EdgeRings).
#pragma once

#include <array>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/topology/topology.h"

namespace orbicube::mesh {

// The corners of the face opposite corner k, counter-clockwise seen from outside of a positive tetrahedron.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> face_corners = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

// The two corners of each of the six edges, and the other two in the order that makes all four an even permutation:
// seen along the edge, they follow each other clockwise.
struct EdgeCorners {
  std::uint8_t start, end, first, second;
};
inline constexpr std::array<EdgeCorners, 6> edge_corners = {
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

// Face 4 t + k is the face of tetrahedron t opposite its corner k, as seen from t: a face inside the solid has two
// numbers, one from each side.
class TetrahedralConnectivity {
 public:
  // Keeps a view of `tetrahedra`, which must be positive and have indices below vertex_count. Throws Error
  // "degenerate-cell" for a repeated corner, "non-manifold-face" for a face of three tetrahedra or more,
  // "inconsistent-orientation" for neighbors that lie on the same side of their face, all with the place,
  // "unsupported" for 2^30 tetrahedra or more, "cancelled". O(n) for bounded valence; 16 bytes a tetrahedron besides
  // what is kept.
  TetrahedralConnectivity(std::size_t vertex_count, std::span<const Tetrahedron> tetrahedra, const base::Host& host);

  std::size_t vertex_count() const { return vertex_count_; }
  std::span<const Tetrahedron> tetrahedra() const { return tetrahedra_; }
  std::size_t face_count() const { return opposite_.size(); }  // numbers, so inner faces count twice
  std::size_t boundary_face_count() const { return boundary_faces_; }

  static Index tetrahedron_of(Index face) { return face / 4; }
  static Index corner_opposite(Index face) { return face % 4; }
  // The same face seen from the other side; no_index on the boundary.
  Index opposite(Index face) const { return opposite_[face]; }
  bool on_boundary(Index face) const { return opposite_[face] == no_index; }
  // The tetrahedron across the face opposite `corner`; no_index on the boundary.
  Index neighbor(Index tetrahedron, Index corner) const {
    const Index other = opposite_[4 * tetrahedron + corner];
    return other == no_index ? no_index : other / 4;
  }
  // Counter-clockwise seen from outside its tetrahedron.
  Triangle vertices(Index face) const {
    const Tetrahedron& t = tetrahedra_[face / 4];
    const auto& corner = face_corners[face % 4];
    return {t[corner[0]], t[corner[1]], t[corner[2]]};
  }
  // Which corner of the tetrahedron the vertex is; there must be one.
  Index corner_of(Index tetrahedron, Index vertex) const {
    const Tetrahedron& t = tetrahedra_[tetrahedron];
    return t[0] == vertex ? 0 : t[1] == vertex ? 1 : t[2] == vertex ? 2 : 3;
  }

  // Goes round an edge: visit(face) for each tetrahedron about it, clockwise seen along the edge from its start to its
  // end; `face` is the one through which the way leads on to the next tetrahedron. Where the edge lies on the boundary,
  // the way begins at the tetrahedron that has nothing behind it and ends with a face on the boundary. Returns whether
  // it came round. `edge` is the number in edge_corners.
  template <class Visit>
  bool for_each_around(Index tetrahedron, std::size_t edge, const Visit& visit) const {
    const EdgeCorners& corners = edge_corners[edge];
    const Step begin{4 * tetrahedron + corners.first, tetrahedra_[tetrahedron][corners.second]};
    // Back as far as the boundary, if there is one: the way back leaves through the face opposite `second`.
    Step first{4 * tetrahedron + corners.second, tetrahedra_[tetrahedron][corners.first]};
    bool closed = true;
    while (true) {
      const Index behind = opposite_[first.face];
      if (behind == no_index) {
        closed = false;
        break;
      }
      first = across(first, behind);
      if (tetrahedron_of(first.face) == tetrahedron) break;
    }
    Step step = begin;
    if (!closed) {
      const Index t = tetrahedron_of(first.face);
      step = {4 * t + corner_of(t, first.ahead), tetrahedra_[t][corner_opposite(first.face)]};
    }
    const Index end = tetrahedron_of(step.face);
    while (true) {
      visit(step.face);
      const Index next = opposite_[step.face];
      if (next == no_index) return false;
      step = across(step, next);
      if (tetrahedron_of(step.face) == end) return true;
    }
  }

  // One entry a vertex: 1 where it lies on a boundary face. O(n).
  Array<std::uint8_t> boundary_vertices(std::pmr::memory_resource* memory) const;

 private:
  // A place on the way round an edge: the face to leave through, and the vertex of it that is not on the edge.
  struct Step {
    Index face, ahead;
  };
  Step across(const Step& step, Index entered) const {
    const Index t = tetrahedron_of(entered);
    return {4 * t + corner_of(t, step.ahead), tetrahedra_[t][corner_opposite(entered)]};
  }

  std::span<const Tetrahedron> tetrahedra_;
  std::size_t vertex_count_;
  std::size_t boundary_faces_ = 0;
  Array<Index> opposite_;
};

// All edges, each with the tetrahedra around it in order. An edge where two parts of the solid touch has a ring for
// each part. In the order in which their first tetrahedra come.
class EdgeRings {
 public:
  // O(n); 1 byte a tetrahedron besides what is kept. Throws Error "cancelled".
  EdgeRings(const TetrahedralConnectivity& connectivity, const base::Host& host);

  std::size_t size() const { return edges_.size(); }
  // Start and end, as the ring goes round them.
  const Edge& vertices(std::size_t ring) const { return edges_[ring]; }
  // As TetrahedralConnectivity::for_each_around visits them.
  std::span<const Index> faces(std::size_t ring) const {
    return {faces_.data() + begin_[ring], begin_[ring + 1] - begin_[ring]};
  }
  // Whether the ring is open: the last of its faces lies on the boundary.
  bool on_boundary(std::size_t ring) const { return open_[ring] != 0; }

 private:
  Array<Edge> edges_;
  Array<Index> faces_;
  Array<std::size_t> begin_;
  Array<std::uint8_t> open_;
};

}  // namespace orbicube::mesh
