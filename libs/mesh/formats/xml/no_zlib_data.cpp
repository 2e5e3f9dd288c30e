// What zlib_data.h declares, in builds without zlib.
#include "base/error.h"
#include "mesh/formats/xml/zlib_data.h"

namespace orbicube::mesh {

bool has_zlib() {
  return false;
}

void inflate_exactly(std::span<const std::byte>, std::span<std::byte>, const base::Host&) {
  throw base::Error("unsupported",
                    "compressed numbers are read in builds with zlib only; save the file without compression");
}

base::Array<std::byte> deflate(std::span<const std::byte>, const base::Host&) {
  throw base::Error("internal", "this build has no zlib");
}

}  // namespace orbicube::mesh
