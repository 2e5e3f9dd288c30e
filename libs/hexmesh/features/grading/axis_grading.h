// Cells of different sizes without hanging nodes: a grid in space whose planes are closer to each other where an axis
// needs it. Three increasing functions, one an axis, turn lengths into numbers of cells.
#pragma once

#include "hexmesh/types.h"

namespace orbicube::hexmesh {

class AxisGrading {
 public:
  // Of cells of one size everywhere, between the corners of a box.
  AxisGrading(const Vector3& low, const Vector3& high, double size, const base::Host& host);

  // Cells of at most `size` between two points, along those axes that the segment between them is not at a large angle
  // to. No effect before the next spread().
  void refine(const Vector3& from, const Vector3& to, double size);
  // Lets sizes grow gradually away from where they are small.
  void spread();

  // A point in numbers of cells from the lower corner, and back. Outside the box sizes are those at its faces.
  Vector3 cells(const Vector3& p) const;
  Vector3 position(const Vector3& cells) const;
  // Of the cell at p, along each axis.
  Vector3 size(const Vector3& p) const;
  double base_size() const { return base_; }

 private:
  static constexpr std::size_t intervals = 4096;

  std::size_t interval(std::size_t axis, double x) const;

  double base_;
  Vector3 low_, step_;
  std::array<Array<double>, 3> size_;   // of each interval
  std::array<Array<double>, 3> cells_;  // at the begin of each interval, and at the end
};

}  // namespace orbicube::hexmesh
