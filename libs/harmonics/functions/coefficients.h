// Coefficients of functions on the unit sphere in the real spherical harmonics that this library works with:
//
//   Y_lm(x, y, z) = N_lm P_l|m|(z) * { sqrt 2 cos m phi  (m > 0),  1  (m = 0),  sqrt 2 sin |m| phi  (m < 0) }
//
// with z = cos theta, x + i y = sin theta e^(i phi), N_lm = sqrt((2l+1)/(4 pi) (l-|m|)!/(l+|m|)!) and P_lm without the
// Condon-Shortley phase (-1)^m. They are orthonormal: the integral of Y_lm Y_l'm' over the sphere is 1 or 0, so
// Y_00 = 1 / sqrt(4 pi) and (Y_1,1, Y_1,-1, Y_1,0) = sqrt(3 / (4 pi)) (x, y, z). This is the dissertation's basis
// (section 3.3) for real functions; conversions to other conventions are in coefficient_file.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/array.h"
#include "base/error.h"

namespace orbicube::harmonics {

using base::Array;

// Of what degree coefficients may be: up to here no value that matters leaves the range of double.
inline constexpr std::uint32_t largest_degree = 1000;

// How many basis functions there are up to a degree.
constexpr std::size_t basis_size(std::uint32_t degree) {
  return (std::size_t{degree} + 1) * (std::size_t{degree} + 1);
}

// Where Y_lm is among them.
constexpr std::size_t basis_index(std::uint32_t l, std::int32_t m) {
  return static_cast<std::size_t>(std::int64_t{l} * l + l + m);
}

// Of one function or of several (the three coordinates of a shape), a "channel" each:
// values[basis_index(l, m) * channels + channel].
struct Coefficients {
  explicit Coefficients(std::pmr::memory_resource* memory = std::pmr::get_default_resource()) : values(memory) {}
  Coefficients(std::uint32_t highest, std::size_t functions, std::pmr::memory_resource* memory)
      : degree(highest), channels(functions), values(basis_size(highest) * functions, memory) {}

  // A copy in the same memory (that of a copied Array would be the default one).
  Coefficients copy() const {
    Coefficients other(values.get_allocator().resource());
    other.degree = degree;
    other.channels = channels;
    other.values = values;
    return other;
  }

  double& at(std::uint32_t l, std::int32_t m, std::size_t channel) {
    return values[basis_index(l, m) * channels + channel];
  }
  double at(std::uint32_t l, std::int32_t m, std::size_t channel) const {
    return values[basis_index(l, m) * channels + channel];
  }

  std::uint32_t degree = 0;
  std::size_t channels = 0;
  Array<double> values;
};

// Throws Error "invalid-argument" for a degree beyond largest_degree.
inline void require_degree(std::uint64_t degree) {
  if (degree > largest_degree)
    throw base::Error("invalid-argument",
                      "degree " + std::to_string(degree) + "; the highest is " + std::to_string(largest_degree));
}

}  // namespace orbicube::harmonics
