// What orbicube hex leaves behind, whatever the hexahedra follow: the mesh, a scene, figures and what is said of them.
#pragma once

#include <string>

#include "hexmesh/hexmesh.h"
#include "scenes/hex_scene.h"
#include "session/session.h"

namespace orbicube::cli {

struct HexOutput {
  std::string path;
  bool text = false;          // rather than binary VTK
  bool keep_partial = false;  // write also what is too far from the surface
  bool strict = false;        // no result where features are missing
  std::string glb;            // to draw it in, or empty
  Cut cut = Cut::quarter;
};

// Throws Failure where one of the files could not be written, by its name.
void require_hex_output(const HexOutput& output);

// `asked` is the distance that was, in percent. Where triangles or cells of the input have regions, quadrilaterals of
// the boundary or hexahedra get those of the nearest.
void write_hexahedra(const HexOutput& output, const mesh::Mesh& input, hexmesh::Hexahedra made, double asked,
                     Session& session);

}  // namespace orbicube::cli
