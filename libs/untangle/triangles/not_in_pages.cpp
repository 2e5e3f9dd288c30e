// In place of untangle_triangles.cpp in the module for web pages, which should not be over 3 MB.
#include "base/error.h"
#include "untangle/triangles/untangle_triangles.h"

namespace orbicube::untangle {

UntangledTriangles untangle_triangles(const TriangleProblem&, const UntangleOptions&, const base::Host&) {
  throw base::Error("unsupported", "flat meshes are not untangled in the module for web pages");
}

Array<std::uint8_t> boundary_vertices(std::span<const Triangle>, std::size_t, const base::Host& host) {
  return Array<std::uint8_t>(host.memory);
}

}  // namespace orbicube::untangle
