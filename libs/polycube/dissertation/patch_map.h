// The map of a surface to a polycube, patch by patch (the dissertation's section 4.2.2): paths by arc length to the
// edges of rectangles, and harmonic functions between them.
//
// With weights that are not all positive a patch may fold over: triangles that do are counted.
#pragma once

#include <array>

#include "polycube/dissertation/corner_paths.h"
#include "polycube/dissertation/harmonic_system.h"

namespace orbicube::polycube::dissertation {

// Of one rectangle: H of eq. 4.2 along each axis, and A of eq. 4.3.
struct PatchEnergy {
  std::array<double, 3> harmonic{};
  double stretch = 0;
  // The parts of the sum of `harmonic` from edges of positive and of negative weight: harmonic = positive - negative.
  double positive = 0, negative = 0;
};

struct PatchMap {
  explicit PatchMap(std::pmr::memory_resource* memory) : polycube(memory), energy(memory) {}

  // E of eq. 4.4.
  double total(double area_weight) const;

  Array<Vector3> polycube;    // of each vertex of the surface
  Array<PatchEnergy> energy;  // of each rectangle
  std::size_t flipped = 0;    // triangles without positive area; those of three boundary vertices are not counted
  Index first_flipped = no_index;
};

// Energies of the triangles of a map as it is.
void measure_patches(const Layout& layout, const EditableSurface& surface, const Drawn& drawn,
                     std::span<const double> weights, std::span<const std::uint8_t> fixed, PatchMap& map);

// Flags of the vertices on the paths.
Array<std::uint8_t> boundary_flags(const EditableSurface& surface, const Drawn& drawn, const base::Host& host);

// `drawn` must be valid, `weights` those of the surface, of which `system` is. Throws Error "no-valid-result" where the
// harmonic equations cannot be solved, "cancelled".
PatchMap map_patches(const Layout& layout, const EditableSurface& surface, const Drawn& drawn,
                     std::span<const double> weights, HarmonicSystem& system, const base::Host& host);

// The map as it leaves the library. Edges between two vertices of paths are split at their middles first, whose
// triangles could be without area, and `flipped` counts all triangles of the result. Not certified.
struct FinishedMap {
  explicit FinishedMap(std::pmr::memory_resource* memory) : map(memory) {}
  SurfaceMap map;
  std::size_t flipped = 0;
  std::string first;  // where the first is
};
FinishedMap finish_map(const Layout& layout, const EditableSurface& surface, const Drawn& drawn,
                       const base::Host& host);

}  // namespace orbicube::polycube::dissertation
