// A solid of tetrahedra in arrays of the caller.
#pragma once

#include <cstdint>
#include <string>

#include "capi/src/entry.h"
#include "mesh/mesh.h"

namespace orbicube::capi {

// The caller's tetrahedra, of which no more is known than their numbers.
inline mesh::Mesh solid_of(const double* positions, size_t vertex_count, const uint32_t* tetrahedra,
                           size_t tetrahedron_count, const base::Host& host) {
  require(positions != nullptr || vertex_count == 0, "positions is NULL");
  require(tetrahedra != nullptr || tetrahedron_count == 0, "tetrahedra is NULL");
  constexpr std::size_t most = UINT32_MAX / 4;
  require(vertex_count < most && tetrahedron_count < most, "too many vertices or tetrahedra");
  mesh::Mesh solid(host.memory);
  const auto* const places = reinterpret_cast<const mesh::Vector3*>(positions);
  const auto* const cells = reinterpret_cast<const mesh::Tetrahedron*>(tetrahedra);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (!places[v].allFinite())
      throw base::Error("invalid-argument", "the position of vertex " + std::to_string(v) + " is not finite");
  }
  solid.positions.assign(places, places + vertex_count);
  solid.tetrahedra.assign(cells, cells + tetrahedron_count);
  return solid;
}

}  // namespace orbicube::capi
