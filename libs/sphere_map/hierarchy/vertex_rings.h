// The one-rings of a closed triangle mesh, kept while vertices are collapsed away and split in again.
//
// The ring of a vertex lists its neighbors counter-clockwise seen from outside; two that follow each other (the last
// is followed by the first) and the vertex itself are a triangle. All rings lie in one pool; a ring that outgrows its
// place moves to the end of it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory_resource>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;
using mesh::Triangle;

// A half-edge collapse: `removed` was merged into its neighbor `kept`. Its ring before the collapse is
// ring_pool[ring_begin .. ring_begin + ring_size), rotated so that it starts with `kept`.
struct Collapse {
  Index removed;
  Index kept;
  Index ring_begin;
  Index ring_size;
};

class VertexRings {
 public:
  // Rings of the triangles of a closed, oriented manifold. Vertices in no triangle have empty rings.
  VertexRings(std::size_t vertex_count, std::span<const Triangle> triangles, const base::Host& host);

  std::span<const Index> operator[](Index vertex) const {
    const Place& place = places_[vertex];
    return {pool_.data() + place.begin, place.size};
  }
  std::size_t valence(Index vertex) const { return places_[vertex].size; }
  std::size_t vertex_count() const { return places_.size(); }

  // Position of `neighbor` in the ring of `vertex`, or its valence when it is not there.
  std::size_t find(Index vertex, Index neighbor) const;

  // Whether the two are joined by an edge. Takes as long as the shorter of their rings.
  bool adjacent(Index a, Index b) const;

  // Room at the end of the pool, from which rings can grow while other rings are changed by other threads.
  struct Room {
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  Room set_aside(std::size_t size);

  // Takes care that collapse() will find place for the ring of `kept`. Returns false when there is no room for that.
  bool make_room(Index removed, Index kept, Room& room);

  // Removes collapse.removed, which keeps its own ring. It must be in `ring`, starting with collapse.kept.
  void collapse(const Collapse& collapse, std::span<const Index> ring);

  // Undoes collapse(): the latest one that has not been undone yet.
  void split(const Collapse& collapse, std::span<const Index> ring);

  // Numbers the vertices again: `number` has the new number of each.
  void renumber(std::span<const Index> number);

  // Rotates the ring of a vertex so that it starts with `neighbor`.
  void start_with(Index vertex, Index neighbor);

 private:
  struct Place {
    std::size_t begin = 0;
    Index size = 0;
    Index capacity = 0;
  };

  Index* ring(Index vertex) { return pool_.data() + places_[vertex].begin; }
  std::size_t grown_capacity(const Place& place, std::size_t size) const {
    return std::max<std::size_t>(size, 2 * std::size_t{place.size});
  }
  void move_ring(Index vertex, std::size_t begin, std::size_t capacity);
  void reserve(Index vertex, std::size_t size);
  void erase(Index vertex, std::size_t position);
  void insert(Index vertex, std::size_t position, Index neighbor);

  Array<Place> places_;
  Array<Index> pool_;
};

}  // namespace orbicube::sphere_map
