// Half-edge collapses of a closed surface of any genus, and what undoes them.
//
// Progressive meshes (Hoppe 1996) with quadric errors (Garland and Heckbert 1997). Triangles keep their numbers: a
// collapse removes two and renames a corner of those around the vertex that goes, so the coarse surface consists of
// triangles of the fine one, and labels go from one to the other by number.
#pragma once

#include <array>
#include <span>

#include "polycube/surface/surface.h"

namespace orbicube::polycube {

// Polycubes are tried on coarse surfaces, of this number of triangles, where the input has more than is coarse enough.
inline constexpr std::size_t search_triangles = 5000, coarse_enough = 7000;

// The half-edge went from `removed` to `kept`; the dead triangles are the one on its left and the one on its right.
// Across their two other edges, first the one at `kept`, then the one at `removed`, lay the half-edges `beside`, which
// were joined. moved[begin .. begin + size) are the other triangles around `removed`.
struct Collapse {
  Index removed, kept;
  std::array<Index, 2> dead;
  std::array<std::array<Index, 2>, 2> beside;
  Index begin, size;
};

struct Decimation {
  explicit Decimation(std::pmr::memory_resource* memory)
      : triangles(memory), opposite(memory), outgoing(memory), collapses(memory), moved(memory), left(memory) {}

  std::span<const Index> moved_by(const Collapse& c) const { return {moved.data() + c.begin, c.size}; }

  Index start(Index h) const { return triangles[h / 3][h % 3]; }
  Index end(Index h) const { return start(mesh::Connectivity::next(h)); }
  // visit(half_edge) for each that leaves the vertex, counter-clockwise.
  template <class Visit>
  void for_each_outgoing(Index vertex, const Visit& visit) const {
    const Index first = outgoing[vertex];
    Index h = first;
    do {
      visit(h);
      h = opposite[mesh::Connectivity::previous(h)];
    } while (h != first);
  }

  // Undoes the latest collapse that has not been undone.
  void undo(const Collapse& c);

  Array<Triangle> triangles;  // all; dead ones as they were when they went
  Array<Index> opposite;      // of each half-edge
  Array<Index> outgoing;      // a half-edge from each vertex that is left, else no_index
  Array<Collapse> collapses;  // in the order in which they were done
  Array<Index> moved;
  Array<Index> left;  // triangles that are left, ascending
};

// Collapses until about `target` triangles are left or nothing can go. When there are labels, patches keep their
// corners, arcs and neighbors, and no edge inside a patch joins two vertices on boundaries of patches, as split_chords
// leaves it. O(n log n) for bounded valence.
Decimation decimate(const Surface& surface, std::span<const AxisLabel> labels, std::size_t target,
                    const base::Host& host);

// The vertices and triangles that a decimation has left, numbered again, and what the vertices were.
void take_left(const Decimation& decimation, std::span<const Vector3> from, Array<Vector3>& positions,
               Array<Triangle>& triangles, Array<Index>& vertex_source, const base::Host& host);

// Labels of the fine surface from those of the coarse one, where they are set: each triangle that comes back takes the
// label of a neighbor that was there, the one that costs it less. That moves arcs over triangles and changes nothing
// in how patches, arcs and corners hang together, as long as three patches at most meet at each vertex.
void undo_labels(const Decimation& decimation, std::span<const std::array<double, label_count>> costs,
                 std::span<AxisLabel> labels);

}  // namespace orbicube::polycube
