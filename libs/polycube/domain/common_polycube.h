// One polycube for several shapes (the dissertation's section 4.5): that of one of them, drawn on the others, with the
// proportions and the maps that minimize the sum of all energies. Maps between the shapes are compositions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polycube/domain/common_improvement.h"
#include "polycube/domain/registration.h"
#include "polycube/map/construction.h"
#include "polycube/outputs/patch_graph.h"

namespace orbicube::polycube {

// A polycube that all shapes are to be mapped to.
struct CommonTarget {
  const PatchGraph* graph = nullptr;  // null: it is constructed
  std::int64_t genus = 0;
  std::span<const Vector3> pose = {};  // of each corner, where it is on the shape of which it was made; or empty
};

struct CommonPolycubeOptions {
  ConstructionOptions construction = {};  // of each shape's own polycube
  DomainOptions domain = {};              // measure and weight of the energies
  // Points that belong together: of each shape as many, or none.
  std::span<const Array<Vector3>> landmarks = {};
  CommonTarget target = {};
  // Whether the polycube gets the best proportions; not set: if it is constructed.
  std::optional<bool> proportions = {};
  bool corners = false;  // whether corners move on the shapes (optimal_corners.h)
  CornerMethod corner_search = CornerMethod::trust_region;
};

struct CommonPolycube : CommonMaps {
  explicit CommonPolycube(std::pmr::memory_resource* memory)
      : CommonMaps(memory), graph(memory), own_energies(memory) {}

  std::size_t base = 0;  // the shape that the polycube was found for, or that it was drawn on first
  PatchGraph graph;      // of the map of the base
  std::int64_t genus = 0;
  Array<double> own_energies;  // of each shape with its own polycube, best proportions; NaN where it has none
  std::size_t tried = 0;       // polycubes that were drawn on all shapes, or broken off
};

// At least one shape; all closed, connected, oriented, of one genus. Each shape's own polycube is drawn on all others,
// and the one with the minimum sum is kept; a target is drawn on the first shape and follows that map on the others.
// Shapes that are copies of others (shape_copies.h) get the same maps. Throws Error "wrong-genus", "no-valid-result"
// with what became of each polycube, "invalid-argument", "not-closed", "cancelled".
CommonPolycube construct_common(std::span<const SurfaceSpan> shapes, const CommonPolycubeOptions& options,
                                const base::Host& host);

}  // namespace orbicube::polycube
