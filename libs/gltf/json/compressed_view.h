// Buffer views that are compressed by EXT_meshopt_compression (Kapoulkine, vendor extension of glTF 2.0), decoded by
// meshoptimizer. Meson chooses one of compressed_view_by_meshoptimizer.cpp and compressed_view_without.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/array.h"
#include "base/host.h"
#include "gltf/json/json.h"

namespace orbicube::gltf {

constexpr const char* compression_extension = "EXT_meshopt_compression";

// Maximum number of decoded bytes of a compressed one: sixteen equal bytes of an attribute take two bits.
constexpr std::uint64_t max_expansion = 64;

// Returns the version of meshoptimizer as major * 1000 + minor * 10 + patch; 0 in builds without it.
int version_of_meshoptimizer();

enum class CompressionMode { attributes, triangles, indices };
enum class CompressionFilter { none, octahedral, quaternion, exponential };

// The extension of a buffer view, checked: what meshoptimizer takes for granted holds.
struct Compression {
  std::uint64_t buffer, byte_offset, byte_length;
  std::size_t stride, count;  // of the decoded elements
  CompressionMode mode;
  CompressionFilter filter;
};

// Reads the extension of a buffer view that declares `view_length` bytes. Throws Error "parse" for what the extension
// does not allow, and "accessor-range" where its elements are not the view, or more than its bytes can hold.
Compression compression_of(JsonValue extension, std::uint64_t view_length);

// Returns the count * stride bytes of a compressed view; `where` is the extension in the file. Throws Error "truncated"
// when meshoptimizer refuses the bytes, "unsupported-extension" in builds without it.
base::Array<std::byte> decoded_view(const Compression& compression, std::span<const std::byte> bytes,
                                    const std::string& where, const base::Host& host);

}  // namespace orbicube::gltf
