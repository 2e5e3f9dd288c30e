// One polycube for several shapes, against a polycube for each.
#pragma once

#include <span>
#include <string>

#include "base/host.h"

namespace orbicube::bench {

// Of surfaces in files: a table of energies and distortion, and the certified composition of the maps.
void compare_common(std::span<const std::string> files, std::size_t corners, const base::Host& host);

}  // namespace orbicube::bench
