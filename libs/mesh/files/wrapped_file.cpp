#include "mesh/files/wrapped_file.h"

#include <array>
#include <string>
#include <string_view>

#include "base/error.h"

namespace orbicube::mesh {
namespace {

struct Wrapping {
  std::string_view first_bytes;
  const char* name;
};
using namespace std::string_view_literals;
constexpr std::array compressed = {
    Wrapping{"\x1F\x8B"sv, "gzip"},
    Wrapping{"PK\x03\x04"sv, "zip"},
    Wrapping{"BZh"sv, "bzip2"},
    Wrapping{"\xFD"
             "7zXZ"sv,
             "xz"},
    Wrapping{"\x28\xB5\x2F\xFD"sv, "zstd"},
};

// With a byte order mark, or with each second byte zero at the beginning, as texts in the Latin alphabet have it.
bool is_utf_16(std::string_view text) {
  if (text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv)) return true;
  const auto letter = [](char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t'; };
  if (text.size() < 4) return false;
  const auto alternate = [&](std::size_t first) {
    return letter(text[first]) && letter(text[first + 2]) && text[1 - first] == '\0' && text[3 - first] == '\0';
  };
  return alternate(0) || alternate(1);
}

}  // namespace

void refuse_wrapped(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const Wrapping& wrapping : compressed) {
    if (text.starts_with(wrapping.first_bytes)) {
      throw base::Error("unsupported-format",
                        std::string("the file is compressed (") + wrapping.name + "); decompress it first");
    }
  }
  if (is_utf_16(text)) throw base::Error("unsupported-format", "the file is a text in UTF-16; save it as UTF-8");
}

}  // namespace orbicube::mesh
