// Writes one surface as glTF 2.0 for engines and viewers: GLB, or JSON with its buffer inside as base64. With morph
// targets, texture coordinate and texture, colors and edges where they are given.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "base/array.h"
#include "base/host.h"
#include "gltf/writing/form.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

// Another shape of the same surface. Its name goes to mesh.extras.targetNames, where engines look for it.
struct MorphTarget {
  std::string name;
  std::span<const float>
      positions;  // three a vertex: where the vertices are, not deltas; stored by delta_for (morph.h)
};

struct Kept;

// Where a triangle of a scene lies on a surface that was read: it takes the material of the triangle in which its
// middle lies, and the texture coordinates and so on of where its corners lie.
struct KeptTriangle {
  struct Corner {
    mesh::Index triangle;           // in which the corner lies
    std::array<double, 3> weights;  // of that triangle's corners; sum up to 1
    std::array<double, 3> nearest;  // the same for the nearest place on the middle's triangle, for use at a seam
  };
  mesh::Index middle;
  std::array<Corner, 3> corners;
};

// What to write. Spans are views that must live during the call; those that may be left out are empty then.
struct Scene {
  std::span<const float> positions;            // three a vertex; stored bit for bit
  std::span<const mesh::Triangle> triangles;   // counter-clockwise seen from outside
  std::span<const float> normals;              // three a vertex, unit; may be left out
  bool smooth_normals = false;                 // makes normals (normals.h) when none are given
  std::span<const float> texture_coordinates;  // two a vertex; may be left out. v goes down, as glTF has it
  std::span<const float> tangents;             // four a vertex (tangents.h); may be left out; need normals
  std::span<const std::uint8_t> colors;        // four a vertex: linear red, green, blue, opacity; may be left out
  std::span<const MorphTarget> morph_targets;  // may be left out
  bool morph_normals = false;                  // smooth normals for morph targets too; needs normals
  double morph_seconds = 0;  // above 0: an animation from the surface to each target in turn and back to it, this
                             // number of seconds from one to the next; needs targets
  std::span<const std::array<mesh::Index, 2>> edges;   // drawn as dark lines; may be left out
  mesh::Vector3 translation = mesh::Vector3::Zero();   // of the node: world = translation + scale * position
  double scale = 1;                                    // of the node; positive
  std::array<double, 4> base_color{0.8, 0.8, 0.8, 1};  // of the material: linear, 0 to 1; multiplies colors and texture
  std::span<const std::byte> texture;                  // a PNG file (checker.h makes one); needs texture coordinates
  std::string name = "surface";                        // of the node and the mesh
  std::string extras;                                  // a JSON object, for the scene; may be left out
  // The surface is written with what was kept of the file that it is from (kept.h); may be null. Triangles are those of
  // the surface then, which may have been turned, and normals, tangents, colors, edges and extras are left out. Normals
  // that were kept are written, and materials. Parts without texture coordinates or a material get those of the scene.
  const Kept* kept = nullptr;
  // For other triangles than those of the surface: its own triangles, and one element a triangle of the scene.
  std::span<const mesh::Triangle> kept_surface;
  std::span<const KeptTriangle> kept_triangles;
};

// Writes to `path`, .gltf when it ends so and GLB otherwise, whole or not at all (mesh/files/file.h).
// Throws Error: "invalid-argument" when sizes, indices or texts do not fit or numbers are not finite; "unsupported" for
// a GLB of 4 GiB or more; "io"; "cancelled". O(n) time, memory for what is derived (deltas, normals, 16-bit indices).
void write(const std::filesystem::path& path, const Scene& scene, const base::Host& host);

// Writes a file again that was read, with all that it has: images and buffers in other files come into this one. Throws
// Error "unsupported", "io", "cancelled".
void write(const std::filesystem::path& path, const Kept& kept, const base::Host& host);

// The same as bytes in memory.
base::Array<std::byte> to_bytes(const Scene& scene, Form form, const base::Host& host);
base::Array<std::byte> to_bytes(const Kept& kept, Form form, const base::Host& host);

}  // namespace orbicube::gltf
