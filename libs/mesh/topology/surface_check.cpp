#include "mesh/topology/surface_check.h"

#include <string>

#include "base/error.h"

namespace orbicube::mesh {

void require_valid_surface(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const base::Host& host) {
  if (positions.size() >= no_index)
    throw base::Error("invalid-argument", "there are more vertices than 32-bit indices can count");
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % base::items_between_reports == 0) host.report("checking indices", t, triangles.size());
    for (const Index v : triangles[t]) {
      if (v >= positions.size()) {
        throw base::Error("invalid-argument", "triangle " + std::to_string(t) + " has vertex " + std::to_string(v) +
                                                  " of " + std::to_string(positions.size()));
      }
    }
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (v % base::items_between_reports == 0) host.report("checking positions", v, positions.size());
    if (!positions[v].allFinite())
      throw base::Error("invalid-argument", "the position of vertex " + std::to_string(v) + " is not finite");
  }
}

}  // namespace orbicube::mesh
