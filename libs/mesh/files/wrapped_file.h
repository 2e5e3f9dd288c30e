// Files that hold a mesh in another wrapping than their ending says: compressed ones, and texts in UTF-16.
#pragma once

#include <cstddef>
#include <span>

namespace orbicube::mesh {

// Throws Error "unsupported-format" with what to do where the first bytes are those of a compressed file or of a text
// in UTF-16. Not for formats that may begin with any bytes.
void refuse_wrapped(std::span<const std::byte> bytes);

}  // namespace orbicube::mesh
