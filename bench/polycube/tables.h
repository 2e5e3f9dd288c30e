// bench-polycube tables: the figures of the dissertation's Tables 4.2 and 4.3, for tables.py.
#pragma once

#include <span>
#include <string>

#include "base/host.h"

namespace orbicube::bench {

// Lines of fields between tabs, for each FILE:CORNERS. Table 4.2: "map", name, triangles, corners requested and had,
// means of angle and area over triangles as constructed and after Algorithm 3 by gradients, and seconds of the
// processor for the construction, the best proportions of what was constructed, and Algorithm 3. Table 4.3: "weight",
// name, weight of areas, both means, the energy before and after.
void measure_tables(std::span<const std::string> files, const base::Host& host);

}  // namespace orbicube::bench
