// Reads numbers of a given byte order from the bytes of a binary block, and says at which byte something is wrong.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "base/counted.h"
#include "base/error.h"
#include "base/host.h"

namespace orbicube::mesh {

class BinaryScanner {
 public:
  // `offset` is where `bytes` begins in the file, for messages.
  BinaryScanner(std::span<const std::byte> bytes, std::size_t offset, std::endian order, const base::Host& host)
      : bytes_(bytes), offset_(offset), swapped_(order != std::endian::native), host_(host) {}

  std::size_t left() const { return bytes_.size() - at_; }

  // Throws "truncated" unless the given number of bytes are left.
  void require(std::uint64_t bytes, const char* what) const {
    if (bytes > left()) fail("truncated", std::string("the file ends inside ") + what);
  }
  // The same for `items` of `bytes_each` bytes or more.
  void require_room(std::uint64_t items, std::uint64_t bytes_each, const char* what) const {
    if (items > left() / bytes_each) {
      fail("truncated", "the file says that it has " + std::to_string(items) + " " + what + ", but only " +
                            base::counted(left(), "byte follows", "bytes follow"));
    }
  }

  // After require(): the next number.
  template <class Number>
  Number next() {
    std::array<std::byte, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes_.data() + at_, sizeof(Number));
    if (swapped_) std::reverse(raw.begin(), raw.end());
    at_ += sizeof(Number);
    return std::bit_cast<Number>(raw);
  }
  void skip(std::size_t bytes) { at_ += bytes; }
  std::span<const std::byte> rest() const { return bytes_.subspan(at_); }
  // The text up to the next line end or the end of the block, and past it.
  std::string_view line() {
    const std::string_view rest(reinterpret_cast<const char*>(bytes_.data()) + at_, left());
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    at_ += std::min(length + 1, rest.size());
    return rest.substr(0, length);
  }

  [[noreturn]] void fail(const char* kind, const std::string& what) const {
    throw base::Error(kind, "byte " + std::to_string(offset_ + at_) + ": " + what);
  }

  // Reports to the host how far the block is read. Call once an item: most calls cost an addition.
  void progress() {
    if (++calls_ % 4096 == 0) host_.report("reading", offset_ + at_, offset_ + bytes_.size());
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t offset_;
  std::size_t at_ = 0;
  bool swapped_;
  std::uint64_t calls_ = 0;
  const base::Host& host_;
};

}  // namespace orbicube::mesh
