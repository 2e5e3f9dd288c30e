// Shapes that become each other through one polycube.
#pragma once

#include <string>
#include <vector>

#include "morphs/morph_states.h"
#include "session/session.h"
#include "solids/repaired_surface.h"

namespace orbicube::cli {

struct PolycubeMorphOptions {
  std::vector<std::string> inputs;
  std::string output;
  std::string landmarks;
  std::string grid;   // "first", or "cells:N" for quads of the polycube's grid; "both" for as many as fit the shapes
  std::string place;  // kept, turned or scaled (morph_placement.h)
  std::size_t corners = 0;
  std::size_t steps = 0;
  double seconds = 2;
  Mending mending;
  ShapeBlend blend;            // written in place of the morph, where it has weights
  bool show_polycube = false;  // it becomes a target, after the first shape
};

// Of any genus, the same for all. Throws Failure.
void morph_by_polycube(const PolycubeMorphOptions& options, Session& session);

}  // namespace orbicube::cli
