// Compressed bytes, in builds with zlib.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::cli {

// Returns the version of zlib, nothing in builds without it.
std::optional<std::string> version_of_zlib();

bool is_gzip(std::span<const std::byte> bytes);

// Returns the first `wanted` bytes, or all if there are fewer, of data in the format of gzip or zlib. The checksum is
// compared where the data end there. Throws Error "parse" if they are damaged, "unsupported" in builds without zlib,
// "cancelled".
base::Array<std::byte> inflate(std::span<const std::byte> bytes, std::size_t wanted, const base::Host& host);

}  // namespace orbicube::cli
