// FNV-1a, 64 bits, eight bytes at a time: distinguishes a damaged or foreign blob from a good one (not meant against
// malice).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace orbicube::base {

class Hash {
 public:
  void add(std::span<const std::byte> bytes) {
    std::size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
      std::uint64_t word;
      std::memcpy(&word, bytes.data() + i, 8);
      mix(word);
    }
    for (; i < bytes.size(); ++i)
      mix(static_cast<std::uint64_t>(bytes[i]));
  }
  std::uint64_t value() const { return value_; }

 private:
  void mix(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3U;
    value_ ^= value_ >> 32;
  }
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace orbicube::base
