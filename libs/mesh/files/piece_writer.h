// What text_writer.h and binary_writer.h share: bytes collected in large pieces on the way to a file, and progress.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/host.h"
#include "mesh/files/file.h"

namespace orbicube::mesh {

template <class Buffer>
class PieceWriter {
 public:
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

 protected:
  static constexpr std::size_t piece = std::size_t{1} << 20U;

  // `total` items are going to be written, for progress.
  PieceWriter(OutputFile& file, std::uint64_t total, const base::Host& host, Buffer buffer)
      : buffer_(std::move(buffer)), file_(file), total_(total), host_(host) {}

  Buffer buffer_;

 private:
  OutputFile& file_;
  std::uint64_t total_;
  const base::Host& host_;
  std::uint64_t done_ = 0;
};

}  // namespace orbicube::mesh
