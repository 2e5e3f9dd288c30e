// Reads the surface that a glTF 2.0 file shows: GLB, or .gltf with buffers inside or beside it. All triangles of all
// meshes of the scene become one mesh in world coordinates.
//
// Read are triangles, strips and fans with or without indices of any size, strided, sparse and quantised accessors
// (KHR_mesh_quantization), node transforms and the weights that morph targets have by default. Points, lines and nodes
// of scale 0 are left out; normals, materials, skins and the like can be kept beside the surface (kept.h), else a note
// counts them. Draco compression is refused. Source: the glTF 2.0 specification (Khronos, 2021).
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "base/host.h"
#include "gltf/kept/kept.h"
#include "mesh/files/read.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

struct ReadOptions {
  // Welds vertices at identical positions: always where triangles have no indices, and otherwise when the surface is
  // not closed as it stands (exporters split vertices along seams of normals and texture coordinates). Without it,
  // vertices and their order are those of the file.
  bool weld_identical = true;
  // Name of a morph target (mesh.extras.targetNames) that is applied in full: positions are base + delta, added as
  // doubles, whatever weights the file gives. Empty: the surface as it is shown.
  std::string morph_target;
};

// The surface in the file at `path`, whose buffers may lie in its own folder. Vertices used by no triangle are kept.
// `report` may be null.
// Throws Error with the kinds of Asset, read_vectors, read_indices and place_meshes, and: "missing-attribute" for
// primitives without positions, or without the morph target; "unsupported-mode" when there is nothing but points and
// lines; "empty-mesh" without triangles; "unsupported" for more vertices than 2^32 - 2, or for repeated use of the same
// data beyond any measure; "io"; "cancelled". O(size of the file and of the mesh) time; memory is bounded by a multiple
// of the file's size.
mesh::Mesh read(const std::filesystem::path& path, const ReadOptions& options, const base::Host& host,
                mesh::ReadReport* report = nullptr);

// The same from bytes of either container; without `folder`, external buffers are refused with "unsupported-uri".
mesh::Mesh read(std::span<const std::byte> bytes, const std::optional<std::filesystem::path>& folder,
                const ReadOptions& options, const base::Host& host, mesh::ReadReport* report = nullptr);

// The same, and keeps everything else in the file for a file that is written. Where the document does not allow that,
// `kept` becomes null, and a note gives the reason. What is kept has no note: Kept::decoration has its text. With null
// for `kept`, nothing is kept.
mesh::Mesh read(const std::filesystem::path& path, const ReadOptions& options, const base::Host& host,
                mesh::ReadReport* report, std::unique_ptr<Kept>* kept);
mesh::Mesh read(std::span<const std::byte> bytes, const std::optional<std::filesystem::path>& folder,
                const ReadOptions& options, const base::Host& host, mesh::ReadReport* report,
                std::unique_ptr<Kept>* kept);

}  // namespace orbicube::gltf
