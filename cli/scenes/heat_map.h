// A matrix as a picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::cli {

struct HeatColor {
  std::uint8_t red, green, blue;
};

// From black for 0 through blue, magenta and orange to a light yellow for 1, ever lighter, so that it reads in gray as
// well.
HeatColor heat_color(double share);

// A PNG of a square matrix of numbers that are not negative, in these colors as parts of the largest. Rows and columns
// are numbered from 1, cells that are large enough show their number, and a scale stands on the right. The bytes of the
// file.
base::Array<std::byte> heat_map_png(const std::vector<std::vector<double>>& matrix, const base::Host& host);

}  // namespace orbicube::cli
