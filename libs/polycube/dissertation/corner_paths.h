// Shortest paths between corner points along the edges of a surface, one for each edge of the polycube's rectangles
// (the dissertation's section 4.2.2).
//
// The dissertation stores the shortest paths between all pairs of vertices (Floyd and Warshall), in the cube of the
// vertices' number. Dijkstra's algorithm from the corner points finds paths of the same lengths; those that are needed
// again are kept. Each path is the shortest by itself: two may meet or cross, and then there is no map.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "base/heap.h"
#include "polycube/layout/layout.h"
#include "polycube/surface/editable_surface.h"

namespace orbicube::polycube::dissertation {

class ShortestPaths {
 public:
  ShortestPaths(const EditableSurface& surface, const base::Host& host);

  // Vertices of a shortest path, both ends included; among several the same each time, in either direction. Valid
  // until the next call. Empty where there is none. Throws Error "cancelled".
  std::span<const Index> find(Index from, Index to);

 private:
  struct Reached {
    double length;
    Index vertex;
    friend bool operator>(const Reached& a, const Reached& b) {
      return a.length != b.length ? a.length > b.length : a.vertex > b.vertex;
    }
  };
  using Pair = std::pair<Index, Index>;

  void search(Index from, Index to, Array<Index>& path);

  const EditableSurface& surface_;
  const base::Host& host_;
  Array<double> distance_;
  Array<Index> parent_, touched_;
  base::Heap<Reached> heap_;
  std::pmr::map<Pair, Array<Index>> known_;
  std::size_t known_size_ = 0;
  Array<Index> reversed_;
};

// What the paths of all arcs of a layout bound.
struct Drawn {
  explicit Drawn(std::pmr::memory_resource* memory) : path_begin(memory), paths(memory), rectangle(memory) {}

  bool valid() const { return defects == 0; }
  std::span<const Index> path(Index arc) const {
    return {paths.data() + path_begin[arc], path_begin[arc + 1] - path_begin[arc]};
  }

  Array<Index> path_begin, paths;  // vertices of each arc, from its first node to its second
  Array<Index> rectangle;          // of each triangle, where all is valid
  std::size_t defects = 0;         // places where paths meet, cross, or bound no disk
  std::string first;               // the first of them
};

// Traces the paths of all arcs between the vertices of the nodes, and floods the patches between them. Marks arcs and
// occupied vertices of nothing: `surface` stays as it is.
Drawn draw_paths(const Layout& layout, std::span<const Index> node_vertices, const EditableSurface& surface,
                 ShortestPaths& shortest, const base::Host& host);

// The same for the given paths, `drawn.path_begin` and `drawn.paths`: fills in the rest.
void find_patches(const Layout& layout, const EditableSurface& surface, Drawn& drawn, const base::Host& host);

}  // namespace orbicube::polycube::dissertation
