// The best corner points for a polycube that stays (the dissertation's section 4.4): E of eq. 4.14 over two coordinates
// in the disk around each corner point, all at once, by the derivative-free trust-region method of section 4.4.2 on the
// signed sum of squares of eq. 4.15.
//
// The squares are, of each rectangle, the parts of H with positive and with negative weights, and A. A corner point is
// at the vertex nearest in its disk. (The dissertation splits the triangle that it is in into three; a vertex of three
// triangles has too few edges for the paths of many corners.) Where paths cross, or more
// triangles flip than at the start, there is no value.
#pragma once

#include "polycube/dissertation/printed_map.h"

namespace orbicube::polycube::dissertation {

struct CornerMappingOptions {
  double area_weight = 1;
  std::uint64_t max_evaluations = 0;  // 0: 2 n + 1 for the first model of n unknowns, and n + 30
};

struct CornerMapping {
  explicit CornerMapping(std::pmr::memory_resource* memory) : corner_points(memory) {}

  Array<Index> corner_points;            // of the minimum energy, the start where none has less
  double energy_before = 0, energy = 0;  // E of eq. 4.14
  std::uint64_t evaluations = 0, failed = 0;
  bool converged = false;
};

// The start must have paths that do not meet. Throws Error "cancelled".
CornerMapping optimize_corner_mapping(const Layout& layout, std::span<const Index> corner_points, PrintedMapper& mapper,
                                      const CornerMappingOptions& options, const base::Host& host);

}  // namespace orbicube::polycube::dissertation
