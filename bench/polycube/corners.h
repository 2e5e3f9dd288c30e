// bench-polycube corners: what the best positions for corners are worth, and what they cost beside NLopt's BOBYQA.
#pragma once

#include <span>
#include <string>

#include "base/host.h"

namespace orbicube::bench {

// Rows for each surface, which is mapped first; a file NAME.surface.ply with NAME.polycube.ply beside it is a map
// already.
void measure_corners(std::span<const std::string> files, std::size_t corners, const base::Host& host);

}  // namespace orbicube::bench
