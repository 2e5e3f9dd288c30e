// One polycube for several shapes (the dissertation's section 4.5): that of one of them, drawn on the others, with the
// proportions and the maps that minimize the sum of all energies. Maps between the shapes are compositions.
#pragma once

#include <string>
#include <vector>

#include "polycube/domain/common_domain.h"
#include "polycube/domain/registration.h"
#include "polycube/map/construction.h"
#include "polycube/outputs/patch_graph.h"

namespace orbicube::polycube {

struct CommonPolycubeOptions {
  ConstructionOptions construction = {};  // of each shape's own polycube
  DomainOptions domain = {};              // measure and weight of the energies
  // Points that belong together: of each shape as many, or none.
  std::span<const Array<Vector3>> landmarks = {};
};

struct CommonPolycube {
  explicit CommonPolycube(std::pmr::memory_resource* memory) : graph(memory), energies(memory), own_energies(memory) {}

  std::size_t base = 0;  // the shape that the polycube was found for
  PatchGraph graph;      // of the map of the base
  std::int64_t genus = 0;
  std::vector<SurfaceMap> maps;           // of each shape, to one polycube
  std::vector<Certificate> certificates;  // of each, valid
  std::vector<Distortion> distortions;
  Array<double> energies;      // sums: as drawn, then after each improvement; never rises
  Array<double> own_energies;  // of each shape with its own polycube, best proportions; NaN where it has none
  std::size_t tried = 0;       // polycubes that were drawn on all shapes, or broken off
};

// At least one shape; all closed, connected, oriented, of one genus. Each shape's own polycube is drawn on all others,
// and the one with the minimum sum is kept. Throws Error "wrong-genus", "no-valid-result" with what became of each
// polycube, "invalid-argument", "not-closed", "cancelled".
CommonPolycube construct_common(std::span<const SurfaceSpan> shapes, const CommonPolycubeOptions& options,
                                const base::Host& host);

}  // namespace orbicube::polycube
