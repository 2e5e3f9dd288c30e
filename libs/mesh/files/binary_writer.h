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
#include "mesh/files/piece_writer.h"

namespace orbicube::mesh {

class BinaryWriter : public PieceWriter<base::Array<std::byte>> {
 public:
  // `total` items are going to be written, for progress.
  BinaryWriter(OutputFile& file, std::endian order, std::uint64_t total, const base::Host& host)
      : PieceWriter(file, total, host, base::Array<std::byte>(host.memory)), swapped_(order != std::endian::native) {
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

 private:
  bool swapped_;
};

}  // namespace orbicube::mesh
