// A cube cut into six tetrahedra around one diagonal (Kuhn 1960): cubes of a grid cut so meet in whole faces.
#pragma once

#include <array>
#include <cstddef>

namespace orbicube::repair {

// Corner k has the coordinates (k & 1, k >> 1 & 1, k >> 2). Each tetrahedron is positive.
inline constexpr std::array<std::array<std::size_t, 4>, 6> tetrahedra_of_cube = {
    {{0, 1, 3, 7}, {0, 5, 1, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 6, 4, 7}}};

}  // namespace orbicube::repair
