// Data compressed by zlib, in builds with it.
#pragma once

#include <cstddef>
#include <span>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::mesh {

// Whether this build can compress and decompress.
bool has_zlib();

// More than any data of zlib grow by: for bounds of sizes that a file claims.
constexpr std::size_t zlib_max_expansion = 1040;

// Decompresses data in the format of zlib or gzip, which must fill `into` exactly. Throws Error "parse" if they are
// damaged or of another size, "unsupported" in builds without zlib, "cancelled".
void inflate_exactly(std::span<const std::byte> compressed, std::span<std::byte> into, const base::Host& host);

// Compresses in the format of zlib, for builds with it. The same bytes for each version of zlib are not promised.
base::Array<std::byte> deflate(std::span<const std::byte> bytes, const base::Host& host);

}  // namespace orbicube::mesh
