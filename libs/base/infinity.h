#pragma once

#include <limits>

namespace orbicube::base {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace orbicube::base
