// Images of files in memory, by stb_image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::cli {

struct StoredImage {
  explicit StoredImage(std::pmr::memory_resource* memory) : rgb(memory) {}

  std::size_t width = 0, height = 0;
  base::Array<std::uint8_t> rgb;  // sRGB, row by row from the top
};

// Returns the pixels of a PNG or JPEG file of at most 16384 pixels along a side; none if it is no such file.
StoredImage decoded(std::span<const std::byte> file, const base::Host& host);

}  // namespace orbicube::cli
