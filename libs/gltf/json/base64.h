// Base64 (RFC 4648, section 4) for buffers inside a glTF text.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::gltf {

// The bytes that `text` stands for; padding may be missing. Throws Error "parse" with the position of a character that
// is none of base64's. O(length).
base::Array<std::byte> decode_base64(std::string_view text, const base::Host& host);

// Writes the text of `bytes` to `to`, which has room for base64_size(bytes.size()) characters. To encode in pieces,
// give pieces of a multiple of three bytes.
void encode_base64(std::span<const std::byte> bytes, char* to);

constexpr std::size_t base64_size(std::size_t bytes) {
  return (bytes + 2) / 3 * 4;
}

}  // namespace orbicube::gltf
