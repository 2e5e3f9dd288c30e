// A priority queue of numbers 0 .. capacity - 1 whose priorities are only distinguished by powers of two: every
// operation takes constant time, and numbers of like priority leave in the order in which they came, which keeps memory
// accesses near each other.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory_resource>
#include <span>
#include <type_traits>

#include "base/array.h"

namespace orbicube::base {

// `bucket_count` powers of two are distinguished, from that of the unit (start) down.
template <std::size_t bucket_count>
class BucketQueue {
 public:
  BucketQueue(std::size_t capacity, std::pmr::memory_resource* memory)
      : next_(capacity, none, memory), previous_(capacity, none, memory), bucket_(capacity, outside, memory) {
    first_.fill(none);
    last_.fill(none);
  }

  // Empties the queue. Priorities are counted relative to `unit`: those above it are all alike, and so are those up to
  // unit * 2^(2 - bucket_count).
  void start(double unit) {
    while (!empty())
      pop();
    unit_ = unit;
  }

  // Keeps `item` out: raise() passes over it until release().
  void hold(std::uint32_t item) {
    if (bucket_[item] == held) return;
    if (bucket_[item] != outside) unlink(item);
    bucket_[item] = held;
  }
  void release(std::uint32_t item) {
    if (bucket_[item] == held) bucket_[item] = outside;
  }

  bool empty() const { return size_ == 0; }

  // Puts `item` in, or moves it ahead if it is in with a lower priority.
  void raise(std::uint32_t item, double priority) {
    const Bucket bucket = bucket_of(priority);
    if (bucket_[item] != outside) {
      if (bucket_[item] <= bucket) return;
      unlink(item);
    }
    append(item, bucket);
  }

  // The item of the highest priority (to within a factor of two). Not of an empty queue.
  std::uint32_t front() const { return first_[top()]; }

  // Takes it out.
  std::uint32_t pop() {
    const std::uint32_t item = front();
    unlink(item);
    return item;
  }

  // Shows every part of the state to `visit` as spans, for saving and loading.
  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    visit(std::span(&self.unit_, 1));
    visit(std::span(&self.size_, 1));
    visit(std::span(self.filled_));
    visit(std::span(self.first_));
    visit(std::span(self.last_));
    visit(std::span(self.next_));
    visit(std::span(self.previous_));
    visit(std::span(self.bucket_));
  }

 private:
  using Bucket = std::conditional_t<(bucket_count < 255), std::uint8_t, std::uint16_t>;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  static constexpr Bucket held = 0;  // as if in a bucket before all others
  static constexpr Bucket outside = std::numeric_limits<Bucket>::max();

  // Bucket 1 is the highest priority, above the unit.
  Bucket bucket_of(double priority) const {
    if (!(priority > 0)) return bucket_count;
    return static_cast<Bucket>(std::clamp(std::ilogb(unit_ / priority), -1, static_cast<int>(bucket_count) - 2) + 2);
  }

  std::size_t top() const {
    std::size_t word = 0;
    while (filled_[word] == 0)
      ++word;
    return 64 * word + static_cast<std::size_t>(std::countr_zero(filled_[word]));
  }

  void append(std::uint32_t item, Bucket bucket) {
    previous_[item] = last_[bucket];
    next_[item] = none;
    (last_[bucket] == none ? first_[bucket] : next_[last_[bucket]]) = item;
    last_[bucket] = item;
    bucket_[item] = bucket;
    filled_[bucket / 64U] |= std::uint64_t{1} << bucket % 64U;
    ++size_;
  }

  void unlink(std::uint32_t item) {
    const Bucket bucket = bucket_[item];
    (previous_[item] == none ? first_[bucket] : next_[previous_[item]]) = next_[item];
    (next_[item] == none ? last_[bucket] : previous_[next_[item]]) = previous_[item];
    bucket_[item] = outside;
    if (first_[bucket] == none) filled_[bucket / 64U] &= ~(std::uint64_t{1} << bucket % 64U);
    --size_;
  }

  double unit_ = 1;
  std::uint64_t size_ = 0;
  std::array<std::uint64_t, bucket_count / 64 + 1> filled_{};  // one bit a bucket that is not empty
  std::array<std::uint32_t, bucket_count + 1> first_, last_;
  Array<std::uint32_t> next_, previous_;
  Array<Bucket> bucket_;
};

}  // namespace orbicube::base
