// Textures of an atlas, computed texel by texel.
#pragma once

#include <filesystem>
#include <span>

#include "polycube/outputs/atlas_texels.h"
#include "session/session.h"

namespace orbicube::cli {

// What is textured.
struct AtlasOfMap {
  const polycube::SurfaceMap& map;
  std::span<const polycube::TexelCorners> corners;
  const polycube::AtlasTexels& texels;
};

// A PNG file with squares along the axes of the polycube, of this edge from this corner.
base::Array<std::byte> checker_of_atlas(const AtlasOfMap& of, const mesh::Vector3& low, double square,
                                        const base::Host& host);

// Throws Failure "unsupported" unless a file may have colors: glTF.
void require_colored(const std::filesystem::path& input);

// A PNG file with the colors that a glTF file has at the nearest place of its surface: of materials, their textures
// (PNG and JPEG) and vertices. Throws Failure "unsupported" where they cannot be read; errors of reading.
base::Array<std::byte> colors_of_input(const AtlasOfMap& of, const std::filesystem::path& input,
                                       const base::Host& host);

}  // namespace orbicube::cli
