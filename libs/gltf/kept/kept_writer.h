// Writes a surface with what was kept of the file that it was read from.
#pragma once

#include "gltf/json/model.h"
#include "gltf/kept/kept.h"
#include "gltf/writing/binary_buffer.h"
#include "gltf/writing/write.h"

namespace orbicube::gltf {

// Adds the scene to the buffer and returns its model: the nodes, materials, textures, skins, cameras, lights,
// animations and extras that were kept, with the scene's positions and morph targets in the place of their meshes. Each
// shown mesh stays with its node where the node's transform does not count (skins) or may be replaced, and gets a node
// of its own otherwise. Throws Error "invalid-argument" when the scene is not of that surface, and the kinds of
// read_elements.
tiny::Model add_kept_scene(BinaryBuffer& buffer, const Scene& scene, const base::Host& host);

// Adds everything in the file to the buffer, as it was, and returns its model: images and buffers in other files come
// in.
tiny::Model add_kept_file(BinaryBuffer& buffer, const Kept& kept);

}  // namespace orbicube::gltf
