#include "mesh/formats/xml/zlib_data.h"

#include <zlib.h>
#include <algorithm>
#include <new>

#include "base/error.h"

namespace orbicube::mesh {

namespace {

constexpr std::size_t piece = std::size_t{1} << 18U;  // bytes between two reports to the host

class Inflation {
 public:
  Inflation() {
    // 15: the largest window; 32: gzip or zlib, whichever it is.
    if (inflateInit2(&z, 15 + 32) != Z_OK) throw std::bad_alloc();
  }
  ~Inflation() { inflateEnd(&z); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  z_stream z{};
};

class Deflation {
 public:
  Deflation() {
    if (deflateInit(&z, Z_DEFAULT_COMPRESSION) != Z_OK) throw std::bad_alloc();
  }
  ~Deflation() { deflateEnd(&z); }
  Deflation(const Deflation&) = delete;
  Deflation& operator=(const Deflation&) = delete;
  z_stream z{};
};

// zlib does not write to its input.
Bytef* input(std::span<const std::byte> bytes) {
  return const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
}

}  // namespace

bool has_zlib() {
  return true;
}

void inflate_exactly(std::span<const std::byte> compressed, std::span<std::byte> into, const base::Host& host) {
  Inflation inflation;
  z_stream& z = inflation.z;
  std::size_t taken = 0, given = 0;
  std::byte beyond{};  // where one byte more than the size would go
  while (true) {
    host.report("reading", taken, compressed.size());
    const auto in = compressed.subspan(taken, std::min(piece, compressed.size() - taken));
    const auto out = given < into.size() ? into.subspan(given, std::min(piece, into.size() - given))
                                         : std::span<std::byte>(&beyond, 1);
    z.next_in = input(in);
    z.avail_in = static_cast<uInt>(in.size());
    z.next_out = reinterpret_cast<Bytef*>(out.data());
    z.avail_out = static_cast<uInt>(out.size());
    const int state = ::inflate(&z, Z_NO_FLUSH);
    taken += in.size() - z.avail_in;
    given += out.size() - z.avail_out;
    if (state == Z_MEM_ERROR) throw std::bad_alloc();
    if (given > into.size()) throw base::Error("parse", "compressed data are longer than the file says");
    if (state == Z_STREAM_END) break;
    if (state != Z_OK) {
      throw base::Error("parse", state == Z_BUF_ERROR && taken == compressed.size() ? "compressed data are cut short"
                                                                                    : "compressed data are damaged");
    }
  }
  if (given < into.size()) throw base::Error("parse", "compressed data are shorter than the file says");
}

base::Array<std::byte> deflate(std::span<const std::byte> bytes, const base::Host& host) {
  Deflation deflation;
  z_stream& z = deflation.z;
  base::Array<std::byte> result(host.memory);
  std::size_t taken = 0;
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    const auto in = bytes.subspan(taken, std::min(piece, bytes.size() - taken));
    const std::size_t before = result.size();
    result.resize(before + piece / 4);
    z.next_in = input(in);
    z.avail_in = static_cast<uInt>(in.size());
    z.next_out = reinterpret_cast<Bytef*>(result.data() + before);
    z.avail_out = static_cast<uInt>(piece / 4);
    state = ::deflate(&z, taken + in.size() == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    taken += in.size() - z.avail_in;
    result.resize(result.size() - z.avail_out);
    if (state == Z_STREAM_ERROR) throw base::Error("internal", "zlib refuses to compress");
  }
  return result;
}

}  // namespace orbicube::mesh
