// Numbers that a file gives its vertices, in any order and with gaps, and which vertex each one is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/array.h"
#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

class NodeNumbers {
 public:
  explicit NodeNumbers(std::pmr::memory_resource* memory) : numbers_(memory), order_(memory) {}

  void reserve(std::size_t count) { numbers_.reserve(count); }
  // The number of the next vertex.
  void add(std::uint64_t number) { numbers_.push_back(number); }

  // After the last vertex: returns a number that two vertices have, if there is one. Mostly numbers count from 1.
  std::optional<std::uint64_t> sort() {
    bool counted = true;
    for (std::size_t v = 0; v < numbers_.size(); ++v)
      counted = counted && numbers_[v] == v + 1;
    if (counted) return std::nullopt;
    order_.resize(numbers_.size());
    for (std::size_t v = 0; v < order_.size(); ++v)
      order_[v] = static_cast<Index>(v);
    std::sort(order_.begin(), order_.end(), [&](Index a, Index b) { return numbers_[a] < numbers_[b]; });
    for (std::size_t i = 1; i < order_.size(); ++i) {
      if (numbers_[order_[i - 1]] == numbers_[order_[i]]) return numbers_[order_[i]];
    }
    return std::nullopt;
  }

  // Returns the vertex with this number, if any. After sort().
  std::optional<Index> vertex(std::uint64_t number) const {
    if (order_.empty()) {
      if (number - 1 < numbers_.size()) return static_cast<Index>(number - 1);
      return std::nullopt;
    }
    const auto at = std::lower_bound(order_.begin(), order_.end(), number,
                                     [&](Index v, std::uint64_t n) { return numbers_[v] < n; });
    if (at != order_.end() && numbers_[*at] == number) return *at;
    return std::nullopt;
  }

 private:
  Array<std::uint64_t> numbers_;
  Array<Index> order_;  // vertices by number, where these do not count from 1
};

}  // namespace orbicube::mesh
