#include "gltf/json/base64.h"

#include <array>
#include <cstdint>
#include <string>

#include "base/error.h"

namespace orbicube::gltf {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t not_in_alphabet = 0xFF;

constexpr auto values = [] {
  std::array<std::uint8_t, 256> table{};
  table.fill(not_in_alphabet);
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    table[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  return table;
}();

constexpr std::uint32_t value_of(char c) {
  return values[static_cast<unsigned char>(c)];
}

[[noreturn]] void fail_at(std::string_view text, std::size_t begin) {
  while (begin < text.size() && value_of(text[begin]) != not_in_alphabet)
    ++begin;
  throw base::Error("parse", begin == text.size() ? "base64 data ends inside a byte"
                                                  : "base64 data has an illegal character at " + std::to_string(begin));
}

}  // namespace

base::Array<std::byte> decode_base64(std::string_view text, const base::Host& host) {
  for (int padding = 0; padding < 2 && !text.empty() && text.back() == '='; ++padding)
    text.remove_suffix(1);
  const std::size_t quads = text.size() / 4, rest = text.size() % 4;
  if (rest == 1) fail_at(text, 0);
  base::Array<std::byte> bytes(quads * 3 + (rest == 0 ? 0 : rest - 1), host.memory);
  constexpr std::size_t quads_between_reports = std::size_t{1} << 18U;
  std::byte* to = bytes.data();
  for (std::size_t quad = 0; quad < quads; ++quad, to += 3) {
    if (quad % quads_between_reports == 0) host.report("decoding base64", quad, quads);
    const char* const from = text.data() + quad * 4;
    const std::uint32_t a = value_of(from[0]), b = value_of(from[1]), c = value_of(from[2]), d = value_of(from[3]);
    // Only the marker has one of the upper two bits.
    if (((a | b | c | d) & 0xC0U) != 0) fail_at(text, quad * 4);
    const std::uint32_t bits = a << 18U | b << 12U | c << 6U | d;
    to[0] = static_cast<std::byte>(bits >> 16U);
    to[1] = static_cast<std::byte>(bits >> 8U & 0xFFU);
    to[2] = static_cast<std::byte>(bits & 0xFFU);
  }
  if (rest > 0) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < rest; ++i) {
      const std::uint32_t value = value_of(text[quads * 4 + i]);
      if (value == not_in_alphabet) fail_at(text, quads * 4);
      bits |= value << (18U - 6U * static_cast<std::uint32_t>(i));
    }
    to[0] = static_cast<std::byte>(bits >> 16U);
    if (rest == 3) to[1] = static_cast<std::byte>(bits >> 8U & 0xFFU);
  }
  return bytes;
}

void encode_base64(std::span<const std::byte> bytes, char* to) {
  const auto byte = [&](std::size_t i) { return i < bytes.size() ? static_cast<std::uint32_t>(bytes[i]) : 0U; };
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t bits = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    const std::size_t characters = bytes.size() - i >= 3 ? 4 : bytes.size() - i + 1;
    for (std::size_t j = 0; j < 4; ++j)
      *to++ = j < characters ? alphabet[bits >> (18U - 6U * static_cast<std::uint32_t>(j)) & 0x3FU] : '=';
  }
}

}  // namespace orbicube::gltf
