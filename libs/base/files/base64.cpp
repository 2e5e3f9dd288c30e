#include "base/files/base64.h"

#include <array>
#include <cstdint>

#include "base/error.h"

namespace orbicube::base {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
// Only these have one of the upper two bits.
constexpr std::uint8_t not_in_alphabet = 0xFF, blank = 0xFE;
constexpr std::uint32_t upper_bits = 0xC0U;

constexpr auto values = [] {
  std::array<std::uint8_t, 256> table{};
  table.fill(not_in_alphabet);
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    table[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
  for (const char c : {' ', '\t', '\r', '\n'})
    table[static_cast<unsigned char>(c)] = blank;
  return table;
}();

constexpr std::uint32_t value_of(char c) {
  return values[static_cast<unsigned char>(c)];
}

// The first `count` of the three bytes in 24 bits.
void put_bytes(std::uint32_t bits, std::size_t count, std::byte* to) {
  for (std::size_t i = 0; i < count; ++i)
    to[i] = static_cast<std::byte>(bits >> (16 - 8 * i) & 0xFFU);
}

[[noreturn]] void fail_at(std::string_view text, std::size_t begin) {
  while (begin < text.size() && (value_of(text[begin]) & upper_bits) == 0)
    ++begin;
  throw Error("parse", begin == text.size() ? "base64 data ends inside a byte"
                                            : "base64 data has an illegal character at " + std::to_string(begin));
}

}  // namespace

void encode_base64(std::span<const std::byte> bytes, char* to) {
  const auto byte = [&](std::size_t i) { return i < bytes.size() ? static_cast<std::uint32_t>(bytes[i]) : 0U; };
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t bits = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    const std::size_t characters = bytes.size() - i >= 3 ? 4 : bytes.size() - i + 1;
    for (std::size_t j = 0; j < 4; ++j)
      *to++ = j < characters ? alphabet[bits >> (18U - 6U * static_cast<std::uint32_t>(j)) & 0x3FU] : '=';
  }
}

void append_base64(std::span<const std::byte> bytes, std::string& text) {
  const std::size_t before = text.size();
  text.resize(before + base64_size(bytes.size()));
  encode_base64(bytes, text.data() + before);
}

Array<std::byte> decode_base64(std::string_view text, const Host& host) {
  for (int padding = 0; padding < 2 && !text.empty() && text.back() == '='; ++padding)
    text.remove_suffix(1);
  const std::size_t quads = text.size() / 4, rest = text.size() % 4;
  if (rest == 1) fail_at(text, 0);
  Array<std::byte> bytes(quads * 3 + (rest == 0 ? 0 : rest - 1), host.memory);
  constexpr std::size_t quads_between_reports = std::size_t{1} << 18U;
  std::byte* to = bytes.data();
  for (std::size_t quad = 0; quad < quads; ++quad, to += 3) {
    if (quad % quads_between_reports == 0) host.report("decoding base64", quad, quads);
    const char* const from = text.data() + quad * 4;
    const std::uint32_t a = value_of(from[0]), b = value_of(from[1]), c = value_of(from[2]), d = value_of(from[3]);
    if (((a | b | c | d) & upper_bits) != 0) fail_at(text, quad * 4);
    put_bytes(a << 18U | b << 12U | c << 6U | d, 3, to);
  }
  if (rest > 0) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < rest; ++i) {
      const std::uint32_t value = value_of(text[quads * 4 + i]);
      if ((value & upper_bits) != 0) fail_at(text, quads * 4);
      bits |= value << (18U - 6U * static_cast<std::uint32_t>(i));
    }
    put_bytes(bits, rest - 1, to);
  }
  return bytes;
}

bool Base64Decoder::next_group() {
  std::uint32_t bits = 0;
  unsigned digits = 0, padding = 0;
  while (digits + padding < 4) {
    if (text_.empty()) return false;
    const char c = text_.front();
    text_.remove_prefix(1);
    const std::uint32_t value = value_of(c);
    if (value == blank) continue;
    if (c == '=' && digits >= 2)
      ++padding;
    else if (value == not_in_alphabet || padding > 0)
      return false;
    else
      ++digits;
    bits = bits << 6U | (value == not_in_alphabet ? 0U : value);
  }
  put_bytes(bits, 3, group_);
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
  while (!text_.empty() && value_of(text_.front()) == blank)
    text_.remove_prefix(1);
  return text_.empty() && used_ == count_;
}

}  // namespace orbicube::base
