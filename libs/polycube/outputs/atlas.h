// A texture atlas: the patches of a polycube, packed into a square without overlap.
//
// All patches have one scale, so that texels have one size on the polycube. Patches are placed in order of length, as
// by Levy, Petitjean, Ray and Maillot (2002), but by masks, so that patches fill notches and holes of others: each
// patch takes the cells of a grid that it and its margin touch, in the one of its four directions and at the place
// where it ends nearest to the top. Bisection finds the largest scale at which all fit; where a patch does not, a few
// orders with that patch earlier are tried.
#pragma once

#include <array>
#include <cstdint>

#include "base/host.h"
#include "polycube/outputs/patch_graph.h"

namespace orbicube::polycube {

struct AtlasOptions {
  std::uint32_t size = 1024;  // texels along each side
  double padding = 4;         // minimum number of texels between two patches; half of it between a patch and the border
};

// Where a patch is. Texels count from the left and from the top.
struct AtlasPlace {
  double u_low = 0, v_low = 0, u_high = 0,
         v_high = 0;         // of the patch, in its plane seen from outside: u to the right, v up
  double left = 0, top = 0;  // texels
  int quarter_turns = 0;     // 0 to 3, counter-clockwise
};

struct Atlas {
  explicit Atlas(std::pmr::memory_resource* memory) : places(memory) {}

  AtlasOptions options;
  double scale = 0;          // texels along a unit of the polycube
  double coverage = 0;       // of the square by patches: 0 to 1
  Array<AtlasPlace> places;  // one a patch
};

// Throws Error "invalid-argument" for a size that is not from 1 to 16384 or a padding that is negative or not finite,
// "unsupported" when the square is too small for the padding of all patches, "cancelled".
Atlas make_atlas(const PatchGraph& graph, const AtlasOptions& options, const base::Host& host);

// Returns where a point of a patch is in the texture, in texels: no triangle of a patch is mirrored.
std::array<double, 2> texel_of(const Atlas& atlas, const PatchGraph& graph, Index patch, const Vector3& on_polycube);

}  // namespace orbicube::polycube
