// Grids of the sphere as they are named on the command line: icosphere:6, cube:128, latitude:100, octahedron:256.
#pragma once

#include <string>

#include "sphere_map/sampling/grids.h"

namespace orbicube::cli {

struct GridChoice {
  sphere_map::GridKind kind;
  std::size_t resolution;
};

// What grids there are, for help texts.
inline constexpr const char* grid_help =
    "icosphere:LEVEL (10 * 4^LEVEL + 2 vertices), cube:N (N x N quads a side), latitude:N (N bands), octahedron:N (N x "
    "N quads, N even)";

// KIND or KIND:N. Throws Failure "usage" that names `option`.
GridChoice grid_choice(const std::string& text, const char* option);

// As it was chosen, with the resolution.
std::string name_of(const GridChoice& choice);

}  // namespace orbicube::cli
