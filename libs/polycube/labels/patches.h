// The patches of a labeled surface: connected sets of triangles with one label, which become patches of the polycube;
// the loops that bound them; and what is plainly wrong with them as patches of a polycube.
//
// Rules as in PolyCut (Livesu, Vining, Sheffer, Gregson and Scateni 2013): three patches at most meet at a vertex, no
// patch borders one of the opposite direction, and each has four corners at least along each loop. Patches may have
// holes but no handles. The rules are necessary (but for corners of valence above 3) and not sufficient: see
// arc_signs.h.
#pragma once

#include <span>

#include "polycube/surface/surface.h"

namespace orbicube::polycube {

struct Patches {
  explicit Patches(std::pmr::memory_resource* memory)
      : patch(memory),
        labels(memory),
        areas(memory),
        euler(memory),
        valence(memory),
        loop_patch(memory),
        loop_begin(memory),
        loop_half_edges(memory),
        patch_loops(memory) {}

  std::size_t count() const { return labels.size(); }
  std::size_t loop_count() const { return loop_patch.size(); }
  std::span<const Index> loop(std::size_t i) const {
    return {loop_half_edges.data() + loop_begin[i], loop_begin[i + 1] - loop_begin[i]};
  }
  // Loops of a patch are numbered [patch_loops[c], patch_loops[c + 1]).
  std::size_t loops_of(std::size_t c) const { return patch_loops[c + 1] - patch_loops[c]; }
  bool has_handles(std::size_t c) const { return euler[c] + static_cast<int>(loops_of(c)) != 2; }
  bool is_corner(Index vertex) const { return valence[vertex] >= 3; }

  Array<Index> patch;       // of each triangle, numbered in the order of their first triangles
  Array<AxisLabel> labels;  // of each patch
  Array<double> areas;
  Array<int> euler;             // Euler characteristic of each patch, cut open where it touches itself
  Array<std::uint8_t> valence;  // of each vertex: edges at it that separate patches
  Array<Index> loop_patch;      // of each loop; in ascending order
  Array<Index> loop_begin;
  Array<Index> loop_half_edges;  // of the patch's own triangles, in their direction
  Array<Index> patch_loops;
};

Patches find_patches(const Surface& surface, std::span<const AxisLabel> labels, const base::Host& host);

// How often the neighboring patch changes along a loop.
std::size_t corners_of_loop(const Surface& surface, const Patches& patches, std::size_t loop);

struct LabelFaults {
  std::size_t high_valence = 0;    // vertices where four patches or more meet
  std::size_t opposite_edges = 0;  // edges between patches that look opposite ways
  std::size_t short_loops = 0;     // with fewer than four corners
  std::size_t handles = 0;         // patches with handles
  std::size_t missing = 0;         // 1 when there are fewer than six patches
  std::size_t corners = 0;         // no fault

  std::size_t total() const { return high_valence + opposite_edges + short_loops + handles + missing; }
};

LabelFaults find_faults(const Surface& surface, const Patches& patches);

}  // namespace orbicube::polycube
