// Shapes on one triangulation, as morph targets of one glTF mesh, and what lies between them as files.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "session.h"

namespace orbicube::cli {

struct MorphStates {
  std::string output;              // .glb or .gltf
  std::vector<std::string> names;  // of the shapes
  std::span<const mesh::Triangle> triangles;
  std::span<const base::Array<mesh::Vector3>> states;  // positions of each shape
  double seconds = 2;                                  // of the animation, from one to the next
  std::size_t steps = 0;                               // so many shapes between each two as well, to OUT-01 and so on
};

// Writes them, and adds "steps" to the session's figures. Throws Failure.
void write_morph(const MorphStates& morph, Session& session);

}  // namespace orbicube::cli
