// What `orbicube polycube` writes besides the map: the polycube by itself, a mesh of quads, glTF and a page to look at.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

#include "polycube/map/certificate.h"
#include "polycube/outputs/atlas.h"
#include "polycube/surface/distortion.h"
#include "polycube/surface/surface_map.h"
#include "session/session.h"

namespace orbicube::cli {

struct PolycubeOutputs {
  std::string domain, quads, glb, atlas, page;  // files, or empty
  std::size_t cells = 10000;
  double cell_size = 0;  // of cells; 0: by their number
  polycube::AtlasOptions atlas_options;
  bool texture = false;  // the atlas has the colors of the input
};

void add_polycube_outputs(CLI::App& verb, PolycubeOutputs& outputs);

// Throws Failure when a file cannot be written: before long work, not after it. Adds to the session's options.
void check_polycube_outputs(const PolycubeOutputs& outputs, Session& session);

// A certified map, and where it comes from.
struct PolycubeResult {
  std::string input;
  const polycube::SurfaceMap& map;
  std::int64_t genus;
  std::size_t corners, patches;
  const polycube::Distortion& distortion;
  std::span<const double> energies;  // of an optimization; may be empty
};

Json distortion_figures(const polycube::Distortion& d);

// Writes what is requested. Figures go to `figures`, text to the session.
void write_polycube_outputs(const PolycubeOutputs& outputs, const PolycubeResult& result, Json& figures,
                            Session& session);

}  // namespace orbicube::cli
