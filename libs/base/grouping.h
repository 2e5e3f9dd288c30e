// Items by key, by a counting sort: those of one key lie beside each other, in the order in which they were visited.
// Vertices with the elements around them are the common case.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/array.h"

namespace orbicube::base {

// Turns counts, that of key k in begin[k + 1] and begin[0] = 0, into the positions at which the items of each key
// begin.
template <class Number>
void add_up_counts(std::span<Number> begin) {
  for (std::size_t k = 0; k + 1 < begin.size(); ++k)
    begin[k + 1] += begin[k];
}

// The sort itself, for items in arrays of the caller. for_each(visit) calls visit(key, item...) for every item; it is
// called twice, the first time for the keys alone, and must visit the same. `begin`, with one entry more than there are
// keys, receives the position at which each key's items begin, and their number at its end. Between the two passes
// make_room(count) is called, and in the second store(position, item...) for every item.
template <class Number, class ForEach, class MakeRoom, class Store>
void group_by_key(std::span<Number> begin, const ForEach& for_each, const MakeRoom& make_room, const Store& store) {
  std::fill(begin.begin(), begin.end(), Number{0});
  for_each([&](auto key, const auto&...) { ++begin[static_cast<std::size_t>(key) + 1]; });
  add_up_counts(begin);
  make_room(begin.back());
  for_each([&](auto key, const auto&... item) { store(begin[static_cast<std::size_t>(key)]++, item...); });
  // Each begin has moved on to the next one.
  std::copy_backward(begin.begin(), begin.end() - 1, begin.end());
  begin.front() = 0;
}

// Number: of positions; it must be able to count the items.
template <class Item, class Number = std::size_t>
class Groups {
 public:
  explicit Groups(std::pmr::memory_resource* memory) : begin_(1, Number{0}, memory), items_(memory) {}

  // Of `keys` keys, from for_each as above with one item a visit.
  template <class ForEach>
  Groups(std::size_t keys, const ForEach& for_each, std::pmr::memory_resource* memory) : Groups(memory) {
    assign(keys, for_each);
  }

  template <class ForEach>
  void assign(std::size_t keys, const ForEach& for_each) {
    begin_.resize(keys + 1);
    group_by_key(
        std::span(begin_), for_each, [&](Number count) { items_.resize(count); },
        [&](Number at, const Item& item) { items_[at] = item; });
  }

  std::size_t keys() const { return begin_.size() - 1; }

  // The items of a key, in the order of the visits.
  std::span<const Item> operator[](std::size_t key) const { return {items_.data() + begin_[key], size(key)}; }
  std::span<Item> operator[](std::size_t key) { return {items_.data() + begin_[key], size(key)}; }
  std::size_t size(std::size_t key) const { return static_cast<std::size_t>(begin_[key + 1] - begin_[key]); }

  // The items of all keys, and where those of a key begin there.
  std::span<const Item> all() const { return items_; }
  std::size_t begin(std::size_t key) const { return begin_[key]; }

 private:
  Array<Number> begin_;
  Array<Item> items_;
};

// The numbers of the cells (triangles, tetrahedra, hexahedra) around each vertex, in ascending order.
template <class Number, std::size_t corners>
Groups<Number, Number> cells_around(std::span<const std::array<Number, corners>> cells, std::size_t vertices,
                                    std::pmr::memory_resource* memory) {
  const auto for_each = [&](const auto& visit) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (const Number v : cells[i])
        visit(v, static_cast<Number>(i));
    }
  };
  return {vertices, for_each, memory};
}

}  // namespace orbicube::base
