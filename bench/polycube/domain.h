// bench-polycube domain: what the best proportions of polycubes are worth, and what they cost.
#pragma once

#include <span>
#include <string>

#include "base/host.h"

namespace orbicube::bench {

// Rows for each surface, which is mapped by labels and grid-based first; a file NAME.surface.ply with NAME.polycube.ply
// beside it is a map already.
void measure_domains(std::span<const std::string> files, std::size_t corners, const base::Host& host);

}  // namespace orbicube::bench
