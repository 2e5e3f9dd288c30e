// A priority queue of vertices whose priorities are only told apart by powers of two: every operation takes constant
// time, and vertices of like priority leave in the order in which they came, which keeps memory accesses near each
// other.
#pragma once

#include <algorithm>
#include <cmath>

#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;
using mesh::no_index;

class BucketQueue {
 public:
  // Room for the items 0 .. capacity - 1.
  BucketQueue(std::size_t capacity, std::pmr::memory_resource* memory)
      : next_(capacity, no_index, memory), previous_(capacity, no_index, memory), bucket_(capacity, outside, memory) {
    clear();
  }

  // Priorities are counted relative to `unit`: those below unit * 2^-63 are all alike. Empties the queue.
  void start(double unit) {
    while (!empty())
      pop();
    unit_ = unit;
  }

  // Keeps `item` out: raise() passes over it until release().
  void hold(Index item) {
    if (bucket_[item] == held) return;
    if (bucket_[item] != outside) unlink(item);
    bucket_[item] = held;
  }
  void release(Index item) {
    if (bucket_[item] == held) bucket_[item] = outside;
  }

  bool empty() const { return size_ == 0; }

  // Puts `item` in, or moves it ahead if it is in with a lower priority.
  void raise(Index item, double priority) {
    const std::uint8_t bucket = bucket_of(priority);
    if (bucket_[item] != outside) {
      if (bucket_[item] <= bucket) return;
      unlink(item);
    }
    append(item, bucket);
  }

  // Takes out the item of the highest priority (to within a factor of two).
  Index pop() {
    while (first_[lowest_] == no_index)
      ++lowest_;
    const Index item = first_[lowest_];
    unlink(item);
    return item;
  }

  // Upper bound of the priority of what pop() would answer. Not for an empty queue.
  double top_priority() {
    while (first_[lowest_] == no_index)
      ++lowest_;
    return std::ldexp(unit_, 2 - static_cast<int>(lowest_));
  }

 private:
  static constexpr std::uint8_t held = 0;  // as if in a bucket before all others
  static constexpr std::uint8_t bucket_count = 64;
  static constexpr std::uint8_t outside = 255;

  void clear() {
    std::fill(std::begin(first_), std::end(first_), no_index);
    std::fill(std::begin(last_), std::end(last_), no_index);
  }

  // Bucket 1 is the highest priority: [unit, infinity).
  std::uint8_t bucket_of(double priority) const {
    if (!(priority > 0)) return bucket_count;
    const int exponent = std::ilogb(unit_ / priority);
    return static_cast<std::uint8_t>(std::clamp(exponent + 2, 1, static_cast<int>(bucket_count)));
  }

  void append(Index item, std::uint8_t bucket) {
    previous_[item] = last_[bucket];
    next_[item] = no_index;
    (last_[bucket] == no_index ? first_[bucket] : next_[last_[bucket]]) = item;
    last_[bucket] = item;
    bucket_[item] = bucket;
    lowest_ = std::min(lowest_, bucket);
    ++size_;
  }

  void unlink(Index item) {
    const std::uint8_t bucket = bucket_[item];
    (previous_[item] == no_index ? first_[bucket] : next_[previous_[item]]) = next_[item];
    (next_[item] == no_index ? last_[bucket] : previous_[next_[item]]) = previous_[item];
    bucket_[item] = outside;
    --size_;
  }

  double unit_ = 1;
  std::size_t size_ = 0;
  std::uint8_t lowest_ = 0;  // no bucket before this one holds an item
  Index first_[bucket_count + 1];
  Index last_[bucket_count + 1];
  Array<Index> next_, previous_;
  Array<std::uint8_t> bucket_;
};

}  // namespace orbicube::sphere_map
