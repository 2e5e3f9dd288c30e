#include "images/inflate.h"

#include <algorithm>

#include "base/error.h"
#ifdef ORBICUBE_WITH_ZLIB
#include <zlib.h>
#endif

namespace orbicube::cli {

std::optional<std::string> version_of_zlib() {
#ifdef ORBICUBE_WITH_ZLIB
  return zlibVersion();
#else
  return std::nullopt;
#endif
}

bool is_gzip(std::span<const std::byte> bytes) {
  return bytes.size() >= 2 && bytes[0] == std::byte{0x1f} && bytes[1] == std::byte{0x8b};
}

#ifdef ORBICUBE_WITH_ZLIB
namespace {

class Stream {
 public:
  explicit Stream(std::span<const std::byte> bytes) : rest_(bytes) {
    // 15: the largest window; 32: gzip or zlib, whichever it is.
    if (inflateInit2(&z_, 15 + 32) != Z_OK) throw std::bad_alloc();
  }
  ~Stream() { inflateEnd(&z_); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  // Fills the front of a piece and returns its size; less at the end of the data only.
  std::size_t read(std::span<std::byte> into) {
    z_.next_out = reinterpret_cast<Bytef*>(into.data());
    z_.avail_out = static_cast<uInt>(into.size());
    while (z_.avail_out > 0 && !ended_) {
      const std::size_t given = std::min<std::size_t>(rest_.size(), std::size_t{1} << 30);
      z_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(rest_.data()));  // zlib does not write to it
      z_.avail_in = static_cast<uInt>(given);
      const int state = ::inflate(&z_, Z_NO_FLUSH);
      rest_ = rest_.subspan(given - z_.avail_in);
      if (state == Z_MEM_ERROR) throw std::bad_alloc();
      if (state == Z_STREAM_END) {
        // Some programs write several compressed streams one after the other.
        ended_ = !is_gzip(rest_) || inflateReset(&z_) != Z_OK;
      } else if (state == Z_BUF_ERROR && rest_.empty()) {
        ended_ = true;  // truncated: the caller sees the size
      } else if (state != Z_OK && state != Z_BUF_ERROR) {
        throw base::Error("parse", "the compressed data are damaged");
      }
    }
    return into.size() - z_.avail_out;
  }

 private:
  z_stream z_{};
  std::span<const std::byte> rest_;
  bool ended_ = false;
};

}  // namespace

base::Array<std::byte> inflate(std::span<const std::byte> bytes, std::size_t wanted, const base::Host& host) {
  constexpr std::size_t piece = std::size_t{1} << 20;
  Stream stream(bytes);
  base::Array<std::byte> result(host.memory);
  while (result.size() < wanted) {
    host.report("reading", result.size(), wanted);
    const std::size_t before = result.size(), size = std::min(piece, wanted - before);
    result.resize(before + size);
    const std::size_t got = stream.read(std::span(result).subspan(before));
    result.resize(before + got);
    if (got < size) return result;
  }
  std::byte beyond{};
  stream.read(std::span(&beyond, 1));  // compares the checksum
  return result;
}
#else
base::Array<std::byte> inflate(std::span<const std::byte>, std::size_t, const base::Host&) {
  throw base::Error("unsupported", "compressed images are read in builds with zlib only; decompress it first");
}
#endif

}  // namespace orbicube::cli
