// Places for the patches of an atlas in a square, by masks of its cells.
#pragma once

#include <span>

#include "base/host.h"
#include "polycube/outputs/atlas.h"

namespace orbicube::polycube {

// A rectangle in the plane of a patch, seen from outside: u to the right, v up.
struct PatchBox {
  double u_low, v_low, u_high, v_high;
};

// The rectangles that patches consist of, patch by patch.
struct PatchBoxes {
  PatchBoxes(const PatchGraph& graph, const base::Host& host);

  std::span<const PatchBox> of(Index patch) const {
    return {boxes.data() + begin[patch], begin[patch + 1] - begin[patch]};
  }
  std::size_t patches() const { return begin.size() - 1; }

  Array<Index> begin;
  Array<PatchBox> boxes;
};

// The place of a patch without a position: the bounds of its rectangles. Throws Error "invalid-argument" for none.
AtlasPlace bounds_of(std::span<const PatchBox> boxes);

// Returns where a point of a patch is in its place, from the corner at the top left, at scale 1.
std::array<double, 2> in_place(const AtlasPlace& place, double u, double v);

// Packs at the largest scale up to `high` that bisection finds, on a grid of `cells` cells along a side; sets
// `places` and `scale`. Returns false where not even a thousandth of the square could be used. Throws Error
// "cancelled".
bool pack_largest(const PatchBoxes& boxes, double high, std::size_t cells, Atlas& atlas, const base::Host& host);

}  // namespace orbicube::polycube
