#include "mesh/formats/xml/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace orbicube::mesh {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t none = 255, blank = 254;

constexpr std::array<std::uint8_t, 256> values = [] {
  std::array<std::uint8_t, 256> table{};
  table.fill(none);
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    table[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  for (const char c : {' ', '\t', '\r', '\n'})
    table[static_cast<unsigned char>(c)] = blank;
  return table;
}();

}  // namespace

bool Base64Decoder::next_group() {
  std::uint32_t bits = 0;
  unsigned digits = 0, padding = 0;
  while (digits + padding < 4) {
    if (text_.empty()) return false;
    const char c = text_.front();
    text_.remove_prefix(1);
    const std::uint8_t value = values[static_cast<unsigned char>(c)];
    if (value == blank) continue;
    if (c == '=' && digits >= 2)
      ++padding;
    else if (value == none || padding > 0)
      return false;
    else
      ++digits;
    bits = bits << 6U | (value == none ? 0U : value);
  }
  for (unsigned i = 0; i < 3; ++i)
    group_[i] = static_cast<std::byte>(bits >> (16 - 8 * i) & 0xFFU);
  count_ = 3 - padding;
  used_ = 0;
  return true;
}

std::size_t Base64Decoder::read_some(std::span<std::byte> into) {
  for (std::size_t i = 0; i < into.size(); ++i) {
    if (used_ == count_ && !next_group()) return i;
    into[i] = group_[used_++];
  }
  return into.size();
}

bool Base64Decoder::at_end() {
  while (!text_.empty() && values[static_cast<unsigned char>(text_.front())] == blank)
    text_.remove_prefix(1);
  return text_.empty() && used_ == count_;
}

void append_base64(std::span<const std::byte> bytes, std::string& text) {
  text.reserve(text.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8U | (i < count ? std::to_integer<std::uint32_t>(bytes[at + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i)
      text += i <= count ? alphabet[bits >> (18 - 6 * i) & 63U] : '=';
  }
}

}  // namespace orbicube::mesh
