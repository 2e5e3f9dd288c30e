// Bytes in the data of a page.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/files/base64.h"

namespace orbicube::cli {

inline std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  base::append_base64(std::as_bytes(bytes), text);
  return text;
}

}  // namespace orbicube::cli
