// A frame field to look at: singular curves as tubes colored by class within the transparent surface, marks where no
// hexahedral mesh could follow, and some of the frames as crosses.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "base/host.h"
#include "frame_field/singularities/meshability.h"
#include "frame_field/singularities/singularities.h"
#include "mesh/mesh.h"
#include "mesh/topology/tetrahedral_connectivity.h"

namespace orbicube::cli {

struct FieldView {
  const mesh::Mesh& solid;
  const mesh::TetrahedralConnectivity& connectivity;
  std::span<const quaternion::Quaternion> field;  // by tetrahedron
  const frame_field::SingularGraph& graph;
  const frame_field::Meshability& meshability;
};

// Writes glTF (.gltf, or GLB) with a part for each kind of thing, named after it: "surface", "threes", "fives",
// "half turns", "third turns", "diagonal half turns", "nodes", "not meshable", "frames"; kinds of which there is
// nothing are left out. `crosses` is about the number of frames that are shown, evenly over the solid. Throws what
// gltf::write_parts throws. O(n log n).
void write_scene(const std::filesystem::path& path, const FieldView& view, std::size_t crosses, const base::Host& host);

}  // namespace orbicube::cli
