// What the tests of XML files of VTK and GIFTI share: numbers as these files store them.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "base/files/base64.h"
#include "mesh/formats/xml/zlib_data.h"

namespace orbicube::mesh {

template <class Number>
std::string raw_bytes(const std::vector<Number>& numbers, bool big_endian = false) {
  std::string bytes;
  for (const Number number : numbers) {
    std::string raw(sizeof number, '\0');
    std::memcpy(raw.data(), &number, sizeof number);
    if (big_endian != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
    bytes += raw;
  }
  return bytes;
}

inline std::string base64(const std::string& bytes) {
  std::string text;
  base::append_base64(std::as_bytes(std::span(bytes)), text);
  return text;
}

inline std::string compressed(const std::string& bytes) {
  const auto packed = deflate(std::as_bytes(std::span(bytes)), base::Host());
  return {reinterpret_cast<const char*>(packed.data()), packed.size()};
}

// The first place alone. A text without one is changed as well, so that no test takes it for what it expected.
inline std::string replaced_once(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  return at == std::string::npos ? text + "?" : text.replace(at, what.size(), by);
}

}  // namespace orbicube::mesh
