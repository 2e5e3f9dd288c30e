// The angles between neighboring frames as a picture: bars of a degree each and the curve of their sum, as in the
// dissertation's Figure 6.3.
#pragma once

#include <cstddef>
#include <span>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::cli {

// A PNG file. `histogram` counts the faces of each degree from 0 on; bars show the share of the faces with such
// an angle, the curve that of the faces below each angle, on one scale from 0 to 100 per cent.
base::Array<std::byte> angle_plot(std::span<const std::size_t> histogram, const base::Host& host);

}  // namespace orbicube::cli
