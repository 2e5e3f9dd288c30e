// How messages tell a place.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// "(x, y, z)", to nine digits.
std::string place_text(const Vector3& p);

// Returns the message with each place in it, which place_text wrote behind a word, times 2^exponent.
std::string scaled_places(std::string_view message, int exponent);

// Runs `work` on positions that are those of the caller times 2^exponent: places in its refusals become the caller's.
template <class Work>
auto with_places_of_caller(int exponent, const Work& work) {
  if (exponent == 0) return work();
  try {
    return work();
  } catch (const base::Error& error) {
    throw base::Error(error.kind(), scaled_places(error.what(), -exponent));
  }
}

}  // namespace orbicube::mesh
