// Compressed buffer views by meshoptimizer, whose decoders check the bytes that they read; the indices that they
// return may be anything. A view is decoded at once, at more than a gigabyte a second.
#include <meshoptimizer.h>

#include "base/error.h"
#include "gltf/json/compressed_view.h"

namespace orbicube::gltf {

namespace {

int decode(const Compression& view, std::span<const std::byte> bytes, std::byte* out) {
  const auto* const from = reinterpret_cast<const unsigned char*>(bytes.data());
  switch (view.mode) {
    case CompressionMode::triangles:
      return meshopt_decodeIndexBuffer(out, view.count, view.stride, from, bytes.size());
    case CompressionMode::indices:
      return meshopt_decodeIndexSequence(out, view.count, view.stride, from, bytes.size());
    case CompressionMode::attributes:
      break;
  }
  return meshopt_decodeVertexBuffer(out, view.count, view.stride, from, bytes.size());
}

void apply_filter(const Compression& view, std::byte* values) {
  switch (view.filter) {
    case CompressionFilter::none:
      return;
    case CompressionFilter::octahedral:
      return meshopt_decodeFilterOct(values, view.count, view.stride);
    case CompressionFilter::quaternion:
      return meshopt_decodeFilterQuat(values, view.count, view.stride);
    case CompressionFilter::exponential:
      return meshopt_decodeFilterExp(values, view.count, view.stride);
  }
}

}  // namespace

int version_of_meshoptimizer() {
  return MESHOPTIMIZER_VERSION;
}

base::Array<std::byte> decoded_view(const Compression& compression, std::span<const std::byte> bytes,
                                    const std::string& where, const base::Host& host) {
  host.report("decompress", 0, 1);
  base::Array<std::byte> out(compression.count * compression.stride, std::byte{0}, host.memory);
  if (compression.count == 0) return out;
  if (decode(compression, bytes, out.data()) != 0)
    throw base::Error("truncated",
                      where + ": the compressed bytes are cut off or damaged; meshoptimizer cannot decode them");
  apply_filter(compression, out.data());
  return out;
}

}  // namespace orbicube::gltf
