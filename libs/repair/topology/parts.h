// Parts of a surface, connected through edges: which are kept.
#pragma once

#include "repair/types.h"

namespace orbicube::repair {

struct PartOptions {
  std::size_t keep = 1;         // the largest N by area; 0: no limit
  double min_area_percent = 0;  // of the area of all
  bool cavities = false;        // parts inside an odd number of others bound cavities, and are inward-oriented
};

struct PartFigures {
  std::size_t found = 0;
  std::size_t kept = 0;
  std::size_t cavities = 0;
  std::size_t dropped_triangles = 0;
  double dropped_area_percent = 0;
};

// One part: its number is that of its first triangle.
struct Part {
  Index first;
  std::size_t triangles;
  double area;
};

// Returns the parts in descending order of area.
Array<Part> parts_of(const Soup& soup, const base::Host& host);

// Removes parts: those that are not among the largest, or too small. O(n log n). Throws Error "cancelled".
PartFigures keep_parts(Soup& soup, const PartOptions& options, const Context& context);

// Of closed parts that are all outward-oriented, those inside an odd number of others are turned inward if cavities are
// kept, and else dropped with those inside of them. A part is inside another if its first triangle is, or of parts that
// meet, if all points of a choice are: parts that cross stay both. O(n log n) where few boxes of parts overlap. Adds to
// the figures. Throws Error "cancelled".
void settle_nested_parts(Soup& soup, bool cavities, PartFigures& figures, const Context& context);

}  // namespace orbicube::repair
