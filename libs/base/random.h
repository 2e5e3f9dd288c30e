// Numbers that look random and are the same in every run and on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace orbicube::base {

// The multiple of 2^-53 in [0, 1) that the upper bits of a random word stand for.
inline double unit_interval(std::uint64_t word) {
  return static_cast<double>(word >> 11U) * 0x1p-53;
}

// splitmix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators"). A generator in place of
// each number, seeded with a count, hashes that count.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }
  // From 0 to bound - 1.
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(next() % bound); }
  // In [0, 1).
  double unit() { return unit_interval(next()); }

 private:
  std::uint64_t state_;
};

}  // namespace orbicube::base
