// A loop over many small independent items, under the name of this library.
#pragma once

#include "base/threads/pieces.h"

namespace orbicube::sphere_map {

using base::for_each_in_pieces;

}  // namespace orbicube::sphere_map
