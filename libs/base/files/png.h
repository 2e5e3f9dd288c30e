// PNG files in memory (PNG specification, third edition), stored without compression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <string_view>

#include "base/array.h"

namespace orbicube::base {

enum class PngColor : std::uint8_t { grey = 0, rgb = 2, palette = 3 };

struct PngImage {
  std::uint32_t width = 0, height = 0;  // pixels
  std::uint8_t bits = 8;                // a channel: 1, 2, 4, 8 or 16 as the specification allows for the color
  PngColor color = PngColor::rgb;
  std::span<const std::byte> palette;  // red, green, blue of each entry
  // Row by row from the top, each filled up to whole bytes; numbers of 16 bits have the high byte first.
  std::span<const std::byte> rows;
  std::string_view text_key, text;  // a text chunk of Latin letters (key of 1 to 79), or nothing
};

// The bytes of the file. Throws Error "invalid-argument" when a side is not from 1 to 16384 pixels or sizes do not fit.
Array<std::byte> png_bytes(const PngImage& image, std::pmr::memory_resource* memory);

// The text that a PNG file has under this key, or nothing; whatever the bytes are.
std::string_view png_text(std::span<const std::byte> file, std::string_view key);

}  // namespace orbicube::base
