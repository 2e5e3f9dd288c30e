// Disjoint sets of the numbers 0 .. n - 1 (union-find, Tarjan 1975).
#pragma once

#include <numeric>
#include <utility>

#include "mesh/mesh.h"

namespace orbicube::mesh {

class DisjointSets {
 public:
  DisjointSets(std::size_t count, std::pmr::memory_resource* memory) : parent_(count, memory) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  // The lowest member of the set that x is in.
  Index find(Index x) {
    while (parent_[x] != x) {
      parent_[x] = parent_[parent_[x]];
      x = parent_[x];
    }
    return x;
  }

  void unite(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a > b) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  Array<Index> parent_;
};

}  // namespace orbicube::mesh
