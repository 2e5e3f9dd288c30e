// Fourier transforms of a length without prime factors above 5, of several sequences side by side in the lanes of
// vector instructions: Stockham's self-sorting algorithm with radices 4, 2, 3 and 5.
#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>

#include "base/array.h"

namespace orbicube::harmonics {

// Sequences that are transformed at once.
inline constexpr std::size_t fourier_lanes = 4;

// One entry of each of the sequences.
struct ComplexLanes {
  std::array<double, fourier_lanes> real, imaginary;
};

class FourierTransform {
 public:
  // `length` as fitting_length() returns it.
  FourierTransform(std::size_t length, std::pmr::memory_resource* memory);

  std::size_t length() const { return length_; }

  // Returns that of the two arrays, of `length` entries each, whose entry j has become the sum over k of data[k]
  // e^(sign 2 pi i j k / length), sign = -1 or 1. The other one has no meaning afterwards.
  ComplexLanes* transform(int sign, ComplexLanes* data, ComplexLanes* scratch) const;

  // Returns the smallest even length, not below `minimum`, that has no prime factor above 5.
  static std::size_t fitting_length(std::size_t minimum);

 private:
  std::size_t length_;
  base::Array<std::size_t> radices_;
  base::Array<std::array<double, 2>> roots_;  // e^(-2 pi i k / length)
};

}  // namespace orbicube::harmonics
