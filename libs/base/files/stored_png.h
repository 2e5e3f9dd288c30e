// PNG files in memory (PNG specification, third edition), stored without compression: the same bytes from every build
// and language. Large images are compressed, by sphere_map/sampling/png_file.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <string_view>

#include "base/array.h"

namespace orbicube::base {

enum class PngColor : std::uint8_t { gray = 0, rgb = 2, palette = 3 };

struct PngImage {
  std::uint32_t width = 0, height = 0;  // pixels
  std::uint8_t bits = 8;                // a channel: 1, 2, 4, 8 or 16 as the specification allows for the color
  PngColor color = PngColor::rgb;
  std::span<const std::byte> palette;  // red, green, blue of each entry
  // Row by row from the top, each filled up to whole bytes; numbers of 16 bits have the high byte first.
  std::span<const std::byte> rows;
  std::string_view text_key, text;  // a text chunk of Latin letters (key of 1 to 79), or nothing
};

// Returns the number of bytes in a row. Throws Error "invalid-argument" when a side is not from 1 to 16384 pixels or
// sizes do not fit.
std::size_t checked_row_bytes(const PngImage& image);

// Returns the bytes of the file. Throws as checked_row_bytes does.
Array<std::byte> stored_png(const PngImage& image, std::pmr::memory_resource* memory);

// Returns the text that a PNG file has under this key, uncompressed, or nothing; whatever the bytes are.
std::string_view png_text(std::span<const std::byte> file, std::string_view key);

}  // namespace orbicube::base
