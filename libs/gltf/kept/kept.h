// What a glTF file holds besides the positions and triangles of its surface, kept so that the surface can be written
// with it again: materials, textures, texture coordinates, colors, nodes, skins, animations, extras.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/array.h"
#include "base/host.h"
#include "gltf/json/asset.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

class BinaryBuffer;
struct Scene;

// A primitive of the document, as a node of the scene shows it.
struct KeptPrimitive {
  std::size_t mesh, primitive;
  std::size_t node;  // no_node (scene.h) where the document has none
  Eigen::Affine3d to_world;
  bool mirrored, skinned;
  mesh::Index first_vertex;  // of Kept::surface_vertex
  std::size_t vertex_count;
  std::size_t first_triangle, triangle_count;  // of Kept::triangles
};

// Made by `read` (read.h). The host that it was given must stay valid.
struct Kept {
  Kept(base::Array<std::byte> bytes, std::optional<std::filesystem::path> folder, const base::Host& host);

  base::Array<std::byte> file;
  // Reads bytes of buffers when they are written.
  mutable Asset asset;
  base::Array<KeptPrimitive> primitives;
  // The surface before its vertices were welded: the i-th triangle is the i-th of the surface, its corners are vertices
  // of the primitives, and surface_vertex gives the vertex of the surface for each of these.
  base::Array<mesh::Triangle> triangles;
  base::Array<mesh::Index> surface_vertex;
  // Notes of what is left out where nothing of this is used, and where the surface is written with it: "left out: 1
  // material". May be empty.
  std::string decoration, replaced;
  // add_kept_scene (kept_writer.h). A pointer, so that programs which keep nothing do not link it.
  tiny::Model (*add_scene)(BinaryBuffer& buffer, const Scene& scene, const base::Host& host);
};

// Takes the corners of a surface that was read but not welded.
void keep_corners(Kept& kept, const mesh::Mesh& surface);

// Does to these what mesh::weld is going to do to the surface.
void weld_corners(Kept& kept, const mesh::Mesh& surface, const base::Host& host);

// Throws Error unless everything that a written file refers to is there: each buffer view lies in its buffer, each
// accessor in its buffer views, each index within its array. The kinds of Asset::view, and "index-range".
void check_kept(const Kept& kept);

}  // namespace orbicube::gltf
