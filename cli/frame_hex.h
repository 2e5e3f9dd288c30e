// orbicube hex --method frames: hexahedra that follow a frame field.
#pragma once

#include <string>

#include "hex_scene.h"
#include "polycube_solid.h"

namespace orbicube::cli {

struct FrameHexVerb {
  PolycubeSolidOptions solid;
  std::string output;
  std::string frames;  // a file of them, or empty
  std::size_t cells = 10000;
  double features = 0;  // degrees
  std::string glb;      // to draw it in, or empty
  Cut cut = Cut::quarter;
  bool text = false;
};

void run_frame_hex(const FrameHexVerb& verb, Session& session);

}  // namespace orbicube::cli
