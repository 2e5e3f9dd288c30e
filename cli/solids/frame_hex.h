// orbicube hex --method frames: hexahedra that follow a frame field.
#pragma once

#include <string>

#include "report/hex_output.h"
#include "solids/polycube_solid.h"
#include "volume_map/frames/frame_hexes.h"

namespace orbicube::cli {

struct FrameHexVerb {
  PolycubeSolidOptions solid;
  std::string output;  // what failures are about
  std::string frames;  // a file of them, or empty
  std::size_t cells = 10000;
  double distance = 1;  // percent
  std::size_t max_cells = 100'000;
  double feature_angle = 0;  // degrees
  std::size_t max_fields = volume_map::FrameHexOptions{}.max_fields;
};

HexOutcome hexahedra_along_frames(const FrameHexVerb& verb, Session& session);

}  // namespace orbicube::cli
