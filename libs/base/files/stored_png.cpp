#include "base/files/stored_png.h"

#include <algorithm>
#include <array>

#include "base/error.h"

namespace orbicube::base {
namespace {

using Bytes = Array<std::byte>;

constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";

void put_byte(Bytes& to, std::uint32_t byte) {
  to.push_back(static_cast<std::byte>(byte & 0xFFU));
}

void put_big_endian(Bytes& to, std::uint32_t word) {
  for (const std::uint32_t shift : {24U, 16U, 8U, 0U})
    put_byte(to, word >> shift);
}

void put_text(Bytes& to, std::string_view text) {
  for (const char c : text)
    put_byte(to, static_cast<unsigned char>(c));
}

// CRC of the specification, annex D.
std::uint32_t crc_of(std::span<const std::byte> bytes) {
  static constexpr auto table = [] {
    std::array<std::uint32_t, 256> result{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int bit = 0; bit < 8; ++bit)
        c = c >> 1U ^ ((c & 1U) != 0 ? 0xEDB88320U : 0U);
      result[n] = c;
    }
    return result;
  }();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::byte byte : bytes)
    crc = crc >> 8U ^ table[(crc ^ static_cast<std::uint32_t>(byte)) & 0xFFU];
  return ~crc;
}

void put_chunk(Bytes& to, std::string_view type, std::span<const std::byte> content) {
  put_big_endian(to, static_cast<std::uint32_t>(content.size()));
  const std::size_t begin = to.size();
  put_text(to, type);
  to.insert(to.end(), content.begin(), content.end());
  put_big_endian(to, crc_of(std::span(to).subspan(begin)));
}

// The zlib format (RFC 1950) with blocks that are not compressed (RFC 1951, 3.2.4).
Bytes zlib_stored(std::span<const std::byte> content, std::pmr::memory_resource* memory) {
  Bytes result(memory);
  constexpr std::size_t longest_block = 65535;
  result.reserve(content.size() + 5 * (content.size() / longest_block + 1) + 6);
  put_byte(result, 0x78);
  put_byte(result, 0x01);
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

std::size_t checked_row_bytes(const PngImage& image) {
  constexpr std::uint32_t longest_side = 16384;
  if (image.width == 0 || image.height == 0 || image.width > longest_side || image.height > longest_side)
    throw Error("invalid-argument", "a PNG image has sides of 1 to 16384 pixels");
  const std::size_t channels = image.color == PngColor::rgb ? 3 : 1;
  const std::size_t row_bytes = (std::size_t{image.width} * channels * image.bits + 7) / 8;
  if (image.rows.size() != row_bytes * image.height || image.palette.size() % 3 != 0 || image.text_key.size() > 79)
    throw Error("invalid-argument", "rows, palette or text of a PNG image have a wrong size");
  return row_bytes;
}

Bytes stored_png(const PngImage& image, std::pmr::memory_resource* memory) {
  const std::size_t row_bytes = checked_row_bytes(image);
  Bytes header(memory), lines(memory), file(memory);
  put_big_endian(header, image.width);
  put_big_endian(header, image.height);
  put_byte(header, image.bits);
  put_byte(header, static_cast<std::uint32_t>(image.color));
  for (int i = 0; i < 3; ++i)  // deflate, standard filters, no interlace
    put_byte(header, 0);
  lines.reserve((row_bytes + 1) * image.height);
  for (std::size_t y = 0; y < image.height; ++y) {
    put_byte(lines, 0);  // no filter
    const auto row = image.rows.subspan(y * row_bytes, row_bytes);
    lines.insert(lines.end(), row.begin(), row.end());
  }
  put_text(file, signature);
  put_chunk(file, "IHDR", header);
  if (!image.palette.empty()) put_chunk(file, "PLTE", image.palette);
  if (!image.text_key.empty()) {
    Bytes text(memory);
    put_text(text, image.text_key);
    put_byte(text, 0);
    put_text(text, image.text);
    put_chunk(file, "tEXt", text);
  }
  put_chunk(file, "IDAT", zlib_stored(lines, memory));
  put_chunk(file, "IEND", {});
  return file;
}

std::string_view png_text(std::span<const std::byte> file, std::string_view key) {
  const std::string_view bytes(reinterpret_cast<const char*>(file.data()), file.size());
  if (!bytes.starts_with(signature)) return {};
  constexpr std::size_t around = 12;  // length and type before, CRC behind
  for (std::size_t at = signature.size(); bytes.size() - at >= around;) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
      length = length << 8U | static_cast<unsigned char>(bytes[at + i]);
    if (length > bytes.size() - at - around) return {};
    const std::string_view content = bytes.substr(at + 8, length);
    if (bytes.substr(at + 4, 4) == "tEXt" && content.size() > key.size() && content.starts_with(key) &&
        content[key.size()] == '\0') {
      return content.substr(key.size() + 1);
    }
    at += around + length;
  }
  return {};
}

}  // namespace orbicube::base
