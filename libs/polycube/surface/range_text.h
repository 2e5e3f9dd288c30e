// How messages sum up many numbers.
#pragma once

#include <cstddef>
#include <string>

namespace orbicube::polycube {

// "24 to 96", or "24".
inline std::string range_text(std::size_t low, std::size_t high) {
  return std::to_string(low) + (low < high ? " to " + std::to_string(high) : std::string());
}

}  // namespace orbicube::polycube
