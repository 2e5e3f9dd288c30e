// A checker pattern as a PNG file, to show a texture coordinate.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory_resource>

#include "base/array.h"

namespace orbicube::gltf {

struct Checker {
  std::uint32_t columns = 32, rows = 16;                                   // squares
  std::uint32_t pixels = 16;                                               // edge of a square
  std::array<std::uint8_t, 3> first{235, 235, 235}, second{70, 110, 160};  // sRGB
};

// Returns the bytes of the file: two colors, one bit a pixel (PNG specification, third edition), 16 KB by default. Not
// compressed, so that the bytes are those of every build, with or without libraries, and of every language. Throws
// Error "invalid-argument" when a side is not from 1 to 16384 pixels.
base::Array<std::byte> checker_png(const Checker& checker, std::pmr::memory_resource* memory);

}  // namespace orbicube::gltf
