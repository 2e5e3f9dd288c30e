// A surface and its sphere map as glTF: the sphere is a morph target of the surface, in float32, valid as it is stored.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "base/host.h"
#include "gltf/kept/kept.h"
#include "mesh/mesh.h"

namespace orbicube::cli {

struct MorphSphere {
  explicit MorphSphere(std::pmr::memory_resource* memory) : base(memory), sphere(memory), directions(memory) {}

  base::Array<float> base;    // the surface: world = translation + scale * base
  base::Array<float> sphere;  // what base + delta is in float32
  mesh::Vector3 translation = mesh::Vector3::Zero();
  double scale = 1;
  base::Array<mesh::Vector3> directions;  // base + delta as doubles
  std::size_t moved = 0;                  // vertices moved by more than rounding, to keep all triangles positive
};

// Rounds the map so that every triangle is positive, exactly, whether base and delta are added in float32 or as
// doubles, and within 1e-6 of the sphere. The base is the surface's own coordinates in float32, divided by a power of
// two where they are beyond 4; otherwise, where that loses something to speak of, they are taken relative to the
// bounding box, which leaves more digits for both. Throws Error "no-valid-result" when float32 cannot hold the map,
// "unsupported" when it ends before the size of the surface.
MorphSphere round_to_morph_target(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                                  std::span<const mesh::Vector3> directions, const base::Host& host);

// Writes surface, normals, the morph target "sphere" and a texture coordinate with a checker texture: the octahedral
// map of the direction with the lower hemisphere folded onto the upper, so that there is no seam anywhere. With what
// was `kept` of the surface's file, which may be null, its own materials and texture coordinates.
void write_morph_sphere(const std::filesystem::path& path, const MorphSphere& map,
                        std::span<const mesh::Triangle> triangles, const std::string& name, const gltf::Kept* kept,
                        const base::Host& host);

// Reads the file again, all corners of its triangles in their order. Throws Error "no-valid-result" unless it holds
// this surface and target, every triangle of the target positive.
void check_morph_sphere(const std::filesystem::path& path, const MorphSphere& map,
                        std::span<const mesh::Triangle> triangles, const base::Host& host);

}  // namespace orbicube::cli
