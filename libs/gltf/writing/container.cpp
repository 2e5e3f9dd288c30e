#include "gltf/writing/container.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "base/counted.h"
#include "base/error.h"

namespace orbicube::gltf {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian, and is read as it is in memory");

namespace {

constexpr std::string_view magic = "glTF";
constexpr std::size_t header_size = 12, chunk_header_size = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534AU, binary_chunk = 0x004E4942U;

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

Container open_binary(std::span<const std::byte> bytes) {
  if (bytes.size() < header_size) throw base::Error("truncated", "the file ends inside the GLB header");
  const std::uint32_t version = word_at(bytes, 4), declared = word_at(bytes, 8);
  if (version != 2) throw base::Error("unsupported-version", "GLB version " + std::to_string(version) + ", not 2");
  if (declared > bytes.size()) {
    throw base::Error("truncated", "the GLB header says " + base::counted(declared, "byte") + ", the file has " +
                                       std::to_string(bytes.size()));
  }
  if (bytes.size() < header_size + chunk_header_size) throw base::Error("truncated", "the GLB file has no chunk");

  Container result;
  result.binary = true;
  std::size_t at = header_size;
  for (std::size_t number = 0; at < declared || number == 0; ++number) {
    const std::string name = "GLB chunk " + std::to_string(number);
    // A chunk that leaves the file is a file cut short; one that only leaves the declared length contradicts it.
    const auto check_end = [&](std::size_t length) {
      if (length > bytes.size() - at) throw base::Error("truncated", name + " reaches beyond the end of the file");
      if (at > declared || length > declared - at)
        throw base::Error("parse", name + " reaches beyond the length in the header");
    };
    check_end(chunk_header_size);
    const std::uint32_t length = word_at(bytes, at), type = word_at(bytes, at + 4);
    at += chunk_header_size;
    check_end(length);
    const std::span<const std::byte> content = bytes.subspan(at, length);
    at += length;
    if (number == 0) {
      if (type != json_chunk) throw base::Error("parse", "the first chunk of the GLB file is not JSON");
      result.json = {reinterpret_cast<const char*>(content.data()), content.size()};
    } else if (number == 1 && type == binary_chunk) {
      result.chunk = content;
    }
  }
  result.trailing_bytes = bytes.size() - declared;
  return result;
}

}  // namespace

Container open_container(std::span<const std::byte> bytes) {
  if (bytes.empty()) throw base::Error("empty-file", "the file has no bytes");
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with(magic) || magic.starts_with(text)) return open_binary(bytes);
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || (text[first] != '{' && text[first] != '['))
    throw base::Error("bad-magic", "the file begins neither as GLB nor as JSON");
  Container result;
  result.json = text;
  return result;
}

}  // namespace orbicube::gltf
