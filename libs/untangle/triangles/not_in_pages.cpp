// In place of untangle_triangles.cpp and of refine/ in the module for web pages, which should not be over 3 MB.
#include "base/error.h"
#include "untangle/refine/refined.h"
#include "untangle/triangles/untangle_triangles.h"

namespace orbicube::untangle {

UntangledTriangles untangle_triangles(const TriangleProblem&, const UntangleOptions&, const base::Host&) {
  throw base::Error("unsupported", "flat meshes are not untangled in the module for web pages");
}

Array<std::uint8_t> boundary_vertices(std::span<const Triangle>, std::size_t, const base::Host& host) {
  return Array<std::uint8_t>(host.memory);
}

RefinedTriangles untangle_refined(const TriangleProblem&, const UntangleOptions&, const base::Host&) {
  throw base::Error("unsupported", "flat meshes are not untangled in the module for web pages");
}

RefinedTetrahedra untangle_refined(const UntangleProblem&, const UntangleOptions&, const base::Host&) {
  throw base::Error("unsupported", "tetrahedra are not split in the module for web pages");
}

}  // namespace orbicube::untangle
