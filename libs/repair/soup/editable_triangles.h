// Triangles whose corners change one at a time, with the triangles around each vertex: what collapses and flips of
// edges need on a surface that may be open or not manifold.
#pragma once

#include <span>

#include "repair/types.h"

namespace orbicube::repair {

class EditableTriangles {
 public:
  // Keeps a view of `triangles`; none has a repeated corner.
  EditableTriangles(std::size_t vertices, std::span<Triangle> triangles, std::pmr::memory_resource* memory)
      : triangles_(triangles),
        first_(vertices, no_index, memory),
        next_(3 * triangles.size(), no_index, memory),
        alive_(triangles.size(), 1, memory) {
    for (std::size_t c = 3 * triangles.size(); c-- > 0;)
      link(static_cast<Index>(c));
  }

  std::size_t size() const { return triangles_.size(); }
  const Triangle& operator[](Index t) const { return triangles_[t]; }
  bool alive(Index t) const { return alive_[t] != 0; }
  std::span<const std::uint8_t> all_alive() const { return alive_; }

  // visit(t, k) for each triangle t whose corner k is the vertex.
  template <class Visit>
  void for_each_at(Index vertex, const Visit& visit) const {
    for (Index c = first_[vertex]; c != no_index; c = next_[c])
      visit(c / 3, c % 3);
  }
  // The number of triangles at an edge; the first two of them are written to `at`.
  std::size_t at_edge(Index a, Index b, std::array<Index, 2>& at) const {
    std::size_t count = 0;
    for_each_at(a, [&](Index t, Index) {
      if (!has(t, b)) return;
      if (count < 2) at[count] = t;
      ++count;
    });
    return count;
  }
  bool has(Index t, Index vertex) const {
    return triangles_[t][0] == vertex || triangles_[t][1] == vertex || triangles_[t][2] == vertex;
  }
  Index third(Index t, Index a, Index b) const {
    for (const Index v : triangles_[t]) {
      if (v != a && v != b) return v;
    }
    return no_index;
  }

  void remove(Index t) {
    for (Index k = 0; k < 3; ++k)
      unlink(3 * t + k);
    alive_[t] = 0;
  }
  void set(Index t, const Triangle& corners) {
    for (Index k = 0; k < 3; ++k)
      unlink(3 * t + k);
    triangles_[t] = corners;
    for (Index k = 0; k < 3; ++k)
      link(3 * t + k);
  }
  // Gives all corners at `from` to `to`.
  void replace(Index from, Index to) {
    while (first_[from] != no_index) {
      const Index c = first_[from];
      first_[from] = next_[c];
      triangles_[c / 3][c % 3] = to;
      next_[c] = first_[to];
      first_[to] = c;
    }
  }

 private:
  void link(Index c) {
    Index& first = first_[triangles_[c / 3][c % 3]];
    next_[c] = first;
    first = c;
  }
  void unlink(Index c) {
    Index* at = &first_[triangles_[c / 3][c % 3]];
    while (*at != c)
      at = &next_[*at];
    *at = next_[c];
  }

  std::span<Triangle> triangles_;
  Array<Index> first_;  // corner of each vertex
  Array<Index> next_;   // of the same vertex
  Array<std::uint8_t> alive_;
};

}  // namespace orbicube::repair
