// Numbers of a given byte order, collected in large pieces on the way to a file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/array.h"
#include "base/host.h"
#include "mesh/files/file.h"

namespace orbicube::mesh {

class BinaryWriter {
 public:
  // `total` items are going to be written, for progress.
  BinaryWriter(OutputFile& file, std::endian order, std::uint64_t total, const base::Host& host)
      : file_(file), swapped_(order != std::endian::native), total_(total), host_(host), buffer_(host.memory) {
    buffer_.reserve(piece + piece / 2);
  }

  template <class Number>
  void put(Number x) {
    auto raw = std::bit_cast<std::array<std::byte, sizeof(Number)>>(x);
    if (swapped_) std::reverse(raw.begin(), raw.end());
    buffer_.insert(buffer_.end(), raw.begin(), raw.end());
  }
  void put_text(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  }

  // Call after each item.
  void end_item() {
    if (++done_ % 1024 != 0) return;
    host_.report("writing", done_, total_);
    if (buffer_.size() >= piece) flush();
  }
  // Call at the end.
  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 20U;

  OutputFile& file_;
  bool swapped_;
  std::uint64_t total_;
  const base::Host& host_;
  base::Array<std::byte> buffer_;
  std::uint64_t done_ = 0;
};

}  // namespace orbicube::mesh
