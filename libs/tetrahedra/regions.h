// Which of TetGen's tetrahedra are solid: what an odd number of shells surrounds.
#pragma once

#include <cstdint>

#include "base/host.h"
#include "tetrahedra/tetgen_call.h"

namespace orbicube::tetrahedra {

struct Regions {
  explicit Regions(std::pmr::memory_resource* memory) : solid(memory), inside(memory) {}

  base::Array<std::uint8_t> solid;   // 1 for each tetrahedron of the solid, 0 for those of cavities
  base::Array<std::int32_t> inside;  // the tetrahedron on the solid's side of each face of the surface
  std::size_t parts = 0;             // of the solid, connected through faces
  std::size_t cavities = 0;
};

// Walks from tetrahedron to tetrahedron, from outside in, and counts the faces of the surface it crosses. Throws Error
// "no-valid-result" when the faces do not close, "cancelled". O(n).
Regions find_regions(const TetgenMesh& made, const base::Host& host);

}  // namespace orbicube::tetrahedra
