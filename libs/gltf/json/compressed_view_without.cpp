// Compressed buffer views in builds without meshoptimizer.
#include "base/error.h"
#include "gltf/json/compressed_view.h"

namespace orbicube::gltf {

int version_of_meshoptimizer() {
  return 0;
}

base::Array<std::byte> decoded_view(const Compression&, std::span<const std::byte>, const std::string& where,
                                    const base::Host&) {
  throw base::Error("unsupported-extension", where + " is compressed, and this build is without meshoptimizer");
}

}  // namespace orbicube::gltf
