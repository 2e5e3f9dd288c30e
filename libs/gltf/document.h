// The JSON of a written glTF file: what its one buffer holds and how it is shown.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gltf/binary_buffer.h"
#include "gltf/parts.h"
#include "gltf/write.h"

namespace orbicube::gltf {

// Numbers of accessors of a morph target.
struct TargetAccessors {
  std::uint64_t position;
  std::optional<std::uint64_t> normal;
};

// Numbers of accessors, and of the texture's view, in the buffer.
struct SceneAccessors {
  std::uint64_t position = 0, triangles = 0;
  std::optional<std::uint64_t> normal, texture_coordinate, color, edges, texture_view, animation_times,
      animation_weights;
  std::vector<TargetAccessors> targets;
};

// The text, without spaces and line ends. The one buffer is the last thing in it; with `uri` it ends in `"}]}`, behind
// which nothing but the characters of the uri are missing. Throws Error "invalid-argument" when the extras are no JSON
// object or a text is not UTF-8.
std::string document_text(const Scene& scene, const SceneAccessors& accessors, const BinaryBuffer& buffer,
                          const std::optional<std::string>& uri, const base::Host& host);

// Numbers of accessors of a part.
struct PartAccessors {
  std::uint64_t position, normal, triangles;
  std::optional<std::uint64_t> color;
};

// The same for parts, a node, a mesh and a material each.
std::string document_text(std::span<const Part> parts, std::span<const PartAccessors> accessors,
                          const BinaryBuffer& buffer, const std::optional<std::string>& uri, const base::Host& host);

}  // namespace orbicube::gltf
