// Grid coordinates of directions: the angle from the pole and that around it, in lines of two periodic grids. A table
// of the lines' cosines and sines leaves an angle of less than a line to compute, so the place between two lines has
// the digits that the direction has, at any number of lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "harmonics/functions/basis.h"

namespace orbicube::harmonics {

// A coordinate: the nearest line but for rounding, and what is to be added to it.
struct GridPlace {
  std::int32_t line;
  double rest;
};

class GridAngles {
 public:
  // Grids of at least 64 lines in 2 pi.
  GridAngles(std::size_t rows, std::size_t columns, std::pmr::memory_resource* memory);

  // Directions that are computed at once.
  static constexpr std::size_t at_once = 64;

  // Writes the places of up to at_once directions of length 1: rows from 0 to rows / 2, columns from 0 to columns.
  void compute(std::span<const Vector3> unit, GridPlace* row, GridPlace* column) const;

 private:
  struct Line {
    double cosine, sine, cosine_rest, sine_rest;
  };
  static void fill(Array<Line>& lines);

  Array<Line> rows_, columns_;
};

}  // namespace orbicube::harmonics
