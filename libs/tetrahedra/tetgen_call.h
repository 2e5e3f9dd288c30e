// The one place that calls TetGen: the surface goes into a child process, the mesh of everything within its outer
// boundary comes back.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::tetrahedra {

using Quadruple = std::array<std::int32_t, 4>;
using Triple = std::array<std::int32_t, 3>;

struct TetgenOptions {
  double radius_edge_ratio = 0;                                      // 0: no refinement
  double max_volume = 0;                                             // 0: none
  std::function<double(const mesh::Vector3& center)> max_volume_at;  // of a tetrahedron there; empty: none
  int max_added = -1;  // vertices, of those that are added for quality and size; negative: any number
  bool keep_surface = true;
  double tolerance = 1e-8;  // below which TetGen takes points for equal and facets for coplanar, where all is of size 1
};

// As TetGen numbers things.
struct TetgenMesh {
  explicit TetgenMesh(std::pmr::memory_resource* memory)
      : positions(memory), tetrahedra(memory), neighbors(memory), faces(memory), face_sources(memory) {}

  base::Array<mesh::Vector3> positions;
  base::Array<Quadruple> tetrahedra;
  base::Array<Quadruple> neighbors;        // of each tetrahedron, opposite to its corners; negative for none
  base::Array<Triple> faces;               // in the surface
  base::Array<std::int32_t> face_sources;  // the triangle that each of them lies in
};

struct TetgenOutcome {
  enum class Kind : std::int32_t { done, refused, out_of_memory, crashed };
  Kind kind = Kind::done;
  int number = 0;  // TetGen's, of a refusal, or the signal of a crash
};

// Returns how it went, and the mesh if it went well. Throws Error "unsupported", "out-of-memory", "cancelled".
TetgenOutcome call_tetgen(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                          const TetgenOptions& options, const base::Host& host, TetgenMesh& result);

}  // namespace orbicube::tetrahedra
