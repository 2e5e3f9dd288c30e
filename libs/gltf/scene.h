// The node graph of an asset: which meshes stand where (glTF 2.0 specification, 3.5).
#pragma once

#include <Eigen/Geometry>

#include "base/array.h"
#include "gltf/asset.h"

namespace orbicube::gltf {

// A mesh of the document, placed.
struct Placement {
  JsonValue mesh;
  Eigen::Affine3d to_world;
  bool mirrored;  // by the transform
  bool skinned;   // its node's transform does not count: joints would place it
};

// The meshes of the scene that the file names (else its first, else all nodes, else all meshes as they are), in the
// order of the nodes. Without recursion, so a chain of nodes may be of any length. Throws Error: "index-range" for a
// scene, node or mesh that does not exist; "parse" for a node that is reached twice (a cycle, or two parents) and for
// transforms that are none; "degenerate-geometry" for a transform that flattens its mesh; "non-finite" when transforms
// multiply beyond the range of doubles.
base::Array<Placement> place_meshes(const Asset& asset);

}  // namespace orbicube::gltf
