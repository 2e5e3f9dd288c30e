// The figures of a sphere map as the report page shows them.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sphere_map/measure.h"

namespace orbicube::cli {

// Rows of the page's table, in reading order. The weights are those that `map` was measured with.
std::vector<std::pair<std::string, std::string>> page_figures(const sphere_map::Measurement& map, std::size_t vertices,
                                                              std::size_t triangles, double angle_weight,
                                                              double area_weight);

}  // namespace orbicube::cli
