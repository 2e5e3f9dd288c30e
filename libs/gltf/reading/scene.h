// The node graph of an asset: which meshes stand where (glTF 2.0 specification, 3.5).
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>

#include "base/array.h"
#include "gltf/json/asset.h"

namespace orbicube::gltf {

// A mesh of the document, placed.
struct Placement {
  std::size_t mesh;
  std::size_t node;  // no_node where the document has none
  Eigen::Affine3d to_world;
  bool mirrored;  // by the transform
  bool skinned;   // its node's transform does not count: joints would place it
};

inline constexpr std::size_t no_node = SIZE_MAX;

struct Placements {
  base::Array<Placement> shown;
  std::size_t hidden;        // meshes of nodes of scale 0 on all axes, which glTF hides so
  std::size_t first_hidden;  // the first such node
};

// The meshes of the scene that the file names (else its first, else all nodes, else all meshes as they are), in the
// order of the nodes. Without recursion, so a chain of nodes may be of any length. Throws Error: "index-range" for a
// scene, node or mesh that does not exist; "parse" for a node that is reached twice (a cycle, or two parents) and for
// transforms that are none; "degenerate-geometry" for a transform that flattens its mesh, but not to a point;
// "non-finite" when transforms multiply beyond the range of doubles.
Placements place_meshes(const Asset& asset);

}  // namespace orbicube::gltf
