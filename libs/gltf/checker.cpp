#include "gltf/checker.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "base/error.h"

namespace orbicube::gltf {

namespace {

using Bytes = base::Array<std::byte>;

void put_byte(Bytes& to, std::uint32_t byte) {
  to.push_back(static_cast<std::byte>(byte & 0xFFU));
}

void put_big_endian(Bytes& to, std::uint32_t word) {
  for (const std::uint32_t shift : {24U, 16U, 8U, 0U})
    put_byte(to, word >> shift);
}

// CRC of the PNG specification, annex D.
std::uint32_t crc_of(std::span<const std::byte> bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::byte byte : bytes) {
    crc ^= static_cast<std::uint32_t>(byte);
    for (int bit = 0; bit < 8; ++bit)
      crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

void put_chunk(Bytes& to, std::string_view type, std::span<const std::byte> content) {
  put_big_endian(to, static_cast<std::uint32_t>(content.size()));
  const std::size_t begin = to.size();
  for (const char c : type)
    put_byte(to, static_cast<unsigned char>(c));
  to.insert(to.end(), content.begin(), content.end());
  put_big_endian(to, crc_of(std::span(to).subspan(begin)));
}

// Lines of one bit a pixel, each behind a byte that says "no filter".
Bytes checker_lines(const Checker& checker, std::pmr::memory_resource* memory) {
  const std::uint32_t width = checker.columns * checker.pixels, height = checker.rows * checker.pixels;
  Bytes lines(memory);
  lines.reserve(std::size_t{height} * (1 + (width + 7) / 8));
  for (std::uint32_t y = 0; y < height; ++y) {
    put_byte(lines, 0);
    for (std::uint32_t x = 0; x < width; x += 8) {
      std::uint32_t bits = 0;
      for (std::uint32_t i = 0; i < 8 && x + i < width; ++i)
        bits |= (((x + i) / checker.pixels + y / checker.pixels) & 1U) << (7U - i);
      put_byte(lines, bits);
    }
  }
  return lines;
}

// The zlib format (RFC 1950) with blocks that are not compressed (RFC 1951, 3.2.4).
Bytes zlib_stored(std::span<const std::byte> content, std::pmr::memory_resource* memory) {
  Bytes result(memory);
  put_byte(result, 0x78);
  put_byte(result, 0x01);
  constexpr std::size_t longest_block = 65535;
  for (std::size_t at = 0; at < content.size(); at += longest_block) {
    const auto length = static_cast<std::uint32_t>(std::min(longest_block, content.size() - at));
    put_byte(result, at + length == content.size() ? 1 : 0);
    for (const std::uint32_t word : {length, ~length}) {
      put_byte(result, word);
      put_byte(result, word >> 8U);
    }
    const auto block = content.subspan(at, length);
    result.insert(result.end(), block.begin(), block.end());
  }
  std::uint32_t low = 1, high = 0;  // Adler-32
  for (const std::byte byte : content) {
    low = (low + static_cast<std::uint32_t>(byte)) % 65521U;
    high = (high + low) % 65521U;
  }
  put_big_endian(result, high << 16U | low);
  return result;
}

}  // namespace

base::Array<std::byte> checker_png(const Checker& checker, std::pmr::memory_resource* memory) {
  constexpr std::uint32_t longest_side = 16384;
  const auto fits = [&](std::uint32_t squares) {
    return squares > 0 && checker.pixels > 0 && squares <= longest_side / checker.pixels;
  };
  if (!fits(checker.columns) || !fits(checker.rows))
    throw base::Error("invalid-argument", "a checker texture has sides of 1 to 16384 pixels");

  Bytes header(memory), palette(memory), file(memory);
  put_big_endian(header, checker.columns * checker.pixels);
  put_big_endian(header, checker.rows * checker.pixels);
  for (const std::uint32_t byte : {1U, 3U, 0U, 0U, 0U})  // one bit, a palette, deflate, standard filters, no interlace
    put_byte(header, byte);
  for (const auto& color : {checker.first, checker.second}) {
    for (const std::uint8_t channel : color)
      put_byte(palette, channel);
  }
  for (const char byte : std::string_view("\x89PNG\r\n\x1A\n"))
    put_byte(file, static_cast<unsigned char>(byte));
  put_chunk(file, "IHDR", header);
  put_chunk(file, "PLTE", palette);
  put_chunk(file, "IDAT", zlib_stored(checker_lines(checker, memory), memory));
  put_chunk(file, "IEND", {});
  return file;
}

}  // namespace orbicube::gltf
