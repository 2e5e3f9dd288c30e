// What the texels of an atlas show: for textures that are computed from the surface.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/host.h"
#include "polycube/outputs/atlas.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

// Where the corners of a triangle are in the texture, in texels.
using TexelCorners = std::array<std::array<double, 2>, 3>;

// Of each triangle of the map. Throws Error "cancelled".
Array<TexelCorners> texel_corners(const Atlas& atlas, const PatchGraph& graph, const SurfaceMap& map,
                                  const base::Host& host);

struct AtlasTexels {
  explicit AtlasTexels(std::pmr::memory_resource* memory) : triangles(memory), shown(memory) {}

  std::uint32_t size = 0;  // along each side
  // Row by row from the top.
  Array<Index> triangles;  // of the map, that has the middle of the texel; no_index beside the patches
  Array<Index> shown;      // the texel whose color it has: itself, or beside the patches the nearest in one
};

// Texels beside the patches show the nearest in a patch, by steps along rows and columns, so that filters and smaller
// copies of a texture mix nothing else into its patches. `shown` has no_index only where no patch has the middle of any
// texel. O(texels + triangles). Throws Error "cancelled".
AtlasTexels covered_texels(std::uint32_t size, std::span<const TexelCorners> corners, const base::Host& host);

// Returns where the middle of a covered texel lies in its triangle: weights of the corners, none negative, sum 1.
Vector3 weights_at(std::span<const TexelCorners> corners, const AtlasTexels& texels, Index texel);

}  // namespace orbicube::polycube
