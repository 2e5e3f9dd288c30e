// bench-polycube factors: what it costs to solve the harmonic maps of a polycube's patches again when one of their
// edges has moved by a ring of triangles, by fresh factors and by factors that are brought up to date.
#pragma once

#include <span>
#include <string>

#include "base/host.h"

namespace orbicube::bench {

// Rows for each surface or map (map_files.h). With CHOLMOD where the library was built with it.
void measure_factors(std::span<const std::string> files, std::size_t corners, const base::Host& host);

}  // namespace orbicube::bench
