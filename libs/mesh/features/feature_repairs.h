// Repairs of feature lines that no mesh of few cells around a corner can follow.
#pragma once

#include "mesh/features/feature_lines.h"

namespace orbicube::mesh {

// Removes lines of at most `length` that end inside a patch at one end or both, but for those with an edge of `kept`:
// too short for a mesh of the solid, as those of noise. Returns whether there were any. O(n).
bool drop_short_ends(FeatureLines& lines, const FeatureLines& kept, double length, const base::Host& host);

// Continues lines that end inside a patch to another line, along the guides where there are any: edges of `guides`
// cost their length, others eight times as much. Along guides alone a line may close. Returns the vertices at which
// lines ended: those that edges other than guides continue, and those that guides alone do.
struct ContinuedEnds {
  Array<Index> by_others, by_guides;
};
ContinuedEnds continue_ends(FeatureLines& lines, const FeatureLines& guides, const base::Host& host);

// Cuts each sector of more than 300 degrees between the lines at a corner by a line from about its middle to another
// line; two quads of 180 degrees would have folds there. Returns how many were cut.
std::size_t cut_wide_sectors(FeatureLines& lines, const FeatureLines& guides, double angle, const base::Host& host);

}  // namespace orbicube::mesh
