// The colors that a glTF file gives its surface: base color factors and textures of its materials, and vertex colors
// (glTF 2.0 specification, 3.9). Images stay as they are stored; what decodes them is the caller's.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/array.h"
#include "base/host.h"
#include "gltf/kept/kept.h"

namespace orbicube::gltf {

// What a coordinate beyond 0 to 1 shows.
enum class Wrap { repeat, mirror, clamp };

struct ColorMaterial {
  std::array<double, 3> factor{1, 1, 1};  // linear red, green, blue
  std::span<const std::byte> image;       // as stored; empty: none. Lives as long as what was kept
  std::array<Wrap, 2> wrap{Wrap::repeat, Wrap::repeat};
};

struct SurfaceColors {
  explicit SurfaceColors(std::pmr::memory_resource* memory)
      : triangle_materials(memory), coordinates(memory), vertex_colors(memory) {}

  std::vector<ColorMaterial> materials;
  // Of each triangle of the surface that was read, and of each of its corners.
  base::Array<std::uint32_t> triangle_materials;
  base::Array<std::array<std::array<double, 2>, 3>> coordinates;    // of the texture, v down; 0 where there are none
  base::Array<std::array<std::array<double, 3>, 3>> vertex_colors;  // linear, 1 where there are none
};

// Throws Error of the kinds of read_elements and Asset::view, "cancelled". O(size of the file).
SurfaceColors surface_colors(const Kept& kept, const base::Host& host);

}  // namespace orbicube::gltf
