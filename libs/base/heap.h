// A priority queue: a binary heap in the memory of the host. The order in which entries leave, equal ones included, is
// that of the standard's heap algorithms. Who changes an entry's priority pushes it again and passes over the outdated
// one when it leaves.
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

#include "base/array.h"

namespace orbicube::base {

// After(a, b): whether a leaves after b. std::greater<>: the smallest entry leaves first.
template <class Entry, class After = std::greater<>>
class Heap {
 public:
  explicit Heap(std::pmr::memory_resource* memory, const After& after = After()) : entries_(memory), after_(after) {}

  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  void clear() { entries_.clear(); }

  // Replaces the contents, in linear time. Without pushes beyond their number, no memory is allocated afterwards.
  void assign(Array<Entry> entries) {
    entries_ = std::move(entries);
    std::make_heap(entries_.begin(), entries_.end(), after_);
  }

  void push(const Entry& entry) {
    entries_.push_back(entry);
    std::push_heap(entries_.begin(), entries_.end(), after_);
  }

  // The entry that leaves next. Not of an empty heap.
  const Entry& top() const { return entries_.front(); }

  // Takes it out.
  Entry pop() {
    std::pop_heap(entries_.begin(), entries_.end(), after_);
    Entry entry = std::move(entries_.back());
    entries_.pop_back();
    return entry;
  }

 private:
  Array<Entry> entries_;
  [[no_unique_address]] After after_;
};

}  // namespace orbicube::base
