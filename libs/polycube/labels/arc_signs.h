// Which arcs of a labeled surface are convex and which concave, so that the labeling is that of a polycube.
//
// At a corner of three patches with labels a, b, c counter-clockwise let chi = sign det(a, b, c). With chi = 1 the
// faces make three quarter turns and the three arcs are all convex or all concave. With chi = -1 they make five:
// exactly one arc differs from the other two, and the face opposite to it has the reflex angle. Along its outer loop
// each face turns by +4 quarters, along each hole by -4. So the signs of arcs decide how each face lies, and labels
// with no such signs are no polycube: where the rules conflict a patch is missing.
//
// Arcs at corners of chi = 1 have one sign, so they are joined first; what remains is a small problem of binary
// choices, solved by annealing from the target signs. If those satisfy the rules they are the result.
#pragma once

#include <span>

#include "polycube/labels/arc_network.h"

namespace orbicube::polycube {

struct ArcSigns {
  explicit ArcSigns(std::pmr::memory_resource* memory) : convex(memory), bad_corners(memory), bad_patches(memory) {}

  bool consistent() const { return bad_corners.empty() && bad_patches.empty(); }

  Array<std::uint8_t> convex;  // of each arc
  std::size_t changed = 0;     // arcs whose signs are not the target ones
  Array<Index> bad_corners;    // with chi = -1 whose arcs all have one sign
  Array<Index> bad_patches;    // with a loop that does not turn as it must
  double violation = 0;        // of the rules, 0 when consistent: bad corners, and turns of loops in units of 2
};

// `wanted[i]` is positive when arc i should be convex, and its size is what another sign costs. The result depends on
// `seed` where the target signs break the rules.
ArcSigns find_arc_signs(const Patches& patches, const Surface& surface, const ArcNetwork& network,
                        std::span<const double> wanted, std::uint64_t seed, const base::Host& host);

}  // namespace orbicube::polycube
