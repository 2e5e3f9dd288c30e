// A priority queue of numbers 0 .. capacity - 1 whose priorities are told apart by their powers of two only: every
// operation takes constant time, and numbers of like priority leave in the order in which they came.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory_resource>

#include "base/array.h"

namespace orbicube::sphere_optimizer {

class BucketQueue {
 public:
  BucketQueue(std::size_t capacity, std::pmr::memory_resource* memory)
      : next_(capacity, none, memory), previous_(capacity, none, memory), bucket_(capacity, outside, memory) {
    first_.fill(none);
    last_.fill(none);
  }

  bool empty() const {
    return std::all_of(filled_.begin(), filled_.end(), [](std::uint64_t word) { return word == 0; });
  }

  // Puts `item` in, or moves it ahead if it is in with a lower priority. Priorities are not negative.
  void raise(std::uint32_t item, double priority) {
    const std::uint16_t bucket = bucket_of(priority);
    if (bucket_[item] != outside) {
      if (bucket_[item] >= bucket) return;
      unlink(item);
    }
    previous_[item] = last_[bucket];
    next_[item] = none;
    (last_[bucket] == none ? first_[bucket] : next_[last_[bucket]]) = item;
    last_[bucket] = item;
    bucket_[item] = bucket;
    filled_[bucket / 64U] |= std::uint64_t{1} << bucket % 64U;
  }

  // Takes out the item of the highest priority, to within a factor of two. Not from an empty queue.
  std::uint32_t pop() {
    std::size_t word = filled_.size() - 1;
    while (filled_[word] == 0)
      --word;
    const std::size_t bucket = 64 * word + 63 - static_cast<std::size_t>(std::countl_zero(filled_[word]));
    const std::uint32_t item = first_[bucket];
    unlink(item);
    return item;
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint16_t outside = std::numeric_limits<std::uint16_t>::max();
  // One for each exponent of a normal number, the first for what is smaller.
  static constexpr std::size_t bucket_count = 2048;

  static std::uint16_t bucket_of(double priority) {
    if (!(priority >= std::numeric_limits<double>::min())) return 0;
    return static_cast<std::uint16_t>(std::min(std::ilogb(priority), 1023) + 1023);
  }

  void unlink(std::uint32_t item) {
    const std::uint16_t bucket = bucket_[item];
    (previous_[item] == none ? first_[bucket] : next_[previous_[item]]) = next_[item];
    (next_[item] == none ? last_[bucket] : previous_[next_[item]]) = previous_[item];
    bucket_[item] = outside;
    if (first_[bucket] == none) filled_[bucket / 64U] &= ~(std::uint64_t{1} << bucket % 64U);
  }

  std::array<std::uint32_t, bucket_count> first_, last_;
  std::array<std::uint64_t, bucket_count / 64> filled_{};  // one bit a bucket that is not empty
  base::Array<std::uint32_t> next_, previous_;
  base::Array<std::uint16_t> bucket_;
};

}  // namespace orbicube::sphere_optimizer
