// Writes several meshes as one glTF scene: a transparent surface with colored tubes inside, say. Each part has a name,
// a node, a mesh and a material of its own.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "base/array.h"
#include "base/host.h"
#include "gltf/writing/write.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

// Spans are views that must live during the call.
struct Part {
  std::string name;                           // of node, mesh and material; UTF-8
  std::span<const mesh::Vector3> positions;   // stored as the nearest floats
  std::span<const mesh::Triangle> triangles;  // counter-clockwise seen from outside; drawn from both sides
  std::span<const std::uint8_t> colors{};     // four a vertex: linear red, green, blue, opacity; may be left out
  std::array<double, 4> color{0.8, 0.8, 0.8,
                              1};  // linear, 0 to 1; multiplies `colors`; transparent below 1 in the last
  mesh::Vector3 translation = mesh::Vector3::Zero();  // of the node: world = translation + scale * position
  double scale = 1;                                   // of the node; positive
  bool flat = false;  // each triangle with its own normal (and corners, of which there are then three a triangle)
};

// Writes to `path`, .gltf when it ends so and GLB otherwise, whole or not at all. Viewers draw transparent parts in the
// order that they like; opaque ones inside are seen through them. Throws Error: "invalid-argument" when there is no
// part or one without triangles, or sizes, indices, colors or names do not fit or positions are not finite as floats;
// "unsupported" for a GLB of 4 GiB or more; "io"; "cancelled". O(n).
void write_parts(const std::filesystem::path& path, std::span<const Part> parts, const base::Host& host);

// The same as bytes in memory.
base::Array<std::byte> parts_to_bytes(std::span<const Part> parts, Form form, const base::Host& host);

}  // namespace orbicube::gltf
