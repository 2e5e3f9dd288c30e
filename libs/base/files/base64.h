// Bytes as text of 64 characters (RFC 4648, section 4), as glTF and XML files have them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::base {

constexpr std::size_t base64_size(std::size_t bytes) {
  return (bytes + 2) / 3 * 4;
}

// Writes the text of `bytes` to `to`, which has room for base64_size(bytes.size()) characters. To encode in pieces,
// give pieces of a multiple of three bytes.
void encode_base64(std::span<const std::byte> bytes, char* to);

// Appends the text of these bytes.
void append_base64(std::span<const std::byte> bytes, std::string& text);

// The bytes that `text` stands for; padding may be missing. Throws Error "parse" with the position of a character that
// is none of base64's. O(length).
Array<std::byte> decode_base64(std::string_view text, const Host& host);

// Decodes from the front of a text. Blanks and ends of lines are skipped; where padding ends a block, the next one may
// follow, since some programs encode the header of an array and its contents one after the other.
class Base64Decoder {
 public:
  explicit Base64Decoder(std::string_view text) : text_(text) {}

  // Fills `into`. Returns false where the text ends before, or has a character that is none of the 64.
  bool read(std::span<std::byte> into) { return read_some(into) == into.size(); }
  // The same. Returns the number of bytes that were read.
  std::size_t read_some(std::span<std::byte> into);
  // No more bytes than this are left.
  std::size_t max_left() const { return 3 * (text_.size() / 4 + 1) + count_ - used_; }
  // Whether nothing but blanks is left.
  bool at_end();

 private:
  bool next_group();

  std::string_view text_;
  std::byte group_[3] = {};
  std::size_t count_ = 0, used_ = 0;  // bytes of the group, and those of them that are read
};

}  // namespace orbicube::base
