// Surfaces at a size and place where no square overflows, vanishes or cancels, under the names of this library.
#pragma once

#include "mesh/search/placing.h"

namespace orbicube::sphere_map {

using mesh::normalized;
using mesh::Placing;
using mesh::placing_of;

}  // namespace orbicube::sphere_map
