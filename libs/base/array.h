// The array that every library keeps its bulk data in: a std::vector whose memory comes from the host (host.h).
#pragma once

#include <memory_resource>
#include <vector>

namespace orbicube::base {

template <class T>
using Array = std::pmr::vector<T>;

}  // namespace orbicube::base
